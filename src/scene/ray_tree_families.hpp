// Members of the families of the experiments on ray trees.
#pragma once

#include <cstdint>

#include "scene/placement.hpp"

namespace lamina::scene {

/// SOLID, K: a box, cylinder, cone or ball of half-width 1 around the origin, or a torus (ring)
/// of radii 1 and 1/4, placed at random and then scaled by 10^K.
FamilyMember single(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// K: a unit ball placed at random near the origin and then moved by 10^K along each axis; not
/// moved for K = 0.
FamilyMember distant_ball(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// plain | doubled: a block less a unit ball (W&T Figure 8, inside of a bubble); doubled, the
/// block is added to itself, and the ball taken away twice.
FamilyMember bubble(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// plain | doubled: a block less a box that opens it from above: a square well, 1 wide and 40
/// deep, around the z axis; its bottom is at z = 0. Doubled, the block is added to itself, and
/// the box taken away twice.
FamilyMember well(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// plain | doubled: a corner of three faces that meet in the origin, seen from x, y, z > 0;
/// doubled as a well is.
FamilyMember cube_corner(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// N: so many plates of glasses of different refractive indices, each 1 thick, one on the other;
/// the patch is the top.
FamilyMember plates(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// N: balls of different glasses around one centre, of radii N to 1, the smaller ones added to
/// the larger.
FamilyMember onion(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

}  // namespace lamina::scene
