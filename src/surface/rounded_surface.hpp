// Half-spaces in a rounded number type: crossings with a ray, inside test, normal.
#pragma once

#include <array>

#include "geometry/affine.hpp"
#include "geometry/vector.hpp"
#include "poly/solver.hpp"
#include "surface/half_space.hpp"

namespace lamina::surface {

using number::RoundedNumber;

/// A world-to-local map, each entry of the exact map rounded once: what Roth 1982 and van
/// Wijk 1984 take rays to local coordinates with.
template <RoundedNumber Number>
class RoundedMap {
 public:
  explicit RoundedMap(const geometry::AffineMap& exact);

  [[nodiscard]] geometry::Vector3<Number> point(const geometry::Vector3<Number>& world) const;
  [[nodiscard]] geometry::Vector3<Number> direction(const geometry::Vector3<Number>& world) const;
  /// The sum of the absolute terms of each coordinate of point(world).
  [[nodiscard]] geometry::Vector3<Number> magnitude(const geometry::Vector3<Number>& world) const;
  /// A gradient in local coordinates as one in the world's: times the transposed linear part.
  [[nodiscard]] geometry::Vector3<Number> gradient_to_world(
      const geometry::Vector3<Number>& local) const;

 private:
  std::array<std::array<Number, 4>, 3> rows_;
};

/// f of a half-space along a ray: the sum of c[i] (t - shift)^i.
template <RoundedNumber Number>
struct RayPolynomial {
  std::array<Number, 5> c{};
  int degree = 0;   ///< 1, 2 or 4 by the kind of surface, whatever c[degree] is
  Number shift{0};  ///< other than zero where the ray was recentred
};

/// The crossings of one ray with one surface.
template <RoundedNumber Number>
struct SurfaceCrossings {
  poly::LineRoots<Number> roots;
  bool starts_inside = false;  ///< for t towards -infinity, from the leading coefficient
  bool in_carrier = false;     ///< f is zero along the whole ray: outside by convention
};

/// f of a half-space in local coordinates, its parameters rounded once. Not of a sweep, which is a
/// RoundedSweep.
template <RoundedNumber Number>
class RoundedSurface {
 public:
  explicit RoundedSurface(const LocalSurface& exact);

  /// The polynomial of a ray in local coordinates, as the number type computes it; `recentred` at
  /// the ray's point that is nearest to the local origin, so that no power of its distance from
  /// there cancels in the coefficients. Of a sphere its discriminant is then that of Haines et al.
  /// ("Precision improvements for ray/sphere intersection", Ray Tracing Gems, 2019, chapter 7).
  [[nodiscard]] RayPolynomial<Number> polynomial(const geometry::Ray<Number>& local,
                                                 bool recentred) const;
  /// Crossings with a ray in local coordinates; t is the same as in the world. Of a ray that
  /// `starts_on` the surface the root t = 0 is divided out, and given as exactly 0.
  [[nodiscard]] SurfaceCrossings<Number> crossings(const geometry::Ray<Number>& local,
                                                   const poly::Solvers& solvers,
                                                   bool starts_on = false) const;
  /// f(p), evaluated in Number.
  [[nodiscard]] Number value(const geometry::Vector3<Number>& local) const;
  /// f(p) <= 0, by value().
  [[nodiscard]] bool inside(const geometry::Vector3<Number>& local) const {
    return value(local) <= 0;
  }
  /// A bound on the error of f, by value() or as a ray's polynomial at 0, at a point of the
  /// world: gamma_n f(p) with all signs positive, n roundings from the scene's numbers on.
  ///
  /// Arguments: magnitude  RoundedMap::magnitude of the point.
  [[nodiscard]] Number rounding_error(const geometry::Vector3<Number>& magnitude) const;
  /// The gradient of f, not normalised.
  [[nodiscard]] geometry::Vector3<Number> gradient(const geometry::Vector3<Number>& local) const;

 private:
  /// Of a torus from farther than its diameter from its centre, where distances cancel in the
  /// coefficients of a ray's polynomial; nearer, no term is more than a few times the torus' own.
  [[nodiscard]] bool is_recentred(const geometry::Vector3<Number>& origin,
                                  poly::Recentring which) const;

  Kind kind_;
  std::array<Number, 10> c_;
};

}  // namespace lamina::surface
