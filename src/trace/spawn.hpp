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

/// Where a spawned ray starts, given the rounded hit point p, whatever the method.
struct SpawnPolicy {
  enum class Kind : std::uint8_t {
    None,          ///< at p
    Offset,        ///< at p + epsilon along the ray (W&T 2)
    NormalOffset,  ///< at p + epsilon along the normal, to the side the ray goes to
    /// At p, each coordinate moved along the normal n by (int)(multiple n) units in its last
    /// place, or by n / 65536 where |p| < 1/32 (Wächter and Binder, Ray Tracing Gems, ch. 6).
    UlpOffset,
  };

  std::string name{"none"};  ///< as it is spelled, and as it stands in tables
  Kind kind = Kind::None;
  number::Rational epsilon{0};    ///< for the two offsets; always stated
  bool relative_epsilon = false;  ///< times the largest coordinate of the ray's origin and p
  int ulps = 256;                 ///< for UlpOffset
};

/// Returns the policy that the text spells:
///   none | offset:E[:relative] | normal-offset:E[:relative] | ulp-offset[:N]
/// Throws base::InputError that lists these.
SpawnPolicy parse_spawn(std::string_view text);

struct SpawnHelp {
  std::string spelling;
  std::string meaning;
};
/// One line for each spelling: the text and what it means.
std::vector<SpawnHelp> spawn_help();

/// One ray to spawn.
struct Spawn {
  Branch branch = Branch::Reflection;
  SpawnPolicy policy{};
  number::Rational index_ratio{1};  ///< of the medium the ray comes from to that it goes to
  geometry::ExactPoint light{};     ///< for shadow rays
};

}  // namespace lamina::trace
