// Seeded families of degenerate scenes: any member is named, and replays alone.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace lamina::scene {

/// One member of a family: its text in the scene language, so that it can be written to a
/// file, read by people and changed; and where rays find what it is about, in double, since
/// rays need not hit it exactly.
struct FamilyMember {
  std::string text;
  /// A patch of the surface where leaves coincide: corner + u * side1 + v * side2 with u, v in
  /// 0 .. 1, in world coordinates.
  struct Patch {
    geometry::Vector3<double> corner;
    geometry::Vector3<double> side1;
    geometry::Vector3<double> side2;
  };
  std::vector<Patch> patches;
  /// From the coordinates in which the family is described to the world's.
  std::function<geometry::Vector3<double>(const geometry::Vector3<double>&)> place;
};

/// A family: its members differ by seed and case, and in kind by parameters.
struct Family {
  std::string name;
  std::string parameters;  ///< as they are spelled, `:SOLID`, for people; or empty
  std::string about;       ///< one line
  /// Throws base::InputError for parameters that it does not have.
  FamilyMember (*member)(const std::vector<std::string>& parameters, std::uint64_t seed,
                         std::uint64_t case_id);
};

const std::vector<Family>& families();

/// Returns a member. `family` is its name with the parameters, as in `self-sum:torus`. Throws
/// base::InputError that lists the families.
FamilyMember family_member(const std::string& family, std::uint64_t seed, std::uint64_t case_id);

/// Pairs and triples of boxes, cylinders, cones, spheres and tori that share faces or whole
/// surfaces, under all operators, mostly rotated by a rational rotation.
FamilyMember coincident_faces(std::uint64_t seed, std::uint64_t case_id);

/// Wyvill and Trotman's Figure 4: two closed cylinders of different materials whose tops lie in
/// one plane; radii, heights, places and order vary, mostly rotated.
FamilyMember ghost_cylinders(std::uint64_t seed, std::uint64_t case_id);

/// `family:FAMILY:SEED:CASE`, which open_scene reads.
std::string family_spelling(const std::string& family, std::uint64_t seed, std::uint64_t case_id);

/// Reads a scene by what the user wrote: a file, or a member of a family.
Scene open_scene(const std::string& spelling, const ReadOptions& options = {});

}  // namespace lamina::scene
