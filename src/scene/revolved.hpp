// Solids of revolution as CSG of quadrics, toruses and planes.
#pragma once

#include "geometry/revolved_profile.hpp"
#include "scene/solid.hpp"

namespace lamina::scene {

/// Returns the solid that the profile goes round, turned about the z axis: the profile's y is z.
///
/// Exact. Each piece is a half-space of its quadric or torus between planes of constant z, so that
/// neighbours meet in two planes that coincide exactly; what they bound is added or taken away
/// layer by layer, from outside in. A profile without arcs (inscribed_cones) gives quadrics only.
/// The box holds the solid: its radius is rounded up, by less than one part in 10^15.
/// Source: Hashimoto and Suenaga, equations 2 and 3; Horiuchi et al. 1985 for cones.
Solid revolved_solid(const geometry::RevolvedProfile& profile);

}  // namespace lamina::scene
