// Splines by polynomial pieces, one coordinate at a time: what contours and trajectories are made
// of; exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "number/rational.hpp"

namespace lamina::geometry {

/// What curve a polygon stands for (van Wijk 1984, section 2).
enum class ContourKind : std::uint8_t {
  Line,        ///< the polygon itself
  BSpline,     ///< the uniform cubic B-spline: near the points, with second-order continuity
  CatmullRom,  ///< the cubic Catmull-Rom spline: through the points, with first-order continuity
};

/// `line`, `bspline`, `catmull_rom`: what a scene calls them.
std::string_view name_of(ContourKind kind);
/// Throws base::InputError that lists them.
ContourKind parse_contour_kind(std::string_view name);

/// The value of a polynomial with these coefficients, ascending.
number::Rational value_at(std::span<const number::Rational> ascending, const number::Rational& s);

/// A coordinate of the piece between the second and the third of four points in a row: the
/// coefficients of 1, s, s^2, s^3 for 0 <= s <= 1; of a line the first two.
std::vector<number::Rational> spline_piece(ContourKind kind,
                                           const std::array<number::Rational, 4>& points);

/// The same polynomial in Bernstein's basis: a coordinate of the piece's Bezier control points.
/// Values for 0 <= s <= 1 are means of its coefficients. Contract: one coefficient at least.
std::vector<number::Rational> bezier(const std::vector<number::Rational>& ascending);

/// Of the points of a polygon, by their indices from 0. Throws base::InputError, which names the
/// point by its number from 1, if they are fewer than three (two of an open one), or two in a row
/// are equal.
void require_distinct_points(std::size_t count, bool closed,
                             const std::function<bool(std::size_t, std::size_t)>& are_equal);

}  // namespace lamina::geometry
