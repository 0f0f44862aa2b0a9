// Rays at a random point of a solid of the families `single` and `distant-ball`.
#pragma once

#include <optional>
#include <string>

#include "experiments/family_series.hpp"

namespace lamina::experiments {

/// From outside, at a random point of a face of the solid that is chosen at random, each with
/// equal odds: uniform on flat faces and on the ball, in angle and height on round sides, in the
/// normal on a ring. In a uniformly random direction, or at a given angle to the surface, in
/// radians, but for rounding: a chord at the angle a is a^2 / 2 deep, which must be more than the
/// rounding of the ray. From `distance` away, times the scale of the member.
Aim surface_aim(const std::string& solid, std::optional<double> angle, double distance,
                scene::Held held);

}  // namespace lamina::experiments
