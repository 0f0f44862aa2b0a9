// Exact affine maps, rational rotations among them.
#pragma once

#include <array>
#include <optional>

#include "geometry/vector.hpp"

namespace lamina::geometry {

/// p -> linear * p + translation, over the rationals. Rows are output coordinates.
struct AffineMap {
  using Row = std::array<number::Rational, 4>;  ///< x, y, z coefficients and the constant
  std::array<Row, 3> rows{Row{1, 0, 0, 0}, Row{0, 1, 0, 0}, Row{0, 0, 1, 0}};

  friend bool operator==(const AffineMap&, const AffineMap&) = default;
};

ExactPoint apply(const AffineMap& map, const ExactPoint& point);
/// The linear part alone.
ExactPoint apply_to_direction(const AffineMap& map, const ExactPoint& direction);
/// first, then second.
AffineMap compose(const AffineMap& second, const AffineMap& first);
number::Rational determinant(const AffineMap& map);
/// The exact inverse, or nothing if the map is singular.
std::optional<AffineMap> inverse(const AffineMap& map);

AffineMap translation(const ExactPoint& by);
AffineMap scaling(const ExactPoint& by);
/// Reflection at the plane through the origin with the given normal (not zero).
AffineMap reflection(const ExactPoint& normal);
/// The rotation of the quaternion w + xi + yj + zk, which need not have length one (not
/// zero). Its matrix is rational and exactly orthogonal.
AffineMap rotation(const number::Rational& w, const ExactPoint& xyz);
/// Rotation about an axis by an angle in degrees. A multiple of 90 about a coordinate axis
/// is exact; otherwise the tangent of half the angle, divided by the axis' length, is
/// rounded to double, so that the angle is off by an ulp or so but the matrix is exactly
/// orthogonal, and the same on every machine (MPFR).
AffineMap rotation_about(const ExactPoint& axis, const number::Rational& degrees);

/// cos and sin of an angle in degrees, each the double nearest to the true value and then
/// exact: 0, 1/2 and 1 come out exactly, and symmetric angles give symmetric values.
struct CosSin {
  number::Rational cos;
  number::Rational sin;
};
CosSin cos_sin_degrees(const number::Rational& degrees);

}  // namespace lamina::geometry
