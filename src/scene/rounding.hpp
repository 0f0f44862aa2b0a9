// What rounding does to a scene before the first ray: its numbers, then its constants.
#pragma once

#include <functional>
#include <optional>

#include "number/concepts.hpp"
#include "number/traits.hpp"
#include "scene/scene.hpp"

namespace lamina::scene {

/// The nearest value of a number type, exactly; nothing where it overflows.
using Rounding = std::function<std::optional<number::Rational>(const number::Rational&)>;

template <number::RealNumber Number>
std::optional<number::Rational> rounding(const number::Rational& value) {
  using Traits = number::number_traits<Number>;
  if constexpr (number::ExactNumber<Number>) {
    return value;
  } else {
    const Number nearest = Traits::from_exact(value);
    return nearest - nearest == 0 ? std::optional(Traits::to_exact(nearest)) : std::nullopt;
  }
}

/// Takes a frame, world to local, to the exact inverse of its rounded placement: each entry
/// of the map from local to world is rounded once. Where that map is singular, or an entry
/// overflows, the frame stays as it is.
geometry::AffineMap inverse_of_rounded_placement(const geometry::AffineMap& frame,
                                                 const Rounding& round);

/// Returns a surface with its coefficients, or its contour's or trajectory's points, and the radius
/// of what is moved along that, rounded once each. Nothing where one overflows, or where a sweep
/// has no contour any more: it crosses or touches itself, or two points in a row are equal.
std::optional<surface::LocalSurface> rounded_surface(const surface::LocalSurface& surface,
                                                     const Rounding& round);

/// Returns the scene as a number type holds it: every entry of its placements and every
/// number of its surfaces rounded once, and nothing else; the carriers are those that
/// follow exactly. Nothing if a number overflows or a surface degenerates.
std::optional<Scene> rounded_scene(const Scene& scene, const Rounding& round);

/// Returns the scene of the constants that a number type computes with: of a rounded_scene,
/// the inverse maps too are rounded, each entry once. (The pieces of a sweep's contour stay as they
/// follow from its points: their coefficients, each rounded, are no contour.)
std::optional<Scene> scene_of_constants(const Scene& rounded, const Rounding& round);

}  // namespace lamina::scene
