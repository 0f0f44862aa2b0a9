#include "support/reference_sphere_sweep.hpp"

#include <algorithm>

#include "support/reference_polynomial.hpp"
#include "support/reference_roots.hpp"

namespace lamina::reference {

using number::Integer;
using number::Rational;
using Bounds = SweptBall::Bounds;
using Piece = SweptBall::Piece;
using Point = SweptBall::Point;

namespace {

// Most rays are answered by the first; the second is for what that leaves inseparable.
constexpr std::array<int, 2> kBits{96, 512};

Polynomial slope(const Polynomial& a) {
  Polynomial result;
  for (std::size_t i = 1; i < a.size(); ++i) {
    result.push_back(static_cast<int>(i) * a[i]);
  }
  return result;
}

Rational at(const Polynomial& polynomial, const Rational& u) {
  Rational value = 0;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    value = value * u + *c;
  }
  return value;
}

// Intervals of rationals.
Bounds operator+(const Bounds& a, const Bounds& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}

Bounds operator*(const Bounds& a, const Bounds& b) {
  const std::array products{Rational(a.lower * b.lower), Rational(a.lower * b.upper),
                            Rational(a.upper * b.lower), Rational(a.upper * b.upper)};
  const auto [least, most] = std::minmax_element(products.begin(), products.end());
  return {*least, *most};
}

Bounds over(const Polynomial& polynomial, const Bounds& u) {
  Bounds value{0, 0};
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    value = value * u + Bounds{*c, *c};
  }
  return value;
}

// Not above the square root; less than 2^-bits off.
Rational root_below(const Rational& square, unsigned bits) {
  if (square <= 0) {
    return 0;
  }
  const Rational scaled = square * Rational(Integer(1) << (2 * bits));
  return {sqrt(Integer(numerator(scaled) / denominator(scaled))), Integer(1) << bits};
}

// The roots in 0 < u < 1; nothing if one cannot be told from an end.
std::optional<std::vector<Bounds>> roots_within(const Polynomial& polynomial, int bits) {
  std::vector<Bounds> result;
  const std::vector<Integer> ascending = whole(polynomial);
  if (ascending.size() < 2) {
    return result;
  }
  for (const RealRoot& root : real_roots(ascending, bits)) {
    for (const Rational& end : {Rational(0), Rational(1)}) {
      if (root.lower <= end && end <= root.upper && at(polynomial, end) != 0) {
        return std::nullopt;
      }
    }
    if (root.lower > 0 && root.upper < 1) {
      result.push_back({root.lower, root.upper});
    }
  }
  return result;
}

Polynomial one_coordinate(PlaneCurve::Kind kind, const std::array<Rational, 4>& p) {
  const auto& [p0, p1, p2, p3] = p;
  switch (kind) {
    case PlaneCurve::Kind::Line:
      return {p1, p2 - p1};
    case PlaneCurve::Kind::BSpline:
      return scaled(Rational(1, 6), {p0 + 4 * p1 + p2, 3 * p2 - 3 * p0, 3 * p0 - 6 * p1 + 3 * p2,
                                     p3 - 3 * p2 + 3 * p1 - p0});
    case PlaneCurve::Kind::CatmullRom:
      return scaled(Rational(1, 2),
                    {2 * p1, p2 - p0, 2 * p0 - 5 * p1 + 4 * p2 - p3, p3 - 3 * p2 + 3 * p1 - p0});
  }
  return {};
}

Polynomial squared_distance(const Piece& piece, const Point& point) {
  Polynomial result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial arm = sum(piece.at(k), {-point.at(k)});
    result = sum(result, product(arm, arm));
  }
  return result;
}

// What the balls of a range of u cover of the line.
struct Covered {
  Bounds low;
  Bounds high;
  bool from_start = false;  // the range begins with the piece
  bool to_end = false;      // it ends with the piece
};

void widen(Covered& covered, const Covered& other) {
  covered.low = {std::min(covered.low.lower, other.low.lower),
                 std::min(covered.low.upper, other.low.upper)};
  covered.high = {std::max(covered.high.lower, other.high.lower),
                  std::max(covered.high.upper, other.high.upper)};
}

struct PieceOnLine {
  Rational length_squared;
  Polynomial along;  // (c - o).d
  Polynomial met;    // D: (c - o).d squared less |d|^2 (|c - o|^2 - r^2)

  // Those of one ball, or of all near it.
  [[nodiscard]] Covered by(const Bounds& u, unsigned bits) const {
    const Bounds square = over(met, u);
    const Bounds root{root_below(square.lower, bits),
                      root_below(square.upper, bits) + Rational(1, Integer(1) << bits)};
    const Bounds scale{1 / length_squared, 1 / length_squared};
    const Bounds middle = over(along, u);
    return {(middle + Bounds{-root.upper, -root.lower}) * scale, (middle + root) * scale};
  }
};

// Of all ranges of a piece; nothing if something cannot be told.
std::optional<std::vector<Covered>> covered_by(const PieceOnLine& piece, int bits) {
  const auto breaks = roots_within(piece.met, bits);
  const Polynomial met_slope = slope(piece.met);
  const Polynomial along_slope = slope(piece.along);
  const Polynomial stationary =
      sum(product(met_slope, met_slope),
          scaled(-4, product(piece.met, product(along_slope, along_slope))));
  const auto turns = roots_within(stationary, bits);
  if (!breaks || !turns) {
    return std::nullopt;
  }
  std::vector<Bounds> ends{{0, 0}};
  ends.insert(ends.end(), breaks->begin(), breaks->end());
  ends.push_back({1, 1});
  std::vector<Covered> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Bounds& from = ends[i];
    const Bounds& to = ends[i + 1];
    if (at(piece.met, (from.upper + to.lower) / 2) <= 0) {
      continue;
    }
    const auto fine = static_cast<unsigned>(bits);
    Covered covered = piece.by(from, fine);
    widen(covered, piece.by(to, fine));
    for (const Bounds& turn : *turns) {
      if (turn.upper < from.lower || turn.lower > to.upper) {
        continue;
      }
      if (turn.lower <= from.upper || turn.upper >= to.lower) {
        return std::nullopt;
      }
      widen(covered, piece.by(turn, fine));
    }
    covered.from_start = i == 0;
    covered.to_end = i + 2 == ends.size();
    result.push_back(covered);
  }
  return result;
}

}  // namespace

SweptBall::SweptBall(const SpaceCurve& curve, const Rational& radius)
    : closed_(curve.closed), radius_(radius) {
  const auto count = static_cast<std::ptrdiff_t>(curve.points.size());
  const auto coordinate = [&](std::ptrdiff_t i, std::size_t axis) -> Rational {
    const auto of = [&](std::ptrdiff_t k) {
      return curve.points.at(static_cast<std::size_t>(k)).at(axis);
    };
    if (closed_) {
      return of((i + count) % count);
    }
    return i < 0 ? 2 * of(0) - of(1) : i >= count ? 2 * of(count - 1) - of(count - 2) : of(i);
  };
  for (std::ptrdiff_t i = 0; i < (closed_ ? count : count - 1); ++i) {
    Piece piece;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      piece.at(axis) =
          one_coordinate(curve.kind, {coordinate(i - 1, axis), coordinate(i, axis),
                                      coordinate(i + 1, axis), coordinate(i + 2, axis)});
    }
    pieces_.push_back(piece);
  }
}

SweptBall::Crossings SweptBall::attempt(const Point& origin, const Point& direction,
                                        int bits) const {
  Crossings result;
  std::vector<Covered> all;
  bool last_goes_on = false;
  bool first_goes_back = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    PieceOnLine piece;
    for (std::size_t k = 0; k < 3; ++k) {
      piece.length_squared += direction.at(k) * direction.at(k);
      piece.along =
          sum(piece.along, scaled(direction.at(k), sum(pieces_[i].at(k), {-origin.at(k)})));
    }
    piece.met = sum(product(piece.along, piece.along),
                    scaled(-piece.length_squared,
                           sum(squared_distance(pieces_[i], origin), {-radius_ * radius_})));
    if (whole(piece.met).empty()) {
      result.has_piece_along = true;
      return result;
    }
    const auto covered = covered_by(piece, bits);
    if (!covered) {
      result.is_inseparable = true;
      return result;
    }
    for (const Covered& range : *covered) {
      if (range.from_start && last_goes_on) {
        widen(all.back(), range);
      } else {
        all.push_back(range);
      }
      first_goes_back = first_goes_back || (i == 0 && range.from_start);
    }
    last_goes_on = !covered->empty() && covered->back().to_end;
  }
  if (closed_ && last_goes_on && first_goes_back && all.size() > 1) {
    widen(all.front(), all.back());
    all.pop_back();
  }
  result.ranges = all.size();
  std::sort(all.begin(), all.end(),
            [](const Covered& a, const Covered& b) { return a.low.lower < b.low.lower; });
  std::vector<Covered> apart;
  for (const Covered& next : all) {
    if (apart.empty() || next.low.lower > apart.back().high.upper) {
      apart.push_back(next);
    } else if (next.low.upper <= apart.back().high.lower) {
      widen(apart.back(), next);
      ++result.overlaps;
    } else {
      result.is_inseparable = true;
      return result;
    }
  }
  for (const Covered& covered : apart) {
    result.crossings.push_back(covered.low);
    result.crossings.push_back(covered.high);
  }
  return result;
}

SweptBall::Crossings SweptBall::crossings(const Point& origin, const Point& direction) const {
  Crossings result;
  for (const int bits : kBits) {
    result = attempt(origin, direction, bits);
    if (!result.is_inseparable) {
      break;
    }
  }
  return result;
}

std::optional<int> SweptBall::side(const Point& point) const {
  int side = 1;
  bool is_certain = true;
  for (const Piece& piece : pieces_) {
    const Polynomial beyond = sum(squared_distance(piece, point), {-radius_ * radius_});
    const auto nearest = roots_within(slope(beyond), kBits.front());
    is_certain = is_certain && nearest.has_value();
    for (const Bounds& u : nearest.value_or(std::vector<Bounds>{})) {
      const Bounds value = over(beyond, u);
      if (value.upper < 0) {
        return -1;
      }
      is_certain = is_certain && value.lower > 0;
    }
    for (const Rational& end : {Rational(0), Rational(1)}) {
      side = std::min(side, at(beyond, end).sign());
    }
  }
  return side < 0 || is_certain ? std::optional(side) : std::nullopt;
}

}  // namespace lamina::reference
