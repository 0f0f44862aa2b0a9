// Exact points and rays as a number type holds them.
#pragma once

#include "geometry/vector.hpp"
#include "number/traits.hpp"

namespace lamina::geometry {

/// Each coordinate rounded once.
template <number::RoundedNumber Number>
Vector3<Number> rounded(const ExactPoint& point) {
  using Traits = number::number_traits<Number>;
  return {Traits::from_exact(point.x), Traits::from_exact(point.y), Traits::from_exact(point.z)};
}

template <number::RoundedNumber Number>
Ray<Number> rounded(const ExactRay& ray) {
  return {rounded<Number>(ray.origin), rounded<Number>(ray.direction)};
}

}  // namespace lamina::geometry
