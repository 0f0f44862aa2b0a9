#include "number/trigonometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina::number {
namespace {

TEST(SineOfDegreesTest, IsExactAtMultiplesOfThirty) {
  const std::vector<double> expected{0, 0.5, 0.8660254037844386, 1, 0.8660254037844386, 0.5, 0};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Rational degrees = 30 * k;
    EXPECT_EQ(sine_of_degrees(degrees), expected[k]) << degrees;
    EXPECT_EQ(sine_of_degrees(-degrees), -expected[k]) << degrees;
    EXPECT_EQ(sine_of_degrees(degrees + 720), expected[k]) << degrees;
  }
}

TEST(SineOfDegreesTest, IsSymmetric) {
  for (int k = 1; k < 97; ++k) {
    const Rational degrees = Rational(360 * k) / 97;
    EXPECT_EQ(sine_of_degrees(180 - degrees), sine_of_degrees(degrees)) << degrees;
    EXPECT_EQ(sine_of_degrees(-degrees), -sine_of_degrees(degrees)) << degrees;
    EXPECT_EQ(sine_of_degrees(degrees - 3600), sine_of_degrees(degrees)) << degrees;
  }
}

TEST(SineOfDegreesTest, KeepsTinyAngles) {
  EXPECT_EQ(sine_of_degrees(Rational(1) / pow(Integer(10), 300)), 1.7453292519943295e-302);
}

TEST(TangentOfDegreesTest, IsExactWhereTheTrueValueIs) {
  EXPECT_EQ(tangent_of_degrees_over_root(0, 7), 0.0);
  EXPECT_EQ(tangent_of_degrees_over_root(45, 1), 1.0);
  EXPECT_EQ(tangent_of_degrees_over_root(-45, 4), -0.5);
  EXPECT_EQ(tangent_of_degrees_over_root(60, 3), 1.0);
  EXPECT_EQ(tangent_of_degrees_over_root(30, Rational(1) / 3), 1.0);
}

TEST(TangentOfDegreesTest, IsAccurateNearNinety) {
  const Rational tiny = Rational(1) / pow(Integer(10), 40);
  // tan(90 - x) = 1 / tan(x), and tan(x) is x in radians to this accuracy.
  EXPECT_DOUBLE_EQ(tangent_of_degrees_over_root(90 - tiny, 1), 57.29577951308232e40);
  EXPECT_TRUE(
      std::isinf(tangent_of_degrees_over_root(90 - Rational(1) / pow(Integer(10), 400), 1)));
}

TEST(ReducedDegreesTest, IsInTheHalfOpenTurn) {
  EXPECT_EQ(reduced_degrees(180), 180);
  EXPECT_EQ(reduced_degrees(-180), 180);
  EXPECT_EQ(reduced_degrees(181), -179);
  EXPECT_EQ(reduced_degrees(360), 0);
  EXPECT_EQ(reduced_degrees(-540), 180);
  EXPECT_EQ(reduced_degrees(Rational(1441) / 2), Rational(1) / 2);
  EXPECT_EQ(reduced_degrees(Rational(pow(Integer(10), 3000)) * 360 - 1), -1);
}

}  // namespace
}  // namespace lamina::number
