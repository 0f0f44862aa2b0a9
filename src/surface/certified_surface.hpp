// Half-spaces in intervals of doubles: crossings with a ray that are certain, or no answer.
#pragma once

#include <array>

#include "geometry/affine.hpp"
#include "geometry/vector.hpp"
#include "poly/certified_solver.hpp"
#include "surface/half_space.hpp"

namespace lamina::surface {

/// f of a half-space somewhere in the world, its numbers enclosed by doubles.
class CertifiedSurface {
 public:
  CertifiedSurface(const LocalSurface& exact, const geometry::AffineMap& to_local);

  /// Returns where the ray crosses f = 0, exactly as the scene states it, for low <= t <= high;
  /// Outcome::Undecided where 53 bits cannot tell: a tangent ray, one in the surface, a crossing
  /// at an end of the range, or two that are too close. No count is ever wrong.
  ///
  /// The ray is gone through in local coordinates, in intervals from the scene's numbers on: from
  /// before a torus on, by the Bernstein basis (poly::certified_roots); from its point nearest to
  /// the origin on, by the formula for quadratics. Allocates nothing.
  ///
  /// Contract: finite numbers; the ray's direction is not zero.
  [[nodiscard]] poly::CertifiedRoots crossings(const geometry::Ray<double>& world,
                                               const poly::Range<double>& range) const;

 private:
  Kind kind_;
  std::array<poly::Bounds, 10> c_;
  std::array<std::array<poly::Bounds, 4>, 3> to_local_;
  double bounding_radius_ = 0;  ///< of a torus, at least its own
};

}  // namespace lamina::surface
