// Random rays at a scene, held exactly by `float` and so by every number type, or by `double`.
#pragma once

#include <cstdint>
#include <vector>

#include "base/seeded_stream.hpp"
#include "scene/scene.hpp"

namespace lamina::scene {

/// A uniformly random point of a box, in double.
geometry::Vector3<double> point_in(const Bounds& bounds, base::SeededStream& stream);

/// Twice the diagonal of the box: from there every ray at it starts outside.
double distance_outside(const Bounds& bounds);

/// A uniformly random direction of length one.
geometry::Vector3<double> random_direction(base::SeededStream& stream);

/// What holds the six coordinates of a ray exactly.
enum class Held : std::uint8_t { Float, Double };

/// A ray from `origin`, rounded, towards `target`: only the rounding of its direction takes it
/// away from there.
geometry::ExactRay ray_from(const geometry::Vector3<double>& origin,
                            const geometry::Vector3<double>& target, Held held);

/// A ray through `target`, but for rounding its six coordinates to float. The origin is
/// `distance` away from the target in a uniformly random direction.
geometry::ExactRay ray_through(const geometry::Vector3<double>& target, double distance,
                               base::SeededStream& stream);

/// Rays from outside through uniformly random points of the box.
std::vector<geometry::ExactRay> uniform_rays(const Bounds& bounds, std::uint64_t count,
                                             base::SeededStream& stream);

}  // namespace lamina::scene
