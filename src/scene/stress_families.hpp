// Members of the families of the stress experiments.
#pragma once

#include <cstdint>

#include "scene/placement.hpp"

namespace lamina::scene {

/// SOLID, same | scaled: a box, cylinder, cone, sphere or torus added to itself, the second of
/// another material (W&T Figure 14) and, scaled, three times as large at a third of the scale:
/// exactly the same solid, from other numbers.
FamilyMember self_sum(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// SOLID, same | scaled: a box, cylinder, cone or sphere less itself; the second has the same
/// equations, or the same times 3 (W&T Figure 15).
FamilyMember self_difference(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// N: so many unit cubes one on the other, of two materials in turn.
FamilyMember touching_stack(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// A sphere of radius 2 around the origin less one of radius 3/2 that touches it at (0, 0, 2)
/// from inside (W&T Figure 9).
FamilyMember thin_wall(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// G: a wide slab 0 <= z <= G.
FamilyMember slab(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// G: two wide slabs, -1 <= z <= 0 and G <= z <= G + 1.
FamilyMember gap(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// i | ii | iii | iv, G: the cases of W&T Figure 12 for A - B, surfaces G apart around z = 1.
FamilyMember four_cases(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// translated | scaled, K: a member of coincident-faces moved by 10^K along each axis, or
/// times 10^K.
FamilyMember far_origin(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// (A add C) - B: A is a half-space below the plane x + 2y + 3z = 7, B a slab that stands on that
/// plane, C a ball inside B. The equations of the plane are different multiples of one with
/// small integers: the surfaces coincide exactly in every number type. The plane is the patch.
FamilyMember cleared_face(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// K: so many transparent slabs of different materials and depths added up, the tops of all in
/// the plane x + 2y + 3z = 7, each by another multiple of its equation. The plane is the patch.
FamilyMember glass_stack(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// left | right | flat, N: so many slabs of different depths added up, their tops in the plane
/// x + 2y + 3z = 7, of two materials in turn; as a left-deep or right-deep chain of additions
/// of two, or as one of N. All shapes have the same media. The plane is the patch.
FamilyMember same_medium(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// cylinder | cone | slab: solids whose leaves are not closed, not rotated: of radius 1 around
/// the z axis, between z = -1 and 1; the cone has its apex at (0, 0, 1) and slope 1.
FamilyMember unclosed(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

/// ball | ring: a unit sphere around the origin, or a torus around the z axis, R = 1, r = 1/4.
FamilyMember round_solid(const Parameters&, std::uint64_t seed, std::uint64_t case_id);

}  // namespace lamina::scene
