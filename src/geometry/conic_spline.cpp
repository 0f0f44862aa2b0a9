#include "geometry/conic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::span<const PlanePoint>;

template <typename... Values>
[[noreturn]] void fail(fmt::format_string<Values...> reason, Values&&... values) {
  throw base::InputError(fmt::format(reason, std::forward<Values>(values)...));
}

void require_points(Points points) {
  if (points.size() < 2) {
    fail("a profile needs 2 points or more, here are {}", points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool end = i == 0 || i + 1 == points.size();
    if (points[i].u < 0 || (points[i].u.is_zero() && !end)) {
      fail("point {} of the profile has x = {}: it must be positive{}", i + 1,
           number::to_text(points[i].u),
           end ? " or zero" : ", as only the ends may be on the axis");
    }
    if (i > 0 && points[i - 1] == points[i]) {
      fail("point {} of the profile repeats point {}: leave one of them out", i + 1, i);
    }
    if (i > 0 && points[i - 1].v == points[i].v) {
      fail(
          "points {} and {} of the profile are both at y = {}: no conic of the spline is level, "
          "so move one of them",
          i, i + 1, number::to_text(points[i].v));
    }
  }
}

// 1 if the profile goes up after point i, -1 if down.
int direction(Points points, std::size_t i) { return sign(points[i + 1].v - points[i].v); }

bool turns_at(Points points, std::size_t i) {
  return i > 0 && i + 1 < points.size() && direction(points, i - 1) != direction(points, i);
}

template <typename Item>
std::map<std::size_t, Item> by_point(Points points, std::span<const Item> items,
                                     const std::string& what) {
  std::map<std::size_t, Item> result;
  for (const Item& item : items) {
    if (item.point < 1 || item.point > points.size()) {
      fail("the profile has no point {} for {}: it has {} points", item.point, what, points.size());
    }
    if (!result.emplace(item.point - 1, item).second) {
      fail("point {} of the profile has {} twice", item.point, what);
    }
  }
  return result;
}

// A point that conics end at.
struct Node {
  Rational y;
  Rational square;  // x^2
  std::optional<Rational> slope;
};

// Conics from its first to its last node, all in one direction.
struct Chain {
  std::vector<Node> nodes;
  std::size_t interval = 0;  // of the profile, from 1: from the first node to the second
  bool after_arc = false;
  bool before_last_arc = false;
};

Node node_on(const Arc& circle, const Rational& x, const Rational& y) {
  // The tangent of (x - d)^2 + (y - h)^2 = r^2.
  return {y, x * x, -2 * x * (y - circle.height) / (x - circle.major)};
}

// The sine and cosine of an angle, from the tangent of its half.
struct Direction {
  Rational cosine;
  Rational sine;
};

Direction direction_of(const Rational& half_angle) {
  const Rational square = half_angle * half_angle;
  return {(1 - square) / (1 + square), 2 * half_angle / (1 + square)};
}

struct PlacedArc {
  Arc arc;
  Node before;  // where the profile meets it, and where it leaves it
  Node after;
};

PlacedArc arc_at_turn(Points points, std::size_t i, const ArcAt& given) {
  const PlanePoint& tip = points[i];
  if (given.radius >= tip.u) {
    fail(
        "the arc at point {} of the profile has radius {}: it must be less than the point's x, "
        "{}",
        i + 1, number::to_text(given.radius), number::to_text(tip.u));
  }
  if (abs(given.half_angle) >= 1) {
    fail("the arc at point {} of the profile has half_angle {}: it must be between -1 and 1", i + 1,
         number::to_text(given.half_angle));
  }
  const PlanePoint& last = points[i - 1];
  const PlanePoint& next = points[i + 1];
  const int turn = sign((tip.u - last.u) * (next.v - tip.v) - (tip.v - last.v) * (next.u - tip.u));
  if (turn == 0) {
    fail("the profile turns back on itself at point {}: move the point after it", i + 1);
  }
  const int up = direction(points, i - 1);
  const Direction end = direction_of(given.half_angle);
  Arc arc{tip.u,
          given.radius,
          tip.v - up * given.radius,
          tip.v,
          tip.v,
          up > 0 ? ArcPart::Above : ArcPart::Below,
          turn,
          i};
  const Rational y = arc.height + up * given.radius * end.sine;
  (up > 0 ? arc.y_low : arc.y_high) = y;
  // With the solid inside the circle, the profile goes up at larger x than it goes down.
  const Rational half_width = up * turn * given.radius * end.cosine;
  return {arc, node_on(arc, tip.u + half_width, y), node_on(arc, tip.u - half_width, y)};
}

PlacedArc arc_at_end(Points points, std::size_t i, const ArcAt& given) {
  if (!points[i].u.is_zero()) {
    fail("the arc at point {} of the profile is at its end off the axis: leave it out", i + 1);
  }
  if (given.half_angle <= 0 || given.half_angle >= 1) {
    fail(
        "the arc at point {} of the profile, on the axis, has half_angle {}: it must be between 0 "
        "and 1",
        i + 1, number::to_text(given.half_angle));
  }
  const bool first = i == 0;
  const Rational& y = points[i].v;
  const int side = direction(points, first ? i : i - 1);
  const Direction end = direction_of(given.half_angle);
  const Rational x_end = given.radius * (1 - end.cosine);
  const Rational y_end = y + (first ? side : -side) * given.radius * end.sine;
  const Arc arc{given.radius,       given.radius,   y,    std::min(y, y_end),
                std::max(y, y_end), ArcPart::Inner, side, first ? 1 : i};
  const Node joint = node_on(arc, x_end, y_end);
  return {arc, joint, joint};
}

std::map<std::size_t, PlacedArc> placed_arcs(Points points, std::span<const ArcAt> given) {
  std::map<std::size_t, PlacedArc> arcs;
  for (const auto& [i, arc] : by_point(points, given, "an arc")) {
    if (arc.radius <= 0) {
      fail("the arc at point {} of the profile has radius {}: it must be positive", i + 1,
           number::to_text(arc.radius));
    }
    if (turns_at(points, i)) {
      arcs.emplace(i, arc_at_turn(points, i, arc));
    } else if (i == 0 || i + 1 == points.size()) {
      arcs.emplace(i, arc_at_end(points, i, arc));
    } else {
      fail("the profile does not turn at point {}, so it needs no arc there: leave it out", i + 1);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (turns_at(points, i) && !arcs.contains(i)) {
      fail("the profile turns at point {}, between points {} and {}: give it an arc there", i + 1,
           i, i + 2);
    }
  }
  return arcs;
}

std::vector<Chain> chains_between(Points points, const std::map<std::size_t, PlacedArc>& arcs,
                                  const std::map<std::size_t, SlopeAt>& slopes) {
  std::vector<Chain> chains(1);
  chains[0].interval = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto arc = arcs.find(i);
    const auto slope = slopes.find(i);
    if (arc == arcs.end()) {
      chains.back().nodes.push_back({points[i].v, points[i].u * points[i].u, {}});
      if (slope != slopes.end()) {
        chains.back().nodes.back().slope = slope->second.slope;
      }
      continue;
    }
    if (slope != slopes.end()) {
      fail("point {} of the profile has a slope and an arc: leave one of them out", i + 1);
    }
    if (i > 0) {
      chains.back().nodes.push_back(arc->second.before);
      chains.back().before_last_arc = i + 1 == points.size();
    }
    if (i == 0) {
      chains.back() = {{arc->second.after}, 1, true};
    } else if (i + 1 < points.size()) {
      chains.push_back({{arc->second.after}, i + 1, true});
    }
  }
  return chains;
}

void require_order(Points points, const Chain& chain) {
  for (std::size_t k = 1; k < chain.nodes.size(); ++k) {
    const std::size_t interval = chain.interval + k - 1;
    if (sign(chain.nodes[k].y - chain.nodes[k - 1].y) != direction(points, interval - 1)) {
      fail(
          "an arc between points {} and {} of the profile reaches past the next point or arc: "
          "make its radius smaller",
          interval, interval + 1);
    }
  }
}

Rational secant(const Node& a, const Node& b) { return (b.square - a.square) / (b.y - a.y); }

// The slope, but of the sign of both secants', and at most twice each; 0 if their signs differ.
Rational limited(const Rational& slope, const Rational& before, const Rational& after) {
  if (sign(before) * sign(after) <= 0 || sign(slope) != sign(before)) {
    return 0;
  }
  return sign(slope) * std::min({abs(slope), 2 * abs(before), 2 * abs(after)});
}

void add_slopes(Chain& chain) {
  std::vector<Node>& nodes = chain.nodes;
  const std::size_t last = nodes.size() - 1;
  // An end has only one secant.
  const auto after = [&](std::size_t k) {
    const std::size_t first = std::min(k, last - 1);
    return secant(nodes[first], nodes[first + 1]);
  };
  const auto before = [&](std::size_t k) { return after(k == 0 ? 0 : k - 1); };
  const auto set = [&](std::size_t k, const Rational& slope) {
    if (!nodes[k].slope) {
      nodes[k].slope = limited(slope, before(k), after(k));
    }
  };
  // One parabola from the other node to this one asks for that slope.
  const auto continue_to = [&](std::size_t k, std::size_t from) {
    if (!nodes[k].slope) {
      set(k, 2 * secant(nodes[from], nodes[k]) - *nodes[from].slope);
    }
  };
  if (chain.after_arc) {
    continue_to(1, 0);
  }
  if (chain.before_last_arc) {
    continue_to(last - 1, last);
  }
  for (std::size_t k = 1; k < last; ++k) {
    const Rational share = (nodes[k].y - nodes[k - 1].y) / (nodes[k + 1].y - nodes[k - 1].y);
    set(k, before(k) + share * (after(k) - before(k)));
  }
  if (last == 1 && !nodes[1].slope) {
    set(0, after(0));
  }
  continue_to(0, 1);
  continue_to(last, last - 1);
}

// The parabola through both nodes with the slope at the first: the other one follows.
Conic conic_between(const Node& a, const Node& b, std::size_t interval) {
  const Rational alpha = (secant(a, b) - *a.slope) / (b.y - a.y);
  const Rational beta = *a.slope - 2 * alpha * a.y;
  return {alpha,
          beta,
          a.square - (alpha * a.y + beta) * a.y,
          std::min(a.y, b.y),
          std::max(a.y, b.y),
          sign(b.y - a.y),
          interval};
}

// Schumaker 1983, lemma 2.3, gives the slope at any knot. The middle of the range of knots that
// lemma 2.5 allows for convex data is where the tangents at both ends meet, and the slope there is
// the secant's. Where the data have an inflection, or one parabola would do, the knot is halfway.
Node knot_between(const Node& a, const Node& b) {
  const Rational chord = secant(a, b);
  const Rational from = *a.slope - chord;
  const Rational to = *b.slope - chord;
  const Rational share = from * to < 0 ? Rational(to / (to - from)) : Rational(1) / 2;
  const Rational y = a.y + share * (b.y - a.y);
  const Rational slope = 2 * chord - (share * *a.slope + (1 - share) * *b.slope);
  return {y, a.square + share * (b.y - a.y) * (*a.slope + slope) / 2, slope};
}

// Its ends may be on the axis, where they are points of the profile.
void require_off_axis(const Conic& conic) {
  const bool turns = !conic.alpha.is_zero();
  const Rational vertex = turns ? Rational(-conic.beta / (2 * conic.alpha)) : conic.y_low;
  const Rational middle = (conic.y_low + conic.y_high) / 2;
  if (conic.square_at(conic.y_low) < 0 || conic.square_at(conic.y_high) < 0 ||
      conic.square_at(middle) <= 0 ||
      (vertex > conic.y_low && vertex < conic.y_high && conic.square_at(vertex) <= 0)) {
    fail("between points {} and {} the profile reaches the axis: give another slope at one of them",
         conic.interval, conic.interval + 1);
  }
}

std::vector<ProfilePiece> pieces_of(const Chain& chain) {
  std::vector<ProfilePiece> pieces;
  const std::vector<Node>& nodes = chain.nodes;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const Node& a = nodes[k - 1];
    const Node& b = nodes[k];
    const std::size_t interval = chain.interval + k - 1;
    const bool by_arc =
        (chain.after_arc && k == 1) || (chain.before_last_arc && k + 1 == nodes.size());
    std::vector<Node> ends{a, b};
    if (!by_arc || *a.slope + *b.slope != 2 * secant(a, b)) {
      ends.insert(ends.begin() + 1, knot_between(a, b));
    }
    for (std::size_t e = 1; e < ends.size(); ++e) {
      const Conic conic = conic_between(ends[e - 1], ends[e], interval);
      require_off_axis(conic);
      pieces.emplace_back(conic);
    }
  }
  return pieces;
}

}  // namespace

RevolvedProfile fit_conic_spline(Points points, std::span<const ArcAt> arcs,
                                 std::span<const SlopeAt> slopes) {
  require_points(points);
  const std::map<std::size_t, PlacedArc> placed = placed_arcs(points, arcs);
  std::vector<ProfilePiece> pieces;
  auto arc = placed.begin();
  const auto add_arc = [&] { pieces.emplace_back((arc++)->second.arc); };
  if (placed.contains(0)) {
    add_arc();
  }
  for (Chain& chain : chains_between(points, placed, by_point(points, slopes, "a slope"))) {
    require_order(points, chain);
    add_slopes(chain);
    const std::vector<ProfilePiece> conics = pieces_of(chain);
    pieces.insert(pieces.end(), conics.begin(), conics.end());
    if (arc != placed.end()) {
      add_arc();
    }
  }
  return RevolvedProfile(std::move(pieces));
}

}  // namespace lamina::geometry
