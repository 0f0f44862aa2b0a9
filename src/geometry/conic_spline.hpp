// Conic splines: profiles through points, by conics and circular arcs that join smoothly; exact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/contour.hpp"
#include "geometry/revolved_profile.hpp"
#include "number/rational.hpp"

namespace lamina::geometry {

/// Points are named by their numbers from 1, as in messages.
struct SlopeAt {
  std::size_t point = 0;
  number::Rational slope;  ///< d(x^2)/dy, which is 2x dx/dy
};

/// An arc of a circle at a singular point (Hashimoto and Suenaga, section 2).
///
/// A point off the axis where the profile turns from up to down or back is the top or the bottom of
/// the circle. The arc ends at both sides at one height, so that one plane trims the torus: where
/// the radii of the circle are at an angle to the level, towards the point. Half that angle has the
/// tangent `half_angle`, from -1 to 1 exclusive; 0 is half a circle, with x' = 0 at both ends.
///
/// A point on the axis, at an end of the profile, is where the circle touches the axis. The arc
/// goes towards the other points by an angle up to 90 degrees; half of it has the tangent
/// `half_angle`, from 0 to 1 exclusive.
struct ArcAt {
  std::size_t point = 0;
  number::Rational radius;
  number::Rational half_angle;
};

/// Returns the profile through the points (x = u, y = v), in this order, which is that of
/// RevolvedProfile: the solid on the left.
///
/// With X = x^2 each conic is a parabola in (y, X). Between two points there are two, which make up
/// Schumaker's quadratic spline of one knot. An arc takes the place of one of them: in the interval
/// after it (before it, at the last point) one conic joins the arc to the next point, which gets
/// the slope that this asks for. There are two conics all the same where that slope is given,
/// belongs to another arc or would lose the shape of the points. So n points and k arcs give
/// 2 (n - 1) pieces, k of them arcs.
///
/// A slope that is not given is that of the parabola through the point and its two neighbours in
/// (y, X), but 0 where X has an extremum there, and at most twice the slope of each secant; at an
/// end, that of the parabola through the end and its neighbour with the neighbour's slope. Then X
/// is monotone and convex where the points are, and points on a conic give this conic, unless the
/// limit of twice a secant's slope is reached.
///
/// The limits cost accuracy next to extrema of X: where points are samples of a known curve, give
/// its slopes.
///
/// Exact: pieces interpolate the points, and join with equal x and equal x' in rationals; an arc
/// ends at rational points with rational slopes. x' is infinite where a conic meets the axis.
///
/// Throws base::InputError, which names the point, if there are fewer than two points, if a radius
/// x is negative, or zero between the ends, if two points in a row are equal or at one height, if
/// the profile turns at a point without an arc, if an arc is at a point where it does not turn, has
/// a radius that is not positive or not less than x, or reaches past a neighbour, if a point has
/// two slopes or two arcs, or a slope besides an arc, if slopes lead to the axis between points, or
/// if the pieces do not go round a solid.
///
/// Source: Hashimoto and Suenaga, section 2; Schumaker 1983.
RevolvedProfile fit_conic_spline(std::span<const PlanePoint> points, std::span<const ArcAt> arcs,
                                 std::span<const SlopeAt> slopes = {});

}  // namespace lamina::geometry
