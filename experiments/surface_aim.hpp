// Rays at a random point of a solid of the families `single` and `distant-ball`.
#pragma once

#include <optional>
#include <string>

#include "experiments/family_series.hpp"

namespace lamina::experiments {

/// From outside, at a uniformly random point of a face of the solid that is chosen at random,
/// each with equal odds (a ring: its outer side's normals are uniform). In a uniformly random
/// direction, or at a given angle to the surface, in radians. From `distance` away, times the
/// scale of the member.
Aim surface_aim(const std::string& solid, std::optional<double> angle, double distance,
                scene::Held held);

}  // namespace lamina::experiments
