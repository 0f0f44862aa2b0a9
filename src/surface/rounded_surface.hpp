// Half-spaces in a rounded number type: crossings with a ray, inside test, normal.
#pragma once

#include <array>

#include "geometry/affine.hpp"
#include "geometry/vector.hpp"
#include "poly/line_roots.hpp"
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

/// The crossings of one ray with one surface.
template <RoundedNumber Number>
struct SurfaceCrossings {
  poly::LineRoots<Number> roots;
  bool starts_inside = false;  ///< for t towards -infinity, from the leading coefficient
  bool in_carrier = false;     ///< f is zero along the whole ray: outside by convention
};

/// f of a half-space in local coordinates, its parameters rounded once.
template <RoundedNumber Number>
class RoundedSurface {
 public:
  explicit RoundedSurface(const LocalSurface& exact);

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
  Kind kind_;
  std::array<Number, 10> c_;
};

}  // namespace lamina::surface
