// Does a curve in Bezier pieces cross or touch itself? Decided in integers.
#pragma once

#include <span>
#include <vector>

#include "geometry/contour.hpp"

namespace lamina::geometry {

/// The Bezier control points of a piece: two of a line, four of a cubic.
using ControlPolygon = std::vector<PlanePoint>;

/// Throws base::InputError, which names the pieces by their numbers from 1 as points, if the curve
/// crosses itself, touches itself or turns back on itself at a spike or a cusp; each piece begins
/// where the one before it ends. Exact for lines. Parts of cubics that are not told apart at 2^-40
/// of their size, such as touching ones, count as touching.
void require_no_crossing(std::span<const ControlPolygon> pieces, bool closed);

}  // namespace lamina::geometry
