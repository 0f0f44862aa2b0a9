// Rays that graze a sphere.
#pragma once

#include "experiments/family_series.hpp"

namespace lamina::experiments {

/// Rays from `distance` away that pass the unit sphere of the family `ball` 10^-k to
/// 10^-(k+1) below its surface, or above it for every other ray. Held by double: float cannot
/// come so near.
Aim grazing_aim(int k, double distance);

}  // namespace lamina::experiments
