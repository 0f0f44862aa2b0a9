// Rays that graze a sphere or a torus.
#pragma once

#include "experiments/family_series.hpp"

namespace lamina::experiments {

/// Rays from `distance` away that pass the surface of a member of the family `round` at a
/// random point, 10^-k to 10^-(k+1) below the tangent plane there, or above it, in even
/// odds. Held by double: float cannot come so near.
Aim grazing_aim(const std::string& solid, int k, double distance);

}  // namespace lamina::experiments
