// Random rays at a scene, which `float` and so every number type holds exactly.
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

/// A ray through `target`, but for rounding its six coordinates to float. The origin is
/// `distance` away from the target in a uniformly random direction.
geometry::ExactRay ray_through(const geometry::Vector3<double>& target, double distance,
                               base::SeededStream& stream);

/// Rays from outside through uniformly random points of the box.
std::vector<geometry::ExactRay> uniform_rays(const Bounds& bounds, std::uint64_t count,
                                             base::SeededStream& stream);

}  // namespace lamina::scene
