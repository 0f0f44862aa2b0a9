#include "scene/rounding.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/contract.hpp"

namespace lamina::scene {
namespace {

using geometry::AffineMap;

std::optional<AffineMap> rounded(const AffineMap& map, const Rounding& round) {
  AffineMap result;
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    for (std::size_t j = 0; j < map.rows[i].size(); ++j) {
      const auto entry = round(map.rows[i][j]);
      if (!entry) {
        return std::nullopt;
      }
      result.rows[i][j] = *entry;
    }
  }
  return result;
}

// Finds the carriers of the leaves anew; false if a surface is none any more.
bool place_carriers(Scene& scene) {
  std::map<surface::Carrier, surface::CarrierIndex> known;
  scene.carriers.clear();
  scene.leaves_of_carrier.clear();
  for (csg::LeafIndex i = 0; i < scene.leaves.size(); ++i) {
    Leaf& leaf = scene.leaves[i];
    try {
      auto [carrier, side] = surface::carrier_of(leaf.surface, scene.frames[leaf.frame]);
      const auto [place, added] =
          known.emplace(carrier, static_cast<surface::CarrierIndex>(scene.carriers.size()));
      if (added) {
        scene.carriers.push_back(std::move(carrier));
        scene.leaves_of_carrier.emplace_back();
      }
      leaf.carrier = place->second;
      leaf.side = side;
      scene.leaves_of_carrier[leaf.carrier].push_back(i);
    } catch (const base::InputError&) {  // f has become constant
      return false;
    }
  }
  return true;
}

std::optional<surface::LocalSurface> rounded_sphere_sweep(const surface::SphereSweep& sweep,
                                                          const Rounding& round) {
  const geometry::Trajectory& trajectory = sweep.trajectory();
  std::vector<geometry::ExactPoint> points;
  for (const geometry::ExactPoint& p : trajectory.points()) {
    const auto x = round(p.x);
    const auto y = round(p.y);
    const auto z = round(p.z);
    if (!x || !y || !z) {
      return std::nullopt;
    }
    points.push_back({*x, *y, *z});
  }
  const auto radius = round(sweep.radius());
  if (!radius) {
    return std::nullopt;
  }
  try {
    return surface::swept(surface::SphereSweep(
        *radius, std::make_shared<const geometry::Trajectory>(std::move(points), trajectory.kind(),
                                                              trajectory.closed())));
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

}  // namespace

AffineMap inverse_of_rounded_placement(const AffineMap& frame, const Rounding& round) {
  const auto placement = rounded(inverse(frame).value(), round);
  return placement ? inverse(*placement).value_or(frame) : frame;
}

std::optional<surface::LocalSurface> rounded_surface(const surface::LocalSurface& surface,
                                                     const Rounding& round) {
  if (surface.sphere_sweep) {
    return rounded_sphere_sweep(*surface.sphere_sweep, round);
  }
  if (surface.sweep) {
    const geometry::Contour& contour = surface.sweep->contour();
    std::vector<geometry::PlanePoint> points;
    for (const geometry::PlanePoint& p : contour.points()) {
      const auto u = round(p.u);
      const auto v = round(p.v);
      if (!u || !v) {
        return std::nullopt;
      }
      points.push_back({*u, *v});
    }
    surface::Scaling scaling = surface.sweep->scaling();
    for (auto* const polynomial : {&scaling.x, &scaling.y}) {
      for (number::Rational& coefficient : *polynomial) {
        const auto value = round(coefficient);
        if (!value) {
          return std::nullopt;
        }
        coefficient = *value;
      }
    }
    if (points == contour.points() && scaling == surface.sweep->scaling()) {
      return surface;
    }
    try {
      auto rounded_contour = std::make_shared<const geometry::Contour>(
          std::move(points), contour.kind(), contour.closed());
      return surface::swept(
          surface.sweep->sweep() == surface::Sweep::GeneralisedConic
              ? surface::SweptSurface(std::move(scaling), std::move(rounded_contour))
              : surface::SweptSurface(surface.sweep->sweep(), std::move(rounded_contour)));
    } catch (const base::InputError&) {
      return std::nullopt;
    }
  }
  surface::LocalSurface result = surface;
  for (number::Rational& coefficient : result.coefficients) {
    const auto value = round(coefficient);
    if (!value) {
      return std::nullopt;
    }
    coefficient = *value;
  }
  return result;
}

std::optional<Scene> rounded_scene(const Scene& scene, const Rounding& round) {
  Scene result = scene;
  for (AffineMap& frame : result.frames) {
    frame = inverse_of_rounded_placement(frame, round);
  }
  for (Leaf& leaf : result.leaves) {
    auto surface = rounded_surface(leaf.surface, round);
    if (!surface) {
      return std::nullopt;
    }
    leaf.surface = std::move(*surface);
  }
  return place_carriers(result) ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<Scene> scene_of_constants(const Scene& rounded_scene, const Rounding& round) {
  Scene result = rounded_scene;
  for (AffineMap& frame : result.frames) {
    const auto map = rounded(frame, round);
    if (!map || determinant(*map).is_zero()) {
      return std::nullopt;
    }
    frame = *map;
  }
  return place_carriers(result) ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace lamina::scene
