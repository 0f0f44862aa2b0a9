#include "number/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"

namespace lamina::number {
namespace {

Rational power_of_two(int exponent) {
  const Rational magnitude = pow(Integer(2), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / magnitude) : magnitude;
}

TEST(ParseRationalTest, ReadsEverySpelling) {
  const Rational third = Rational(1) / 3;
  EXPECT_EQ(parse_rational("0"), 0);
  EXPECT_EQ(parse_rational("-12"), -12);
  EXPECT_EQ(parse_rational("+12"), 12);
  EXPECT_EQ(parse_rational("0.1"), Rational(1) / 10);
  EXPECT_EQ(parse_rational("-.5"), Rational(-1) / 2);
  EXPECT_EQ(parse_rational("5."), 5);
  EXPECT_EQ(parse_rational("010"), 10);
  EXPECT_EQ(parse_rational("00.010"), Rational(1) / 100);
  EXPECT_EQ(parse_rational("6.02e23"), Rational("602000000000000000000000"));
  EXPECT_EQ(parse_rational("25E-2"), Rational(1) / 4);
  EXPECT_EQ(parse_rational("1e+2"), 100);
  EXPECT_EQ(parse_rational("978/997"), Rational(978) / 997);
  EXPECT_EQ(parse_rational("-1.5/4.5"), -third);
  EXPECT_EQ(parse_rational("1e-10000") * parse_rational("1e10000"), 1);
  EXPECT_EQ(parse_rational("1e0000000000000000000001"), 10);
}

TEST(ParseRationalTest, RefusesWhatSpellsNoNumber) {
  for (const char* text :
       {"",      "-",       "+",    ".",   "1/",  "/2",      "1/0",      "1/0.0",
        "1//2",  "1/2/3",   "1/-2", "--1", "e5",  "1e",      "1e+",      "0x10",
        "1 ",    " 1",      "1,5",  "inf", "nan", "1e10001", "1e-10001", "1e99999999999999999999",
        "1.2.3", "\xC2\xBD"}) {
    EXPECT_THROW(parse_rational(text), base::InputError) << text;
  }
}

TEST(ParseRationalTest, ShortensTheTextInItsMessage) {
  try {
    parse_rational(std::string(10'000, 'x'));
    FAIL() << "read a number";
  } catch (const base::InputError& error) {
    EXPECT_LT(std::string(error.what()).size(), 300U);
  }
}

TEST(ToTextTest, IsTheShortestSpelling) {
  EXPECT_EQ(to_text(0), "0");
  EXPECT_EQ(to_text(-120), "-120");
  EXPECT_EQ(to_text(Rational(1) / 2), "0.5");
  EXPECT_EQ(to_text(Rational(-1) / 80), "-0.0125");
  EXPECT_EQ(to_text(Rational(123456) / 100), "1234.56");
  EXPECT_EQ(to_text(Rational(1) / 3), "1/3");
  EXPECT_EQ(to_text(Rational(-22) / 7), "-22/7");
}

TEST(ToTextTest, WritesAtMostThirtyDecimals) {
  const Rational thirty = Rational(1) / pow(Integer(10), 30);
  EXPECT_EQ(to_text(thirty), "0.000000000000000000000000000001");
  EXPECT_EQ(to_text(thirty / 10), "1/1" + std::string(31, '0'));
}

TEST(ToTextTest, ReadsBack) {
  for (std::uint64_t case_id = 0; case_id < 1000; ++case_id) {
    base::SeededStream stream("number/to_text", 1, case_id);
    const Rational value =
        Rational(stream.integer(-1'000'000, 1'000'000)) /
        (stream.chance(0.5) ? stream.integer(1, 5000) : std::int64_t{1} << stream.below(40));
    EXPECT_EQ(parse_rational(to_text(value)), value) << "case " << case_id;
  }
}

TEST(NearestDoubleTest, IsExactWhereADoubleIs) {
  for (const double value :
       {0.0, 1.0, -1.0, 0.1, 1e300, -1e-300, std::numeric_limits<double>::max(),
        std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min(),
        -std::numeric_limits<double>::denorm_min(), 0x1.8p-1073, 0x1.fffffffffffffp-1023}) {
    EXPECT_EQ(nearest_double(Rational(value)), value);
  }
}

TEST(NearestDoubleTest, RoundsTiesToEven) {
  const Rational half_ulp = power_of_two(-53);
  EXPECT_EQ(nearest_double(1 + half_ulp), 1.0);
  EXPECT_EQ(nearest_double(1 + 3 * half_ulp), 1.0 + 0x1p-51);
  EXPECT_EQ(nearest_double(-1 - half_ulp), -1.0);
  EXPECT_EQ(nearest_double(1 + half_ulp + power_of_two(-3000)), 1.0 + 0x1p-52);
  EXPECT_EQ(nearest_double(1 + half_ulp - power_of_two(-3000)), 1.0);
  EXPECT_EQ(nearest_double(2 - half_ulp), 2.0);  // carries into the next binade
}

TEST(NearestDoubleTest, RoundsSubnormalNumbersOnce) {
  const Rational smallest = power_of_two(-1074);
  EXPECT_EQ(nearest_double(smallest / 2), 0.0);
  EXPECT_EQ(nearest_double(smallest / 2 + power_of_two(-2000)), 0x1p-1074);
  EXPECT_EQ(nearest_double(3 * smallest / 2), 0x1p-1073);
  // Rounded to 53 bits first this would become a tie, and go down.
  EXPECT_EQ(nearest_double(5 * smallest / 2 + power_of_two(-1074 - 60)), 0x3p-1074);
  EXPECT_EQ(nearest_double(power_of_two(-1022) - smallest / 2), 0x1p-1022);
  EXPECT_EQ(nearest_double(power_of_two(-30'000)), 0.0);
  EXPECT_TRUE(std::signbit(nearest_double(-power_of_two(-30'000))));
}

TEST(NearestDoubleTest, OverflowsAtHalfAnUlpBeyondTheLargest) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Rational limit = power_of_two(1024) - power_of_two(970);
  EXPECT_EQ(nearest_double(limit), infinity);
  EXPECT_EQ(nearest_double(-limit), -infinity);
  EXPECT_EQ(nearest_double(limit - 1), std::numeric_limits<double>::max());
  EXPECT_EQ(nearest_double(power_of_two(30'000)), infinity);
}

TEST(NearestDoubleTest, AgreesWithDivisionInDouble) {
  for (std::uint64_t case_id = 0; case_id < 2000; ++case_id) {
    base::SeededStream stream("number/nearest_double", 1, case_id);
    const std::int64_t limit = std::int64_t{1} << (1 + stream.below(53));
    const std::int64_t dividend = stream.integer(-limit, limit);
    const std::int64_t divisor = stream.integer(1, limit);
    EXPECT_EQ(nearest_double(Rational(dividend) / divisor),
              static_cast<double>(dividend) / static_cast<double>(divisor))
        << dividend << " / " << divisor;
  }
}

}  // namespace
}  // namespace lamina::number
