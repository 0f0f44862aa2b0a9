#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "method/ray_events.hpp"

namespace lamina::method {
namespace detail {

// What one function makes of a surface that has an f, or the other of a sweep of any kind.
template <typename Number, typename... Sweep, typename OfSurface, typename OfSweep>
auto on_surface_or_sweep(const std::variant<surface::RoundedSurface<Number>, Sweep...>& either,
                         const OfSurface& of_surface, const OfSweep& of_sweep) {
  return std::visit(
      [&](const auto& surface) {
        if constexpr (std::is_same_v<decltype(surface), const surface::RoundedSurface<Number>&>) {
          return of_surface(surface);
        } else {
          return of_sweep(surface);
        }
      },
      either);
}

}  // namespace detail

template <number::RealNumber Number>
RayEvents<Number>::RayEvents(const scene::Scene& scene, const poly::Solvers& solvers)
    : scene_(&scene), solvers_(solvers) {
  // The maps are inverted from the rounded placements, as a program does that has read the
  // scene into this type; but exactly, so that each entry is rounded only once more.
  for (const geometry::AffineMap& frame : scene.frames) {
    frames_.emplace_back(scene::inverse_of_rounded_placement(frame, scene::rounding<Number>));
  }
  for (const scene::Leaf& leaf : scene.leaves) {
    if (leaf.surface.kind != surface::Kind::Sweep) {
      leaves_.push_back({leaf.frame, surface::RoundedSurface<Number>(leaf.surface)});
      continue;
    }
    // Its pieces follow exactly from the points as this type holds them.
    const surface::LocalSurface held =
        scene::rounded_surface(leaf.surface, scene::rounding<Number>).value_or(leaf.surface);
    if (held.sweep) {
      leaves_.push_back({leaf.frame, surface::RoundedSweep<Number>(*held.sweep)});
    } else {
      leaves_.push_back({leaf.frame, surface::RoundedSphereSweep<Number>(*held.sphere_sweep)});
    }
  }
  places_.resize(leaves_.size());
  local_rays_.resize(frames_.size());
  starts_inside_.resize(leaves_.size());
  in_carrier_.resize(leaves_.size());
  crossings_.reserve(4 * leaves_.size());
}

template <number::RealNumber Number>
void RayEvents<Number>::find(const geometry::ExactRay& ray) {
  find(geometry::rounded<Number>(ray));
}

template <number::RealNumber Number>
void RayEvents<Number>::find(const geometry::Ray<Number>& ray,
                             std::span<const csg::LeafIndex> left) {
  ray_ = ray;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    local_rays_[i] = {frames_[i].point(ray.origin), frames_[i].direction(ray.direction)};
  }
  crossings_.clear();
  for (csg::LeafIndex leaf = 0; leaf < leaves_.size(); ++leaf) {
    const bool is_left = std::find(left.begin(), left.end(), leaf) != left.end();
    std::visit([&](const auto& surface) { find_on(leaf, surface, is_left); },
               leaves_[leaf].surface);
  }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing<Number>& a, const Crossing<Number>& b) {
              // Roots of one leaf that round to the same t are in their own order.
              return a.t < b.t ||
                     (!(b.t < a.t) && std::pair(a.leaf, a.index) < std::pair(b.leaf, b.index));
            });
}

template <number::RealNumber Number>
void RayEvents<Number>::add_crossing(csg::LeafIndex leaf, std::size_t index, const Number& t,
                                     bool enters, const geometry::Vector3<Number>& local_gradient) {
  const bool enters_by_normal = dot(local_gradient, local_rays_[leaves_[leaf].frame].direction) < 0;
  crossings_.push_back({t, leaf, static_cast<std::uint16_t>(index), enters, enters_by_normal});
}

template <number::RealNumber Number>
void RayEvents<Number>::find_on(csg::LeafIndex leaf, const surface::RoundedSurface<Number>& surface,
                                bool is_left) {
  const geometry::Ray<Number>& local = local_rays_[leaves_[leaf].frame];
  auto found = surface.crossings(local, solvers_, is_left);
  spoil(found.roots, solvers_.fault, leaf);
  starts_inside_[leaf] = found.starts_inside ? 1 : 0;
  in_carrier_[leaf] = found.in_carrier ? 1 : 0;
  bool inside = found.starts_inside;
  for (int i = 0; i < found.roots.count; ++i) {
    const Number& t = found.roots.t[i];
    inside = !inside;
    add_crossing(leaf, static_cast<std::size_t>(i), t, inside,
                 surface.gradient(local.origin + t * local.direction));
  }
}

template <number::RealNumber Number>
template <typename Sweep>
void RayEvents<Number>::find_on(csg::LeafIndex leaf, const Sweep& sweep, bool is_left) {
  using std::abs;
  const geometry::Ray<Number>& local = local_rays_[leaves_[leaf].frame];
  std::vector<Place>& places = places_[leaf];
  const int start = sweep.find_crossings(local, solvers_, places)
                        ? sweep.side_at_minus_infinity(local, places, solvers_, scratch_)
                        : 0;
  in_carrier_[leaf] = start == 0 ? 1 : 0;
  bool inside = start < 0;
  starts_inside_[leaf] = inside ? 1 : 0;
  if (start == 0) {
    places.clear();
  }
  if (is_left && !places.empty()) {
    std::min_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return abs(a.t) < abs(b.t);
    })->t = Number(0);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Number& t = places[i].t;
    inside = !inside;
    add_crossing(leaf, i, t, inside, sweep.normal(local.origin + t * local.direction, places[i]));
  }
}

template <number::RealNumber Number>
void RayEvents<Number>::reorder(std::span<const csg::LeafIndex> rank) {
  std::sort(crossings_.begin(), crossings_.end(),
            [rank](const Crossing<Number>& a, const Crossing<Number>& b) {
              return a.t < b.t || (!(b.t < a.t) && std::pair(rank[a.leaf], a.index) <
                                                       std::pair(rank[b.leaf], b.index));
            });
}

template <number::RealNumber Number>
bool RayEvents<Number>::starts_inside(csg::LeafIndex leaf, const Number& reference) const {
  if (reference == 0 || in_carrier_[leaf] != 0) {
    return starts_inside(leaf);
  }
  const auto first = std::find_if(crossings_.begin(), crossings_.end(),
                                  [leaf](const auto& c) { return c.leaf == leaf; });
  return inside_at(leaf, Root((first == crossings_.end() ? Root(0) : first->t) - reference));
}

template <number::RealNumber Number>
geometry::Vector3<Number> RayEvents<Number>::point(const Root& t) const {
  return ray_.origin + t * ray_.direction;
}

template <number::RealNumber Number>
bool RayEvents<Number>::inside(csg::LeafIndex leaf, const geometry::Vector3<Number>& world) const {
  const LeafData& data = leaves_[leaf];
  const geometry::Vector3<Number> local = frames_[data.frame].point(world);
  return detail::on_surface_or_sweep(
      data.surface, [&](const auto& surface) { return surface.inside(local); },
      [&](const auto& sweep) { return sweep.side(local, solvers_, scratch_) <= 0; });
}

template <number::RealNumber Number>
geometry::Vector3<Number> RayEvents<Number>::gradient(csg::LeafIndex leaf,
                                                      const geometry::Vector3<Number>& point,
                                                      const Place& place) const {
  const LeafData& data = leaves_[leaf];
  const surface::RoundedMap<Number>& frame = frames_[data.frame];
  const geometry::Vector3<Number> local = frame.point(point);
  return frame.gradient_to_world(detail::on_surface_or_sweep(
      data.surface, [&](const auto& surface) { return surface.gradient(local); },
      [&](const auto& sweep) { return sweep.normal(local, place); }));
}

template <number::RealNumber Number>
Number RayEvents<Number>::distance_bound(csg::LeafIndex leaf,
                                         const geometry::Vector3<Number>& point,
                                         const Place& place) const {
  using std::abs;
  using std::sqrt;
  const LeafData& data = leaves_[leaf];
  const surface::RoundedMap<Number>& frame = frames_[data.frame];
  const geometry::Vector3<Number> across = gradient(leaf, point, place);
  const geometry::Vector3<Number> local = frame.point(point);
  const geometry::Vector3<Number> magnitude = frame.magnitude(point);
  const Number off = detail::on_surface_or_sweep(
      data.surface,
      [&](const auto& surface) -> Number {
        return abs(surface.value(local)) + 3 * surface.rounding_error(magnitude);
      },
      [&](const auto& sweep) -> Number {
        return abs(sweep.value(local, place)) + 3 * sweep.rounding_error(magnitude, place);
      });
  return off / sqrt(dot(across, across));
}

}  // namespace lamina::method
