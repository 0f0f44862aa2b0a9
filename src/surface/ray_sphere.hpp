// Two formulas of their own for a ray and a sphere, to be measured against quadratic equations.
#pragma once

#include <cmath>

#include "geometry/vector.hpp"
#include "poly/real_roots.hpp"

namespace lamina::surface {

enum class SphereFormula : std::uint8_t {
  Haines,  ///< Haines et al., Ray Tracing Gems (2019), chapter 7
  Pbrt,    ///< Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section 6.8.3
};

/// Returns where a ray crosses the sphere of this radius around the origin; a tangent point as a
/// root of multiplicity 2. Both take the discriminant from v, the vector from the centre to the
/// ray's nearest point, so that it does not cancel with distance: a (r^2 - v.v), or with pbrt
/// a (r + |v|) (r - |v|), whose difference is exact at grazing rays, though |v| is not; and the
/// root nearer to the origin of the ray by Vieta, from o.o - r^2.
///
/// Error:  v is off by some u |o|, and each root by some u (|o| + r) r / (h |d|), where h is half
///         of the chord.
template <number::RoundedNumber Number>
poly::RealRoots<Number> ray_sphere(const geometry::Ray<Number>& ray, const Number& radius,
                                   SphereFormula formula) {
  using std::sqrt;
  const auto& [o, d] = ray;
  const Number a = dot(d, d);
  const Number b = dot(o, d);
  const Number c = dot(o, o) - radius * radius;
  const geometry::Vector3<Number> v = o - Number(b / a) * d;
  const Number vv = dot(v, v);
  Number part;
  if (formula == SphereFormula::Haines) {
    part = radius * radius - vv;
  } else {
    const Number length = sqrt(vv);
    part = (radius + length) * (radius - length);
  }
  const Number discriminant = a * part;
  poly::RealRoots<Number> roots;
  if (!(discriminant >= 0)) {
    return roots;
  }
  if (discriminant == 0) {
    roots.add(Number(-b / a), 2);
    return roots;
  }
  const Number root = sqrt(discriminant);
  const Number q = b < 0 ? Number(root - b) : Number(-(b + root));
  roots.add(Number(q / a), 1);
  roots.add(Number(c / q), 1);
  return roots;
}

}  // namespace lamina::surface
