#include "geometry/revolved_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Layer = RevolvedProfile::Layer;

const Rational& low(const ProfilePiece& piece) {
  return std::visit([](const auto& p) -> const Rational& { return p.y_low; }, piece);
}

const Rational& high(const ProfilePiece& piece) {
  return std::visit([](const auto& p) -> const Rational& { return p.y_high; }, piece);
}

int side(const ProfilePiece& piece) {
  return std::visit([](const auto& p) { return p.side; }, piece);
}

std::size_t interval(const ProfilePiece& piece) {
  return std::visit([](const auto& p) { return p.interval; }, piece);
}

// An arc around a point where the profile turns: it passes the same height twice.
bool is_turn(const ProfilePiece& piece) {
  const Arc* arc = std::get_if<Arc>(&piece);
  return arc != nullptr && arc->part != ArcPart::Inner;
}

std::vector<Layer> chains(const std::vector<ProfilePiece>& pieces) {
  std::vector<Layer> layers;
  bool alone = true;
  for (const ProfilePiece& piece : pieces) {
    if (alone || is_turn(piece) || side(piece) != layers.back().side) {
      layers.push_back({side(piece), {}});
    }
    layers.back().pieces.push_back(piece);
    alone = is_turn(piece);
  }
  return layers;
}

Rational lowest(const Layer& layer) {
  return std::min(low(layer.pieces.front()), low(layer.pieces.back()));
}

Rational highest(const Layer& layer) {
  return std::max(high(layer.pieces.front()), high(layer.pieces.back()));
}

Conic cylinder(const Arc& arc, const Rational& radius) {
  return {0, 0, radius * radius, arc.y_low, arc.y_high, arc.side, arc.interval};
}

// Conics between which the piece lies.
std::vector<Conic> envelope(const ProfilePiece& piece) {
  if (const Conic* conic = std::get_if<Conic>(&piece)) {
    return {*conic};
  }
  const Arc& arc = std::get<Arc>(piece);
  const Rational outer = arc.part == ArcPart::Inner ? arc.major : Rational(arc.major + arc.minor);
  return {cylinder(arc, arc.major - arc.minor), cylinder(arc, outer)};
}

// 1 if a is outside b at all heights that they share, -1 if inside, 0 if they share none. At the
// ends of these heights they may touch.
int compare(const Conic& a, const Conic& b) {
  const Rational from = std::max(a.y_low, b.y_low);
  const Rational to = std::min(a.y_high, b.y_high);
  if (from >= to) {
    return 0;
  }
  const auto sign_at = [&](const Rational& y) { return sign(a.square_at(y) - b.square_at(y)); };
  const int middle = sign_at((from + to) / 2);
  bool apart = middle != 0 && sign_at(from) != -middle && sign_at(to) != -middle;
  if (const Rational alpha = a.alpha - b.alpha; !alpha.is_zero()) {
    const Rational vertex = (b.beta - a.beta) / (2 * alpha);
    apart = apart && (vertex <= from || vertex >= to || sign_at(vertex) == middle);
  }
  if (!apart) {
    throw base::InputError(
        fmt::format("the profile between points {} and {} crosses or touches itself between points "
                    "{} and {}: move the points apart",
                    a.interval, a.interval + 1, b.interval, b.interval + 1));
  }
  return middle;
}

int compare(const Layer& a, const Layer& b) {
  int result = 0;
  for (const ProfilePiece& p : a.pieces) {
    for (const ProfilePiece& q : b.pieces) {
      for (const Conic& conic_p : envelope(p)) {
        for (const Conic& conic_q : envelope(q)) {
          const int here = compare(conic_p, conic_q);
          if (here * result < 0) {
            throw base::InputError(fmt::format(
                "the profile crosses itself between point {} and point {}: move the points apart",
                std::min(interval(p), interval(q)), std::max(interval(p), interval(q)) + 1));
          }
          result = here != 0 ? here : result;
        }
      }
    }
  }
  return result;
}

// Curves that are monotone in height and do not cross can always be ordered so.
std::vector<Layer> from_outside_in(std::vector<Layer> layers) {
  for (auto next = layers.begin(); next != layers.end(); ++next) {
    const auto outermost = std::find_if(next, layers.end(), [&](const Layer& candidate) {
      return std::none_of(next, layers.end(), [&](const Layer& other) {
        return &other != &candidate && compare(other, candidate) > 0;
      });
    });
    LAMINA_REQUIRE(outermost != layers.end(), "layers that lie in one another");
    std::rotate(next, outermost, std::next(outermost));
  }
  return layers;
}

void require_alternation(const std::vector<Layer>& layers) {
  std::set<Rational> heights;
  for (const Layer& layer : layers) {
    heights.insert({lowest(layer), highest(layer)});
  }
  for (auto y = heights.begin(); std::next(y) != heights.end(); ++y) {
    int outside = -1;
    for (const Layer& layer : layers) {
      if (lowest(layer) > *y || highest(layer) <= *y) {
        continue;
      }
      if (layer.side == outside) {
        throw base::InputError(
            fmt::format("the profile between points {} and {} has the solid on its wrong side: "
                        "state the points so that the solid is on the left, up outside and down "
                        "inside, and begin and end it on the axis or where a level line to the "
                        "axis can close it",
                        interval(layer.pieces.front()), interval(layer.pieces.back()) + 1));
      }
      if (!is_turn(layer.pieces.front())) {
        outside = layer.side;
      }
    }
  }
}

PlanePoint point_at(const Contour& contour, const Rational& parameter) {
  const std::span<const ContourPiece> pieces = contour.pieces();
  const std::size_t piece = std::min(
      static_cast<std::size_t>(numerator(parameter) / denominator(parameter)), pieces.size() - 1);
  const Rational s = parameter - piece;
  return {value_at(pieces[piece].u, s), value_at(pieces[piece].v, s)};
}

// x is linear in y.
Conic cone(const PlanePoint& p, const PlanePoint& q, std::size_t interval) {
  const Rational slope = (q.u - p.u) / (q.v - p.v);
  const Rational at_zero = p.u - slope * p.v;
  return {slope * slope,      2 * slope * at_zero, at_zero * at_zero, std::min(p.v, q.v),
          std::max(p.v, q.v), sign(q.v - p.v),     interval};
}

}  // namespace

Rational Conic::square_at(const Rational& y) const { return (alpha * y + beta) * y + gamma; }

Rational Conic::slope_at(const Rational& y) const { return 2 * alpha * y + beta; }

RevolvedProfile::RevolvedProfile(std::vector<ProfilePiece> pieces) : pieces_(std::move(pieces)) {
  LAMINA_REQUIRE(!pieces_.empty(), "a profile without pieces");
  layers_ = from_outside_in(chains(pieces_));
  require_alternation(layers_);
}

RevolvedProfile inscribed_cones(const Contour& contour, std::size_t count) {
  if (count == 0) {
    throw base::InputError("a profile of cones needs 1 piece or more");
  }
  contour.require_right_of_axis();
  std::vector<PlanePoint> points;
  for (std::size_t i = 0; i <= count; ++i) {
    points.push_back(point_at(contour, Rational(i * contour.pieces().size(), count)));
  }
  if (contour.orientation() < 0) {
    std::reverse(points.begin(), points.end());
  }
  std::vector<ProfilePiece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const bool on_axis = points[i].u.is_zero() && points[i + 1].u.is_zero();
    if (points[i].v != points[i + 1].v && !on_axis) {
      pieces.emplace_back(cone(points[i], points[i + 1], i + 1));
    }
  }
  if (pieces.empty()) {
    throw base::InputError(
        fmt::format("{} straight pieces leave nothing of the contour: use more", count));
  }
  return RevolvedProfile(std::move(pieces));
}

}  // namespace lamina::geometry
