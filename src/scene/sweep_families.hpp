// Members of the families of swept contours.
#pragma once

#include <cstdint>

#include "scene/placement.hpp"

namespace lamina::scene {

/// SWEEP, same | mirrored | scaled: a spline swept, translational, conic or rotational, and added
/// to itself, the second of another material: the same again, the mirror image of a mirrored
/// contour, or three times as large under a scale of 1/3.
FamilyMember sweep_sum(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// The same parameters: the sweep less itself.
FamilyMember sweep_difference(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// SWEEP: a swept spline in two parts of different materials, which a plane across it divides.
FamilyMember sweep_halves(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// The wine glass of Hashimoto and Suenaga's Figure 2, as in data/scenes: 25 quadrics and a torus
/// between slab planes. Patches lie in the planes of the joints.
FamilyMember jointed_glass(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

}  // namespace lamina::scene
