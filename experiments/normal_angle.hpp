// Angles between normals that are given exactly.
#pragma once

#include <cmath>

#include "geometry/vector.hpp"

namespace lamina::experiments {

/// In radians, 0 to pi; NaN if one of them is zero. The cosine and the sine squared are exact until
/// they are rounded, so that small angles have all digits.
inline double angle_between(const geometry::ExactPoint& a, const geometry::ExactPoint& b) {
  const number::Rational along = dot(a, b);
  const geometry::ExactPoint across = cross(a, b);
  const number::Rational squares = dot(a, a) * dot(b, b);
  if (squares.is_zero()) {
    return std::nan("");
  }
  const double sine = std::sqrt(number::nearest_double(dot(across, across) / squares));
  const double cosine = std::sqrt(number::nearest_double(along * along / squares));
  return std::atan2(sine, along.sign() < 0 ? -cosine : cosine);
}

}  // namespace lamina::experiments
