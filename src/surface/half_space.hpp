// Half-spaces {p : f(p) <= 0}: the leaves of a CSG tree, exactly as a scene states them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "geometry/affine.hpp"
#include "number/rational.hpp"
#include "surface/sphere_sweep.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {

enum class Kind : std::uint8_t { Plane, Quadric, Torus, Sweep };

/// f in local coordinates. What `coefficients` holds:
///   Plane    nx, ny, nz, c                      f = n.p + c
///   Quadric  xx, yy, zz, xy, xz, yz, x, y, z, 1 f = sum of coefficient * monomial
///   Torus    R, r                               f = (p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2)
///   Sweep    none: its pieces have no f in common; `sweep` or `sphere_sweep` says which points
///            are inside
/// The torus has the z axis. Where r > R the lens around the origin has f > 0 too: it is
/// outside, as the sign of f says.
struct LocalSurface {
  Kind kind = Kind::Plane;
  std::array<number::Rational, 10> coefficients{};
  std::shared_ptr<const SweptSurface> sweep{};        ///< of Kind::Sweep: this,
  std::shared_ptr<const SphereSweep> sphere_sweep{};  ///< or this; else null

  friend bool operator==(const LocalSurface& a, const LocalSurface& b);
};

LocalSurface plane(const geometry::ExactPoint& normal,
                   const number::Rational& offset);  ///< n.p <= offset
LocalSurface sphere(const number::Rational& radius);
LocalSurface infinite_cylinder(const number::Rational& radius);  ///< axis z
/// x^2 + y^2 <= (slope * (z - apex))^2: both nappes, axis z.
LocalSurface infinite_cone(const number::Rational& slope, const number::Rational& apex);
/// p^T M p <= 0 with p = (x, y, z, 1); the matrix need not be symmetric.
LocalSurface quadric(const std::array<std::array<number::Rational, 4>, 4>& matrix);
LocalSurface torus(const number::Rational& major, const number::Rational& minor);
LocalSurface swept(SweptSurface sweep);
LocalSurface swept(SphereSweep sweep);

}  // namespace lamina::surface
