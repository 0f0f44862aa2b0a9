#include "geometry/ray_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "support/print.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;

std::string error_of(const std::string& text, bool ray = true) {
  try {
    if (ray) {
      parse_ray(text);
    } else {
      parse_point(text);
    }
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

TEST(RayTextTest, ReadsDecimalsAndFractions) {
  const ExactRay ray = parse_ray("1/3 -0.25 1e2 0 -7/2 .5");
  EXPECT_EQ(ray.origin, (ExactPoint{Rational(1, 3), Rational(-1, 4), 100}));
  EXPECT_EQ(ray.direction, (ExactPoint{0, Rational(-7, 2), Rational(1, 2)}));
  EXPECT_EQ(parse_point("1/3 0 -2"), (ExactPoint{Rational(1, 3), 0, -2}));
}

TEST(RayTextTest, BlanksAndCommasSeparate) {
  const ExactPoint origin{1, 2, 3};
  const ExactPoint direction{0, 0, 1};
  for (const char* text :
       {"1,2,3,0,0,1", "1, 2, 3, 0, 0, 1", "  1 2\t3 ,0,, 0 1 ", "1 2 3 0 0 1\r"}) {
    const ExactRay ray = parse_ray(text);
    EXPECT_EQ(ray.origin, origin) << text;
    EXPECT_EQ(ray.direction, direction) << text;
  }
  EXPECT_EQ(parse_point("1,2,3"), origin);
}

TEST(RayTextTest, SaysWhatIsWrong) {
  EXPECT_NE(error_of("1 2 3 0 0").find("6 numbers, here are 5"), std::string::npos);
  EXPECT_NE(error_of("1 2 3 0 0 1 4").find("6 numbers, here are 7"), std::string::npos);
  EXPECT_NE(error_of("").find("here are 0"), std::string::npos);
  EXPECT_NE(error_of("1 2 3 0 0 0").find("not zero"), std::string::npos);
  EXPECT_NE(error_of("1 2 3 0 0 x").find("x"), std::string::npos);
  EXPECT_NE(error_of("1 2 3 0 0 1/0"), "");
  EXPECT_NE(error_of("1 2", false).find("3 numbers, here are 2"), std::string::npos);
  EXPECT_NE(error_of("1 2 nan", false), "");
  EXPECT_EQ(error_of("0 0 0", false), "");  // of a point nothing need be non-zero
}

TEST(RayTextTest, WritesWhatItReads) {
  EXPECT_EQ(to_text(parse_ray("0.5 1/3 -2 0 0 1")), "0.5 1/3 -2 0 0 1");
  for (std::uint64_t case_id = 0; case_id < 200; ++case_id) {
    base::SeededStream stream("geometry/ray_text", 1, case_id);
    const auto number = [&stream]() -> Rational {
      if (stream.chance(0.5)) {
        return Rational(stream.uniform(-1e3, 1e3) *
                        std::ldexp(1.0, static_cast<int>(stream.integer(-80, 40))));
      }
      return {stream.integer(-1'000'000, 1'000'000), stream.integer(1, 1'000'000)};
    };
    const ExactRay ray{{number(), number(), number()}, {number(), 1, number()}};
    const ExactRay again = parse_ray(to_text(ray));
    EXPECT_EQ(again.origin, ray.origin) << "case " << case_id;
    EXPECT_EQ(again.direction, ray.direction) << "case " << case_id;
  }
}

}  // namespace
}  // namespace lamina::geometry
