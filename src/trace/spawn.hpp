// How a ray is spawned at a hit: which branch, and from where.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"

namespace lamina::trace {

enum class Branch : std::uint8_t {
  Reflection,
  Transmission,
  Shadow,  ///< towards a light
};

/// Where a spawned ray starts, given the rounded hit point p, and what it knows of the surface
/// that it leaves.
struct SpawnPolicy {
  enum class Kind : std::uint8_t {
    None,          ///< at p
    Offset,        ///< at p + epsilon along the ray (W&T 2)
    NormalOffset,  ///< at p + epsilon along the normal, to the side the ray goes to
    /// At p, each coordinate moved along the normal n by (int)(multiple n) units in its last
    /// place, or by n / 65536, in every number type, where |p| < 1/32 (Wächter and Binder, Ray
    /// Tracing Gems, ch. 6, who add to the integer representation: the same but where a move
    /// crosses a power of two).
    UlpOffset,
    /// At p, moved along the normal by a bound of p's distance to the surface, and then each
    /// coordinate to the next number (pbrt, 4th edition, 6.8); see RayEvents::distance_bound.
    ErrorBound,
    /// At p; the hit leaf is as the hit makes it, and its events that contradict that are
    /// rejected, by methods that reject none otherwise too (W&T 3.5). A method without states,
    /// as wyvill-sharp, has none to hand on: to it this is None.
    LeafState,
    /// At p; the root s = 0 of the surface just left is divided out of the polynomials of all
    /// leaves that share it, instead of being searched for.
    DivideOut,
  };

  std::string name{"none"};  ///< as it is spelled, and as it stands in tables
  Kind kind = Kind::None;
  number::Rational epsilon{0};    ///< for the two offsets; always stated
  bool relative_epsilon = false;  ///< times the largest of |o|, |p| and the scene, by coordinates
  int ulps = 256;                 ///< for UlpOffset
};

/// Returns the policy that the text spells:
///   none | offset:E[:relative] | normal-offset:E[:relative] | ulp-offset[:N] | error-bound |
///   leaf-state | divide-out
/// Throws base::InputError that lists these.
SpawnPolicy parse_spawn(std::string_view text);

/// Spellings separated by commas.
std::vector<SpawnPolicy> parse_spawns(std::string_view text);

struct SpawnHelp {
  std::string spelling;
  std::string meaning;
};
/// One line for each spelling: the text and what it means.
std::vector<SpawnHelp> spawn_help();

/// One ray to spawn. Transmitted rays are refracted by the indices of the two media of the
/// interface that is reported.
struct Spawn {
  Branch branch = Branch::Reflection;
  SpawnPolicy policy{};
  geometry::ExactPoint light{};  ///< for shadow rays
};

}  // namespace lamina::trace
