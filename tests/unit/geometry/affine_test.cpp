#include "geometry/affine.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "support/print.hpp"

namespace lamina::geometry {

namespace {

using number::Rational;

Rational random_rational(base::SeededStream& stream) {
  return Rational(stream.integer(-50, 50)) / stream.integer(1, 20);
}

ExactPoint random_point(base::SeededStream& stream) {
  return {random_rational(stream), random_rational(stream), random_rational(stream)};
}

AffineMap random_map(base::SeededStream& stream) {
  AffineMap map;
  for (AffineMap::Row& row : map.rows) {
    for (Rational& entry : row) {
      entry = random_rational(stream);
    }
  }
  return map;
}

AffineMap transposed_linear(const AffineMap& map) {
  AffineMap result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.rows[i][k] = map.rows[k][i];
    }
  }
  return result;
}

void expect_rotation(const AffineMap& map) {
  EXPECT_EQ(compose(map, transposed_linear(map)), AffineMap{});
  EXPECT_EQ(determinant(map), 1);
}

const ExactPoint kX{1, 0, 0};
const ExactPoint kY{0, 1, 0};
const ExactPoint kZ{0, 0, 1};

TEST(AffineTest, ComposesFirstThenSecond) {
  base::SeededStream stream("geometry/compose", 1, 0);
  for (int i = 0; i < 50; ++i) {
    const AffineMap first = random_map(stream);
    const AffineMap second = random_map(stream);
    const ExactPoint point = random_point(stream);
    EXPECT_EQ(apply(compose(second, first), point), apply(second, apply(first, point)));
    EXPECT_EQ(apply_to_direction(first, point), apply(first, point) - apply(first, {0, 0, 0}));
    EXPECT_EQ(determinant(compose(second, first)),
              Rational(determinant(second) * determinant(first)));
  }
}

TEST(AffineTest, InverseUndoesTheMap) {
  base::SeededStream stream("geometry/inverse", 1, 0);
  for (int i = 0; i < 50; ++i) {
    const AffineMap map = random_map(stream);
    const std::optional<AffineMap> back = inverse(map);
    ASSERT_EQ(back.has_value(), determinant(map) != 0);
    if (back) {
      EXPECT_EQ(compose(*back, map), AffineMap{});
      EXPECT_EQ(compose(map, *back), AffineMap{});
    }
  }
}

TEST(AffineTest, ASingularMapHasNoInverse) {
  EXPECT_FALSE(inverse(scaling({1, 0, 1})));
  EXPECT_FALSE(inverse(AffineMap{
      {AffineMap::Row{1, 2, 3, 0}, AffineMap::Row{4, 5, 6, 0}, AffineMap::Row{7, 8, 9, 0}}}));
}

TEST(AffineTest, MovesAndScales) {
  EXPECT_EQ(apply(translation({1, 2, 3}), {10, 20, 30}), (ExactPoint{11, 22, 33}));
  EXPECT_EQ(apply_to_direction(translation({1, 2, 3}), kX), kX);
  EXPECT_EQ(apply(scaling({2, -3, Rational(1) / 4}), {1, 1, 1}),
            (ExactPoint{2, -3, Rational(1) / 4}));
}

TEST(AffineTest, ReflectsAtThePlaneOfTheNormal) {
  EXPECT_EQ(reflection(kZ), scaling({1, 1, -1}));
  const ExactPoint normal{3, -2, 5};
  const AffineMap map = reflection(normal);
  EXPECT_EQ(apply(map, normal), (ExactPoint{-3, 2, -5}));
  EXPECT_EQ(apply(map, {2, 3, 0}), (ExactPoint{2, 3, 0}));
  EXPECT_EQ(compose(map, map), AffineMap{});
  EXPECT_EQ(determinant(map), -1);
  EXPECT_THROW(reflection({0, 0, 0}), base::ContractError);
}

TEST(RotationTest, TurnsAsItsQuaternionSays) {
  EXPECT_EQ(rotation(1, {0, 0, 0}), AffineMap{});
  EXPECT_EQ(apply(rotation(1, kZ), kX), kY);  // 90 degrees about z, whatever the length
  EXPECT_EQ(rotation(5, {0, 0, 5}), rotation(1, kZ));
  EXPECT_EQ(apply(rotation(0, kX), kY), (ExactPoint{0, -1, 0}));
  expect_rotation(rotation(Rational(1) / 3, {2, Rational(-5) / 7, 4}));
  EXPECT_THROW(rotation(0, {0, 0, 0}), base::ContractError);
}

TEST(RotationAboutTest, RightAnglesAboutCoordinateAxesAreExact) {
  const AffineMap quarter{
      {AffineMap::Row{0, -1, 0, 0}, AffineMap::Row{1, 0, 0, 0}, AffineMap::Row{0, 0, 1, 0}}};
  EXPECT_EQ(rotation_about(kZ, 90), quarter);
  EXPECT_EQ(rotation_about({0, 0, Rational(7) / 3}, 90), quarter);
  EXPECT_EQ(rotation_about({0, 0, -7}, -90), quarter);
  EXPECT_EQ(rotation_about(kZ, 450), quarter);
  EXPECT_EQ(rotation_about(kZ, -270), quarter);
  EXPECT_EQ(rotation_about(kZ, 180), scaling({-1, -1, 1}));
  EXPECT_EQ(rotation_about(kX, -180), scaling({1, -1, -1}));
  EXPECT_EQ(rotation_about(kY, 360), AffineMap{});
  EXPECT_EQ(apply(rotation_about(kX, 90), kY), kZ);
  EXPECT_EQ(apply(rotation_about(kY, 90), kZ), kX);
}

TEST(RotationAboutTest, AThirdOfATurnAboutTheDiagonalPermutesTheAxes) {
  const AffineMap map = rotation_about({1, 1, 1}, 120);
  EXPECT_EQ(apply(map, kX), kY);
  EXPECT_EQ(apply(map, kY), kZ);
  EXPECT_EQ(apply(map, kZ), kX);
}

TEST(RotationAboutTest, IsOrthogonalAndCloseToTheAngle) {
  // The tangent t of the half angle is off by at most 2^-53 t, the angle so by 2^-53, and the
  // expected values by 2^-54.
  constexpr double kBound = 0x1p-52;
  base::SeededStream stream("geometry/rotation_about", 1, 0);
  for (int i = 0; i < 100; ++i) {
    const Rational degrees = Rational(stream.integer(-100'000, 100'000)) / 100;
    const AffineMap map = rotation_about(kZ, degrees);
    expect_rotation(map);
    const CosSin expected = cos_sin_degrees(degrees);
    EXPECT_LE(abs(Rational(map.rows[0][0] - expected.cos)), kBound) << degrees;
    EXPECT_LE(abs(Rational(map.rows[1][0] - expected.sin)), kBound) << degrees;
    expect_rotation(rotation_about({1, 2, Rational(-3) / 5}, degrees));
  }
}

TEST(RotationAboutTest, KeepsItsAxis) {
  const ExactPoint axis{1, -2, 3};
  EXPECT_EQ(apply(rotation_about(axis, 17), axis), axis);
  EXPECT_EQ(apply(rotation_about(axis, 180), axis), axis);
}

TEST(RotationAboutTest, TakesAnglesBeyondTheRangeOfDouble) {
  const Rational tiny = Rational(1) / pow(number::Integer(10), 400);
  EXPECT_EQ(rotation_about(kZ, tiny), AffineMap{});
  EXPECT_EQ(rotation_about(kZ, 180 - tiny), scaling({-1, -1, 1}));
}

TEST(CosSinDegreesTest, AreExactAndSymmetric) {
  const CosSin sixty = cos_sin_degrees(60);
  EXPECT_EQ(sixty.cos, Rational(1) / 2);
  EXPECT_EQ(sixty.sin, Rational(0.8660254037844386));
  EXPECT_EQ(cos_sin_degrees(90).cos, 0);
  EXPECT_EQ(cos_sin_degrees(-90).sin, -1);
  EXPECT_EQ(cos_sin_degrees(45).cos, cos_sin_degrees(45).sin);
  for (int k = 0; k < 50; ++k) {
    const CosSin a = cos_sin_degrees(Rational(360 * k) / 50);
    const CosSin mirrored = cos_sin_degrees(Rational(360 * (50 - k)) / 50);
    EXPECT_EQ(mirrored.cos, a.cos) << k;
    EXPECT_EQ(mirrored.sin, Rational(-a.sin)) << k;
  }
}

}  // namespace
}  // namespace lamina::geometry
