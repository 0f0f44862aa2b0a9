// The solids that van Wijk's sweeps bound with cap planes, exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surface/swept_surface.hpp"

namespace lamina::experiments {

struct SolidCrossing {
  number::Root t;
  std::uint32_t piece = 0;  ///< or surface::kBasePlane, surface::kCapPlane
};

/// Where a ray in local coordinates enters or leaves the part of a sweep with 0 <= z <= 1, or all
/// of a rotational one: ascending, exact. What is crossed at one t is crossed at once. Nothing for
/// a ray that runs along the surface or in a plane of a cap.
std::optional<std::vector<SolidCrossing>> solid_crossings(const surface::SweptSurface& surface,
                                                          const geometry::ExactRay& local);

}  // namespace lamina::experiments
