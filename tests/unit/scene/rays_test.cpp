#include "scene/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lamina::scene {
namespace {

using geometry::ExactPoint;
using number::Integer;
using number::Rational;
using Point = geometry::Vector3<double>;

// Significand bits of a dyadic number.
std::size_t bits_of(const Rational& value) {
  const Integer n = abs(numerator(value));
  const Integer d = denominator(value);
  EXPECT_EQ(msb(d), lsb(d)) << value << " is no binary fraction";
  return n == 0 ? 0 : msb(n) - lsb(n) + 1;
}

std::size_t bits_of(const geometry::ExactRay& ray) {
  std::size_t most = 0;
  for (const ExactPoint& p : {ray.origin, ray.direction}) {
    most = std::max({most, bits_of(p.x), bits_of(p.y), bits_of(p.z)});
  }
  return most;
}

// A wrong optimisation of two conversions side by side would leave some coordinates unrounded.
TEST(RaysTest, UniformRaysAreHeldByFloat) {
  base::SeededStream stream("rays-test", 1, 0);
  const Bounds box{{-1, 2, 3}, {4, Rational(5, 2), 7}};
  for (const geometry::ExactRay& ray : uniform_rays(box, 1000, stream)) {
    EXPECT_LE(bits_of(ray), 24u);
  }
}

TEST(RaysTest, AreHeldByWhatIsAskedFor) {
  base::SeededStream stream("rays-test", 1, 1);
  std::size_t most = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point origin = random_direction(stream);
    const Point target = random_direction(stream);
    EXPECT_LE(bits_of(ray_from(origin, target, Held::Float)), 24u);
    EXPECT_LE(bits_of(ray_through(target, 10, stream)), 24u);
    most = std::max(most, bits_of(ray_from(origin, target, Held::Double)));
  }
  EXPECT_EQ(most, 53u);
}

}  // namespace
}  // namespace lamina::scene
