// How far a profile of conics, arcs and cones is from the contour it stands for.
#pragma once

#include <cstddef>

#include "geometry/contour.hpp"
#include "geometry/revolved_profile.hpp"

namespace lamina::geometry {

struct FitError {
  double distance = 0;   ///< the greatest from a point of one curve to the other curve
  double angle_rad = 0;  ///< the greatest between the normals at a point of the contour and at the
                         ///< point of the profile nearest to it
};

/// Returns the error of a profile against the contour, by dense sampling in double.
///
/// Both curves are closed by level lines: the profile where its radius jumps at a height and, if
/// it is not closed itself, to the axis; the contour has its own. Each piece is sampled at
/// `samples` + 1 points: a contour's at equal steps of its parameter, an arc at equal angles, and a
/// conic at the heights of equal angles on a half circle, which are dense towards both ends, where
/// x' may be infinite. The nearest point is sought on the polygon through the other curve's
/// samples, and the normal there is interpolated between the samples' own, so that straight pieces
/// keep theirs. Distances are those of samples of both curves, angles those halfway between samples
/// of the contour: none is at its corners, where it has two. Where the curves are farther apart
/// than a wall is thick, the nearest point may be on the wall's other side, with the normal of
/// that.
///
/// Error: a sampled maximum, below the true one by O(1 / samples); a polygon differs from its curve
///        by O(1 / samples^2).
/// Cost:  the product of the two numbers of samples.
FitError fit_error(const RevolvedProfile& profile, const Contour& contour,
                   std::size_t samples = 32);

}  // namespace lamina::geometry
