// The directions around a point, cut into cells by planes through it: exact.
#pragma once

#include <functional>
#include <span>

#include "geometry/vector.hpp"

namespace lamina::geometry {

using IntegerVector = Vector3<number::Integer>;

/// The direction along + e * across + e^2 * off, for every small enough e > 0.
struct LimitDirection {
  IntegerVector along;
  IntegerVector across;
  IntegerVector off;
};

/// Sign of normal . direction, exact.
int sign_along(const IntegerVector& normal, const LimitDirection& direction);

/// Called with a direction inside a cell and, for each normal n, the sign of n . direction,
/// which is never 0. Returns whether to go on.
using CellVisitor = std::function<bool(const LimitDirection&, std::span<const int> signs)>;

/// Visits each cell that the planes {d : n.d = 0} leave of space at least once, until `visit`
/// returns false.
///
/// Arguments: normals  one or more, none zero; parallel and equal ones are allowed.
/// Exact. Every cell has an edge along which two of the planes meet, a side plane at that
/// edge, and lies on one side of that plane: all such flags are visited. Where all planes
/// share a line, the edge is that line; where all are one plane, there are two cells.
/// Cost:      O(k^3) products for k normals.
void for_each_cell(std::span<const IntegerVector> normals, const CellVisitor& visit);

}  // namespace lamina::geometry
