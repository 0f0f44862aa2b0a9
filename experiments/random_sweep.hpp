// Random sweeps and rays for the experiments on van Wijk's sweeps, held exactly by every number
// type of 24 bits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "surface/sphere_sweep.hpp"

namespace lamina::experiments {

/// `translational`, `conic`, `rotational`: of a table's row.
std::string short_name(surface::Sweep sweep);

/// A sweep of a random contour: a star around a random centre, or, of half of the rotational ones,
/// a profile from the axis up to the axis. The points are multiples of 6/1024 below 4: a B-spline's
/// coefficients, which are sixths of sums of them, and a Catmull-Rom spline's, halves, are
/// multiples of 1/2048 and less than 64, which 17 bits hold. Splines that cross themselves, or get
/// left of the axis, are drawn anew.
surface::SweptSurface any_sweep(base::SeededStream& stream, surface::Sweep sweep,
                                geometry::ContourKind kind);

/// A ball of a radius from 1/4 to 1/2, along a random trajectory of 3 to 7 points in a cube of side
/// 3, closed or not. The coordinates are on the same grid, and need as few bits.
surface::SphereSweep any_sphere_sweep(base::SeededStream& stream, geometry::ContourKind kind);

/// How a ray lies to a sweep.
enum class RayKind : std::uint8_t {
  From,     ///< from `parameter` away at a random point of the sweep's box
  Grazing,  ///< in the tangent plane of a random point of the surface, `parameter` inside of it
  Joint,    ///< through a point where two pieces meet, exactly
  Along,    ///< along the axis, but for `parameter` across
  Level,    ///< across the axis, but for `parameter` along it
};

struct RayFamily {
  RayKind kind = RayKind::From;
  double parameter = 0;
  int held_bits = 24;  ///< of the ray's numbers

  [[nodiscard]] std::string name() const;
};

/// A ray in local coordinates. Its numbers have the family's bits: where these round it, that is
/// the ray.
geometry::ExactRay any_ray(base::SeededStream& stream, const surface::SweptSurface& surface,
                           const RayFamily& family);
/// The same; of kinds From and Grazing, which may be inside by another part of the trajectory.
geometry::ExactRay any_ray(base::SeededStream& stream, const surface::SphereSweep& surface,
                           const RayFamily& family);

}  // namespace lamina::experiments
