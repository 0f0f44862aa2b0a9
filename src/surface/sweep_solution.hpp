// Rays at a sweep through some rounded number type, exact numbers in and out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surface/parity_trimming.hpp"
#include "surface/sphere_sweep.hpp"

namespace lamina::surface {

/// How the crossings of a ray are computed. Sphere sweeps have none but the solvers.
struct SweepMethod {
  enum class Caps : std::uint8_t {
    None,        ///< the swept surface alone
    Parity,      ///< the solid, as trim_by_parity counts it
    HalfSpaces,  ///< the same solid: where the surface's half-space and those of z >= 0 and z <= 1
                 ///< have a point in common, each of them entered and left at its own crossings
  };

  poly::Solvers solvers{};
  AsPrinted printed{};
  Caps caps = Caps::None;
  /// Of the n crossings of the swept surface, that with this index modulo n is lost on purpose.
  std::optional<std::uint64_t> lost{};
};

struct FoundCrossing {
  number::Rational t;
  number::Rational s;
  std::uint32_t piece = 0;
  geometry::ExactPoint normal;  ///< at o + t d as the number type has it; zero on a cap
};

/// Rounds the sweep and the ray to the number type, and crosses what they are then. Ascending in t.
template <number::RoundedNumber Number>
std::vector<FoundCrossing> cross_sweep(const AnySweep& surface, const geometry::ExactRay& local,
                                       const SweepMethod& method);

/// Returns the seconds that one pass over rays takes, each at the surface of its index, without
/// rounding these.
template <number::RoundedNumber Number>
double seconds_to_cross(const std::vector<AnySweep>& surfaces,
                        const std::vector<geometry::ExactRay>& local, const SweepMethod& method);

}  // namespace lamina::surface
