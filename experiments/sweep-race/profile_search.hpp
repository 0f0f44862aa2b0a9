// Conics and arcs by van Wijk's way: the ray's image in the profile's plane, a rectangle for each
// piece, and a tree over them. Hashimoto and Suenaga's own way is a tree of half-spaces.
#pragma once

#include <variant>
#include <vector>

#include "geometry/revolved_profile.hpp"
#include "geometry/vector.hpp"
#include "poly/solver.hpp"
#include "surface/box_tree.hpp"
#include "surface/ray_image.hpp"
#include "surface/rounded_surface.hpp"

namespace lamina::experiments {

/// With u^2 = alpha v^2 + beta v + gamma, equation 9 of van Wijk 1984 is a quadratic in v. Only
/// times are taken from it: rays that are level, or upright, have no equations here.
class ProfileSearch {
 public:
  explicit ProfileSearch(const geometry::RevolvedProfile& profile);

  /// The t of the crossings, not in order. Contract: the direction is neither level nor upright.
  void find_crossings(const geometry::Ray<double>& ray, const poly::Solvers& solvers,
                      std::vector<double>& crossings) const;

 private:
  struct RoundedConic {
    double alpha, beta, gamma;
    poly::Range<double> heights;
  };
  // The part of a torus above its height `low`.
  struct RoundedArc {
    surface::RoundedSurface<double> torus;
    double height, low;
  };

  std::vector<std::variant<RoundedConic, RoundedArc>> pieces_;
  std::vector<surface::PlaneBox<double>> boxes_;
  surface::BoxTree<double> tree_;
};

}  // namespace lamina::experiments
