#include "geometry/contour_crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::Integer;
using number::Rational;

// A point or a vector on a grid that is finer by 8 at each halving.
struct GridPoint {
  Integer u;
  Integer v;
};

// The control points of a cubic.
using Arc = std::array<GridPoint, 4>;

GridPoint operator+(const GridPoint& a, const GridPoint& b) { return {a.u + b.u, a.v + b.v}; }
GridPoint operator-(const GridPoint& a, const GridPoint& b) { return {a.u - b.u, a.v - b.v}; }
GridPoint operator*(int factor, const GridPoint& a) { return {factor * a.u, factor * a.v}; }

bool is_zero(const GridPoint& a) { return a.u.is_zero() && a.v.is_zero(); }
Integer dot(const GridPoint& a, const GridPoint& b) { return a.u * b.u + a.v * b.v; }
int cross_sign(const GridPoint& a, const GridPoint& b) {
  return number::sign(Integer(a.u * b.v - a.v * b.u));
}

Arc refined(const Arc& arc) { return {8 * arc[0], 8 * arc[1], 8 * arc[2], 8 * arc[3]}; }

// De Casteljau's halves, times 8.
std::pair<Arc, Arc> halves(const Arc& arc) {
  const GridPoint begin = arc[0] + arc[1];
  const GridPoint middle = arc[1] + arc[2];
  const GridPoint end = arc[2] + arc[3];
  const GridPoint left = begin + middle;
  const GridPoint right = middle + end;
  const GridPoint joint = left + right;
  return {Arc{8 * arc[0], 4 * begin, 2 * left, joint}, Arc{joint, 2 * right, 4 * end, 8 * arc[3]}};
}

struct Extent {
  Integer low;
  Integer high;

  [[nodiscard]] Integer length() const { return high - low; }
};

bool disjoint(const Extent& a, const Extent& b) { return a.high < b.low || b.high < a.low; }

Extent extent_along(const GridPoint& direction, const Arc& arc) {
  Extent extent{dot(direction, arc[0]), dot(direction, arc[0])};
  for (std::size_t k = 1; k < arc.size(); ++k) {
    const Integer position = dot(direction, arc[k]);
    extent.low = std::min(extent.low, position);
    extent.high = std::max(extent.high, position);
  }
  return extent;
}

struct Box {
  Extent u;
  Extent v;

  explicit Box(const Arc& arc) : u{arc[0].u, arc[0].u}, v{arc[0].v, arc[0].v} {
    for (const GridPoint& point : arc) {
      u = {std::min(u.low, point.u), std::max(u.high, point.u)};
      v = {std::min(v.low, point.v), std::max(v.high, point.v)};
    }
  }

  [[nodiscard]] Integer size() const { return std::max(u.length(), v.length()); }
};

bool disjoint(const Box& a, const Box& b) { return disjoint(a.u, b.u) || disjoint(a.v, b.v); }

bool separated_across_chord(const Arc& chord_of, const Arc& a, const Arc& b) {
  const GridPoint chord = chord_of[3] - chord_of[0];
  const GridPoint normal{-chord.v, chord.u};
  return disjoint(extent_along(normal, a), extent_along(normal, b));
}

// The angle, less than 180 degrees, between the extreme ones of some directions.
class Cone {
 public:
  // False if it would get to 180 degrees. A zero vector has no direction.
  bool add(const GridPoint& vector) {
    if (is_zero(vector)) {
      return true;
    }
    if (is_empty_) {
      right_ = left_ = vector;
      is_empty_ = false;
      return true;
    }
    const int to_right = cross_sign(right_, vector);
    const int to_left = cross_sign(left_, vector);
    if (to_right == 0 && to_left == 0) {
      return dot(right_, vector) > 0;
    }
    if (to_right > 0 && to_left > 0) {
      left_ = vector;
      return true;
    }
    if (to_right < 0 && to_left < 0) {
      right_ = vector;
      return true;
    }
    return to_right >= 0 && to_left <= 0;
  }

  bool add_derivatives(const Arc& arc) {
    return add(arc[1] - arc[0]) && add(arc[2] - arc[1]) && add(arc[3] - arc[2]);
  }

 private:
  bool is_empty_ = true;
  GridPoint right_;
  GridPoint left_;
};

// Where the control vectors of the derivative are in an open half-plane, or zero but not all of
// them, the curve advances strictly along its middle, since Bernstein polynomials are positive
// inside (0, 1): it cannot come back to where it was.
bool advances(const Arc& arc) { return Cone().add_derivatives(arc); }
bool advances(const Arc& first, const Arc& second) {
  Cone cone;
  return cone.add_derivatives(first) && cone.add_derivatives(second);
}

// Have two parts that share no end no point in common? Halves the larger one, so that a small
// part is not cut to dust beside a large one.
bool are_apart(const Arc& a, const Arc& b, int halvings) {
  const Box box_a(a);
  const Box box_b(b);
  if (disjoint(box_a, box_b) || separated_across_chord(a, a, b) ||
      separated_across_chord(b, a, b)) {
    return true;
  }
  if (halvings == 0) {
    return false;
  }
  const bool cut_a = box_a.size() > box_b.size();
  const auto [left, right] = halves(cut_a ? a : b);
  const Arc other = refined(cut_a ? b : a);
  return are_apart(left, other, halvings - 1) && are_apart(right, other, halvings - 1);
}

// Have two parts, the second of which begins where the first ends, that point only in common?
bool meet_at_joint_only(const Arc& first, const Arc& second, int halvings) {
  if (advances(first, second)) {
    return true;
  }
  if (halvings == 0) {
    return false;
  }
  const auto [first_left, first_right] = halves(first);
  const auto [second_left, second_right] = halves(second);
  return meet_at_joint_only(first_right, second_left, halvings - 2) &&
         are_apart(first_left, second_left, halvings - 2) &&
         are_apart(first_left, second_right, halvings - 2) &&
         are_apart(first_right, second_right, halvings - 2);
}

bool is_simple(const Arc& arc, int halvings) {
  if (advances(arc)) {
    return true;
  }
  if (halvings == 0) {
    return false;
  }
  const auto [left, right] = halves(arc);
  return is_simple(left, halvings - 2) && is_simple(right, halvings - 2) &&
         meet_at_joint_only(left, right, halvings - 2);
}

Integer common_denominator(std::span<const ControlPolygon> pieces) {
  Integer common = 1;
  for (const ControlPolygon& piece : pieces) {
    for (const PlanePoint& point : piece) {
      common = lcm(common, lcm(Integer(denominator(point.u)), Integer(denominator(point.v))));
    }
  }
  return common;
}

GridPoint on_grid(const PlanePoint& point, const Integer& scale) {
  return {Integer(numerator(Rational(point.u * scale))),
          Integer(numerator(Rational(point.v * scale)))};
}

std::vector<Arc> arcs_on_grid(std::span<const ControlPolygon> pieces) {
  const Integer scale = common_denominator(pieces);
  std::vector<Arc> arcs;
  for (const ControlPolygon& piece : pieces) {
    // A line's ends are doubled: the same points, and derivatives in the same direction.
    const std::size_t last = piece.size() - 1;
    arcs.push_back({on_grid(piece[0], scale), on_grid(piece[last == 1 ? 0 : 1], scale),
                    on_grid(piece[last == 1 ? 1 : 2], scale), on_grid(piece[last], scale)});
  }
  return arcs;
}

void require_simple_pieces(const std::vector<Arc>& arcs, int halvings) {
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (!is_simple(arcs[i], halvings)) {
      throw base::InputError(
          fmt::format("the contour crosses or touches itself: the piece at point {} has a loop or "
                      "a cusp; move the points next to it",
                      i + 1));
    }
  }
}

enum class Place : std::uint8_t { Apart, InRow, AcrossStart };

Place place_of(std::size_t i, std::size_t j, std::size_t count, bool closed) {
  if (j == i + 1) {
    return Place::InRow;
  }
  return closed && i == 0 && j + 1 == count ? Place::AcrossStart : Place::Apart;
}

bool meet_as_they_should(const Arc& a, const Arc& b, Place place, int halvings) {
  switch (place) {
    case Place::InRow:
      return meet_at_joint_only(a, b, halvings);
    case Place::AcrossStart:
      return meet_at_joint_only(b, a, halvings);
    case Place::Apart:
      break;
  }
  return are_apart(a, b, halvings);
}

// Most pairs are far apart, as the boxes of the whole pieces tell.
void require_simple_pairs(const std::vector<Arc>& arcs, bool closed, int halvings) {
  const std::vector<Box> boxes(arcs.begin(), arcs.end());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      const Place place = place_of(i, j, arcs.size(), closed);
      if (place == Place::Apart && disjoint(boxes[i], boxes[j])) {
        continue;
      }
      if (!meet_as_they_should(arcs[i], arcs[j], place, halvings)) {
        throw base::InputError(
            fmt::format("the contour crosses or touches itself: the piece at point {} meets the "
                        "one at point {}{}; move the points there",
                        i + 1, j + 1, place == Place::Apart ? "" : " beyond their common end"));
      }
    }
  }
}

}  // namespace

void require_no_crossing(std::span<const ControlPolygon> pieces, bool closed) {
  LAMINA_REQUIRE(!pieces.empty(), "one piece or more");
  const std::vector<Arc> arcs = arcs_on_grid(pieces);
  // For two lines the tests decide as they are. Halvings alternate between two cubics: 40 of each.
  const int halvings = pieces[0].size() == 2 ? 0 : 80;
  require_simple_pieces(arcs, halvings);
  require_simple_pairs(arcs, closed, halvings);
}

}  // namespace lamina::geometry
