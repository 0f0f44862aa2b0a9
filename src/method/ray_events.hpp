// All crossings of one ray with all leaves of a scene, in order, in one number type.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "geometry/rounding.hpp"
#include "poly/solver.hpp"
#include "scene/rounding.hpp"
#include "surface/carrier.hpp"
#include "surface/rounded_sphere_sweep.hpp"
#include "surface/rounded_surface.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina::method {

/// One crossing of the ray with one leaf.
template <number::RealNumber Number>
struct Crossing {
  typename number::number_traits<Number>::Root t;
  csg::LeafIndex leaf = 0;
  std::uint16_t index = 0;  ///< 0, 1, ... along the ray among the leaf's crossings
  bool enters_by_parity = false;
  bool enters_by_normal = false;  ///< the sign of normal . direction at the rounded point
};

/// Finds and sorts the crossings of rays, one ray after the other; buffers are kept, so that
/// rays after the first few allocate nothing in hardware numbers.
template <number::RealNumber Number>
class RayEvents {
 public:
  using Root = typename number::number_traits<Number>::Root;
  /// Where on its contour or trajectory a sweep is crossed; nothing of other surfaces.
  using Place = typename surface::RoundedSweep<Number>::Crossing;

  RayEvents(const scene::Scene& scene, const poly::Solvers& solvers);

  void find(const geometry::ExactRay& ray);
  /// The ray starts on the surface of the leaves in `left`: their root t = 0 is divided out,
  /// and stands among the crossings as exactly 0. Of a sweep, which has no polynomial in t to
  /// divide, the crossing that is nearest to 0 is taken for it.
  void find(const geometry::Ray<Number>& ray, std::span<const csg::LeafIndex> left = {});
  /// Sorts the crossings anew, ties by rank[leaf].
  void reorder(std::span<const csg::LeafIndex> rank);

  /// By t, ties by leaf index, for all t of the line.
  [[nodiscard]] std::span<const Crossing<Number>> crossings() const { return crossings_; }
  /// The leaf's state for t towards -infinity.
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf) const { return starts_inside_[leaf] != 0; }
  /// The state that W&T 3.7 start from: that of the point `reference` of t before the leaf's
  /// first crossing, or before the origin. For 0, that of the sign at -infinity.
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf, const Number& reference) const;
  /// Does the ray lie in a carrier? By convention it is outside of that leaf all along.
  [[nodiscard]] bool in_some_carrier() const {
    return std::find(in_carrier_.begin(), in_carrier_.end(), 1) != in_carrier_.end();
  }
  /// Is f <= 0 for the leaf at the crossing's rounded point?
  [[nodiscard]] bool inside_at(csg::LeafIndex leaf, const Root& t) const {
    return inside(leaf, point(t));
  }
  /// Is f <= 0 for the leaf at a point of the world?
  [[nodiscard]] bool inside(csg::LeafIndex leaf, const geometry::Vector3<Number>& world) const;

  static bool less(const Root& a, const Root& b) { return a < b; }
  static bool positive(const Root& t) { return t > 0; }
  static bool finite(const Root& t) { return t - t == 0; }
  /// Is `later` not farther than `step` behind `first`?
  static bool within(const Root& first, const Root& later, const Number& step, bool relative) {
    using std::abs;
    return later - first <= (relative ? Number(step * abs(first)) : step);
  }
  /// origin + t direction, each coordinate rounded.
  [[nodiscard]] geometry::Vector3<Number> point(const Root& t) const;
  [[nodiscard]] Place place(const Crossing<Number>& crossing) const {
    return is_sweep(crossing.leaf) ? places_[crossing.leaf][crossing.index] : Place{};
  }
  /// The gradient of the leaf's f at a point of the world; outward for a closed solid. Of a sweep,
  /// the normal at a crossing's place.
  [[nodiscard]] geometry::Vector3<Number> gradient(csg::LeafIndex leaf,
                                                   const geometry::Vector3<Number>& point,
                                                   const Place& place) const;
  /// A bound on the distance from a point of the world, which is near the leaf's surface, beyond
  /// which the surface does not reach, and f computed there has its exact sign, to first order in
  /// the distance: (|f| + 3 gamma_n F) / |gradient|, where F is f with all signs made positive and
  /// n counts the roundings on the way from the scene's numbers to f (Higham 2002, 3.1). The form
  /// is that of pbrt 4e, 6.8; it takes the residual |f| where pbrt first moves the point onto
  /// the surface. Of the three F's, one is for f at the point, one for f where the ray starts, and
  /// one for rounding that start. Of a sweep, f is that of the tangent plane at the place, or of
  /// the ball there.
  [[nodiscard]] Number distance_bound(csg::LeafIndex leaf, const geometry::Vector3<Number>& point,
                                      const Place& place) const;

 private:
  struct LeafData {
    std::uint32_t frame;
    std::variant<surface::RoundedSurface<Number>, surface::RoundedSweep<Number>,
                 surface::RoundedSphereSweep<Number>>
        surface;
  };

  [[nodiscard]] bool is_sweep(csg::LeafIndex leaf) const {
    return !std::holds_alternative<surface::RoundedSurface<Number>>(leaves_[leaf].surface);
  }
  void add_crossing(csg::LeafIndex leaf, std::size_t index, const Number& t, bool enters,
                    const geometry::Vector3<Number>& local_gradient);
  void find_on(csg::LeafIndex leaf, const surface::RoundedSurface<Number>& surface, bool is_left);
  // A sweep of either kind.
  template <typename Sweep>
  void find_on(csg::LeafIndex leaf, const Sweep& sweep, bool is_left);

  const scene::Scene* scene_;
  poly::Solvers solvers_;
  std::vector<surface::RoundedMap<Number>> frames_;
  std::vector<LeafData> leaves_;
  geometry::Ray<Number> ray_;
  std::vector<geometry::Ray<Number>> local_rays_;
  std::vector<Crossing<Number>> crossings_;
  std::vector<std::vector<Place>> places_;  // by leaf, of sweeps; by the crossing's index
  mutable std::vector<Place> scratch_;
  std::vector<std::uint8_t> starts_inside_;
  std::vector<std::uint8_t> in_carrier_;
};

/// The exact crossings: roots of each carrier's polynomial along the ray, found once for all
/// its leaves. Nothing is rounded, so a point on a surface is known to be on it.
template <>
class RayEvents<number::exact> {
 public:
  using Root = number::Root;

  RayEvents(const scene::Scene& scene, const poly::Solvers&) : scene_(&scene) {}

  void find(const geometry::ExactRay& ray);
  void reorder(std::span<const csg::LeafIndex> rank);

  [[nodiscard]] std::span<const Crossing<number::exact>> crossings() const { return crossings_; }
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf) const { return starts_inside_[leaf] != 0; }
  [[nodiscard]] bool in_some_carrier() const {
    return std::find(in_carrier_.begin(), in_carrier_.end(), 1) != in_carrier_.end();
  }
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf, const number::exact& reference) const;
  [[nodiscard]] bool inside_at(csg::LeafIndex leaf, const Root& t) const;

  static bool less(const Root& a, const Root& b) { return compare(a, b) < 0; }
  static bool positive(const Root& t) { return compare(t, number::Rational(0)) > 0; }
  static bool finite(const Root&) { return true; }
  static bool within(const Root& first, const Root& later, const number::Rational& step,
                     bool relative);

 private:
  const scene::Scene* scene_;
  std::vector<surface::CarrierOnRay> carriers_;
  std::vector<Crossing<number::exact>> crossings_;
  std::vector<std::uint8_t> starts_inside_;
  std::vector<std::uint8_t> in_carrier_;
};

}  // namespace lamina::method
