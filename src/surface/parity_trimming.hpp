// Solids that swept contours bound with cap planes, by van Wijk's counting.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/rounded_sweep.hpp"

namespace lamina::surface {

/// In place of a piece: a crossing of the plane z = 0, or z = 1; its s is 0.
inline constexpr std::uint32_t kBasePlane = UINT32_MAX - 1;
inline constexpr std::uint32_t kCapPlane = UINT32_MAX;

/// Takes the crossings of a ray in local coordinates with the swept surface, ascending in t over
/// the whole line, to those with the solid: a translational sweep's between z = 0 and z = 1, a
/// conic sweep's from its apex at z = 0 to z = 1, all of a rotational sweep. By the array of van
/// Wijk 1984:
/// - translational (section 3): those past the nearer plane are kept; the farther plane is crossed
///   if an odd number of them is beyond it, which is cut off; then the nearer, if that leaves an
///   odd number;
/// - conic (section 4): those between the planes are kept; the cap is crossed if their number is
///   odd;
/// - rotational (section 5): all are kept, there are no caps.
///
/// A side crossing at the very t of a plane counts as beyond the nearer, in conic sweeps, or the
/// farther. For a ray with d_z = 0 all or none are kept, by o_z, unless there is a small value to
/// take for d_z; one along z that is in a translational sweep has crossings only with small values.
///
/// Error:  one crossing lost or found twice flips a cap.
template <number::RoundedNumber Number>
void trim_by_parity(const RoundedSweep<Number>& sweep, const geometry::Ray<Number>& local,
                    std::vector<typename RoundedSweep<Number>::Crossing>& crossings);

}  // namespace lamina::surface
