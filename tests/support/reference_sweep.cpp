#include "support/reference_sweep.hpp"

#include <arb.h>
#include <flint/fmpq.h>

#include <algorithm>
#include <optional>

#include "support/reference_polynomial.hpp"
#include "support/reference_roots.hpp"

namespace lamina::reference {

using number::Integer;
using number::Rational;
using Crossing = SweptCurve::Crossing;
using Crossings = SweptCurve::Crossings;
using Doubt = SweptCurve::Doubt;
using Membership = SweptCurve::Membership;
using Piece = SweptCurve::Piece;
using Point = SweptCurve::Point;

namespace {

// Most rays are answered by the first; the second is for what that leaves inseparable.
constexpr std::array<int, 2> kBits{128, 1024};

// Arb's ball, freed at the end of its scope.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(const Rational& value, slong precision) : Ball() {
    fmpq_t exact;
    fmpq_init(exact);
    fmpq_set_mpq(exact, value.backend().data());
    arb_set_fmpq(value_, exact, precision);
    fmpq_clear(exact);
  }
  Ball(const RealRoot& root, slong precision) : Ball() {
    arb_union(value_, Ball(root.lower, precision).get(), Ball(root.upper, precision).get(),
              precision);
  }
  Ball(const Ball&) = delete;
  Ball& operator=(const Ball&) = delete;
  ~Ball() { arb_clear(value_); }
  arb_ptr get() { return value_; }

 private:
  arb_t value_;
};

Rational rational(const arf_struct* value) {
  fmpq_t exact;
  fmpq_init(exact);
  arf_get_fmpq(exact, value);
  Rational result;
  fmpq_get_mpq(result.backend().data(), exact);
  fmpq_clear(exact);
  return result;
}

Rational lower_bound(Ball& ball, slong precision) {
  arf_t bound;
  arf_init(bound);
  arb_get_lbound_arf(bound, ball.get(), precision);
  Rational result = rational(bound);
  arf_clear(bound);
  return result;
}

Rational upper_bound(Ball& ball, slong precision) {
  arf_t bound;
  arf_init(bound);
  arb_get_ubound_arf(bound, ball.get(), precision);
  Rational result = rational(bound);
  arf_clear(bound);
  return result;
}

void evaluate(Ball& result, const Polynomial& polynomial, Ball& s, slong precision) {
  arb_zero(result.get());
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    arb_mul(result.get(), result.get(), s.get(), precision);
    arb_add(result.get(), result.get(), Ball(*c, precision).get(), precision);
  }
}

Rational at_one(const Polynomial& polynomial) {
  Rational total = 0;
  for (const Rational& c : polynomial) {
    total += c;
  }
  return total;
}

// Whether the coefficients over Bernstein's basis, of which the values from 0 to 1 are means, are
// all positive or all negative. 60 is a multiple of the binomials of 1 to 6.
bool has_one_sign(const std::vector<Integer>& ascending) {
  const std::size_t degree = ascending.size() - 1;
  const auto binomial = [](std::size_t n, std::size_t k) {
    std::size_t result = 1;
    for (std::size_t i = 0; i < k; ++i) {
      result = result * (n - i) / (i + 1);
    }
    return result;
  };
  bool has_positive = false;
  bool has_negative = false;
  for (std::size_t i = 0; i <= degree; ++i) {
    Integer coefficient = 0;
    for (std::size_t j = 0; j <= i; ++j) {
      coefficient += ascending[j] * Integer(binomial(i, j) * (60 / binomial(degree, j)));
    }
    has_positive = has_positive || coefficient >= 0;
    has_negative = has_negative || coefficient <= 0;
  }
  return has_positive != has_negative;
}

// The roots in 0 < s < 1, and what is known of the ends.
struct RootsOfPiece {
  bool is_zero = false;   // the polynomial
  bool at_start = false;  // s = 0 is a root
  bool at_end = false;    // s = 1 is
  bool is_inseparable = false;
  bool is_isolated = false;
  std::vector<RealRoot> within;
};

RootsOfPiece roots_of_piece(const Polynomial& equation, int bits) {
  RootsOfPiece result;
  const std::vector<Integer> ascending = whole(equation);
  if (ascending.empty()) {
    result.is_zero = true;
    return result;
  }
  result.at_start = equation.front() == 0;
  result.at_end = at_one(equation) == 0;
  if (ascending.size() == 1 || has_one_sign(ascending)) {
    return result;
  }
  result.is_isolated = true;
  for (const RealRoot& root : real_roots(ascending, bits)) {
    const bool may_be_start = root.lower <= 0 && root.upper >= 0;
    const bool may_be_end = root.lower <= 1 && root.upper >= 1;
    if ((may_be_start && !result.at_start) || (may_be_end && !result.at_end)) {
      result.is_inseparable = true;
    } else if (!may_be_start && !may_be_end && root.lower > 0 && root.upper < 1) {
      result.within.push_back(root);
    }
  }
  return result;
}

Polynomial constant(const Rational& value) { return {value}; }

// The cubic through the blending of four points, whose rows are the powers of s.
Polynomial blended(const std::array<std::array<int, 4>, 4>& rows, int divisor,
                   const std::array<Rational, 4>& p) {
  Polynomial result;
  for (const auto& row : rows) {
    Rational c = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      c += row[i] * p[i];
    }
    result.push_back(c / divisor);
  }
  return result;
}

Polynomial one_coordinate(PlaneCurve::Kind kind, const std::array<Rational, 4>& p) {
  switch (kind) {
    case PlaneCurve::Kind::Line:
      return {p[1], p[2] - p[1]};
    case PlaneCurve::Kind::BSpline:
      return blended({{{1, 4, 1, 0}, {-3, 0, 3, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}}}, 6, p);
    case PlaneCurve::Kind::CatmullRom:
      return blended({{{0, 2, 0, 0}, {-1, 0, 1, 0}, {2, -5, 4, -1}, {-1, 3, -3, 1}}}, 2, p);
  }
  return {};
}

// What is zero where the ray and the piece meet.
Polynomial equation_of(SweepKind kind, const Piece& piece, const Point& o, const Point& d) {
  const auto& [ox, oy, oz] = o;
  const auto& [dx, dy, dz] = d;
  switch (kind) {
    case SweepKind::Translational:
      return sum(sum(scaled(dy, piece.u), scaled(-dx, piece.v)), constant(dx * oy - dy * ox));
    case SweepKind::Conic:
      return sum(sum(scaled(oy * dz - oz * dy, piece.u), scaled(oz * dx - ox * dz, piece.v)),
                 constant(ox * dy - oy * dx));
    case SweepKind::Rotational: {
      const Rational a = dx * dx + dy * dy;
      const Rational b = 2 * (dz * (dx * ox + dy * oy) - oz * a);
      const Rational p = dx * oz - dz * ox;
      const Rational q = dy * oz - dz * oy;
      return sum(sum(scaled(a, product(piece.v, piece.v)), scaled(b, piece.v)),
                 sum(constant(p * p + q * q), scaled(-dz * dz, product(piece.u, piece.u))));
    }
  }
  return {};
}

// t is a quotient of two polynomials in s: any of these, if its divisor is not zero.
struct Quotient {
  Polynomial dividend;
  Polynomial divisor;
};

std::vector<Quotient> quotients(SweepKind kind, const Piece& piece, const Point& o,
                                const Point& d) {
  const auto& [ox, oy, oz] = o;
  const auto& [dx, dy, dz] = d;
  switch (kind) {
    case SweepKind::Translational:
      return {{sum(piece.u, constant(-ox)), constant(dx)},
              {sum(piece.v, constant(-oy)), constant(dy)}};
    case SweepKind::Conic:
      return {{sum(scaled(-oz, piece.u), constant(ox)), sum(scaled(dz, piece.u), constant(-dx))},
              {sum(scaled(-oz, piece.v), constant(oy)), sum(scaled(dz, piece.v), constant(-dy))},
              {sum(scaled(oy, piece.u), scaled(-ox, piece.v)),
               sum(scaled(dx, piece.v), scaled(-dy, piece.u))}};
    case SweepKind::Rotational:
      return {{sum(piece.v, constant(-oz)), constant(dz)}};
  }
  return {};
}

// By the largest divisor; none if that may be zero, which is at infinity.
std::optional<Crossing> crossing_at(const std::vector<Quotient>& quotients, const RealRoot& root,
                                    slong precision) {
  Ball s(root, precision);
  Ball divisor;
  const Quotient* best = nullptr;
  for (const Quotient& quotient : quotients) {
    Ball candidate;
    evaluate(candidate, quotient.divisor, s, precision);
    if (best == nullptr || arf_cmpabs(arb_midref(candidate.get()), arb_midref(divisor.get())) > 0) {
      arb_swap(divisor.get(), candidate.get());
      best = &quotient;
    }
  }
  if (best == nullptr || arb_contains_zero(divisor.get()) != 0) {
    return std::nullopt;
  }
  Ball t;
  evaluate(t, best->dividend, s, precision);
  arb_div(t.get(), t.get(), divisor.get(), precision);
  return Crossing{lower_bound(t, precision), upper_bound(t, precision), 0, root.multiplicity};
}

// -1, 0 or 1; 0 if it may be zero.
int sign_between(const Polynomial& polynomial, const RealRoot& root, slong precision) {
  Ball s(root, precision);
  Ball value;
  evaluate(value, polynomial, s, precision);
  return arb_is_positive(value.get()) != 0 ? 1 : arb_is_negative(value.get()) != 0 ? -1 : 0;
}

// A half-line: the part of the line where the one polynomial is zero in which the other is
// positive.
struct HalfLine {
  std::vector<Polynomial> line;
  std::vector<Polynomial> along;
};

Membership counted(const HalfLine& half_line, int bits) {
  bool is_inside = false;
  for (std::size_t i = 0; i < half_line.line.size(); ++i) {
    const Polynomial& along = half_line.along[i];
    const Rational start = half_line.line[i].front();
    const Rational end = at_one(half_line.line[i]);
    const std::vector<Integer> whole_along = whole(along);
    if (!whole_along.empty() && has_one_sign(whole_along)) {
      // All of the piece is on the one side, and nothing but its ends matters.
      if (whole_along.front() < 0) {
        continue;
      }
      if (start == 0 || end == 0) {
        return Membership::Undecided;
      }
      is_inside = is_inside != ((start > 0) != (end > 0));
      continue;
    }
    const RootsOfPiece roots = roots_of_piece(half_line.line[i], bits);
    if (roots.is_zero || roots.is_inseparable || (roots.at_start && along.front() >= 0) ||
        (roots.at_end && at_one(along) >= 0)) {
      return Membership::Undecided;
    }
    for (const RealRoot& root : roots.within) {
      const int sign = sign_between(along, root, 2 * bits);
      if (sign == 0) {
        return Membership::Undecided;
      }
      is_inside = is_inside != (sign > 0 && root.multiplicity % 2 == 1);
    }
  }
  return is_inside ? Membership::Inside : Membership::Outside;
}

HalfLine reversed(HalfLine half_line) {
  for (Polynomial& along : half_line.along) {
    along = scaled(-1, along);
  }
  return half_line;
}

bool has_no_equation(SweepKind kind, const Point& o, const Point& d) {
  switch (kind) {
    case SweepKind::Translational:
      return d[0] == 0 && d[1] == 0;
    case SweepKind::Conic:
      return o[1] * d[2] == o[2] * d[1] && o[2] * d[0] == o[0] * d[2] && o[0] * d[1] == o[1] * d[0];
    case SweepKind::Rotational:
      return d[2] == 0;
  }
  return true;
}

}  // namespace

SweptCurve::SweptCurve(SweepKind kind, const PlaneCurve& curve)
    : kind_(kind), closed_(curve.closed) {
  const auto count = static_cast<std::ptrdiff_t>(curve.points.size());
  const auto point = [&](std::ptrdiff_t i) -> std::array<Rational, 2> {
    const auto at = [&](std::ptrdiff_t k) { return curve.points.at(static_cast<std::size_t>(k)); };
    if (closed_) {
      return at((i + count) % count);
    }
    if (i < 0 || i >= count) {
      const auto [u, v] = at(i < 0 ? -i : 2 * (count - 1) - i);
      return {-u, v};
    }
    return at(i);
  };
  for (std::ptrdiff_t i = 0; i < (closed_ ? count : count - 1); ++i) {
    std::array<Rational, 4> u;
    std::array<Rational, 4> v;
    for (std::ptrdiff_t k = 0; k < 4; ++k) {
      const auto p = point(i + k - 1);
      u.at(static_cast<std::size_t>(k)) = p[0];
      v.at(static_cast<std::size_t>(k)) = p[1];
    }
    pieces_.push_back({one_coordinate(curve.kind, u), one_coordinate(curve.kind, v)});
  }
}

Crossings SweptCurve::attempt(const Point& origin, const Point& direction, int bits) const {
  Crossings result;
  const auto doubt = [&result](Doubt reason) { result.doubt = std::max(result.doubt, reason); };
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const RootsOfPiece roots =
        roots_of_piece(equation_of(kind_, pieces_[i], origin, direction), bits);
    result.has_piece_along = result.has_piece_along || roots.is_zero;
    result.isolated += roots.is_isolated ? 1 : 0;
    doubt(roots.is_zero                    ? Doubt::InSurface
          : roots.at_start || roots.at_end ? Doubt::Joint
          : roots.is_inseparable           ? Doubt::Inseparable
                                           : Doubt::None);
    for (const RealRoot& root : roots.within) {
      if (root.multiplicity % 2 == 0) {
        ++result.touches;
        continue;
      }
      std::optional<Crossing> crossing =
          crossing_at(quotients(kind_, pieces_[i], origin, direction), root, 2 * bits);
      if (!crossing) {
        doubt(Doubt::Inseparable);
        continue;
      }
      crossing->piece = i;
      result.crossings.push_back(*crossing);
    }
  }
  std::sort(result.crossings.begin(), result.crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.lower < b.lower; });
  const auto meeting =
      std::adjacent_find(result.crossings.begin(), result.crossings.end(),
                         [](const Crossing& a, const Crossing& b) { return a.upper >= b.lower; });
  if (meeting != result.crossings.end()) {
    doubt(Doubt::Inseparable);
  }
  return result;
}

Crossings SweptCurve::crossings(const Point& origin, const Point& direction) const {
  Crossings result;
  if (has_no_equation(kind_, origin, direction)) {
    result.doubt = Doubt::NoEquation;
    // At one v, the equation of a rotational sweep is that v's.
    result.has_piece_along = kind_ == SweepKind::Rotational &&
                             std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
                               return whole(sum(piece.v, constant(-origin[2]))).empty();
                             });
    return result;
  }
  for (const int bits : kBits) {
    result = attempt(origin, direction, bits);
    if (result.doubt != Doubt::Inseparable) {
      break;
    }
  }
  return result;
}

Membership SweptCurve::membership(const Point& point) const {
  const auto& [x, y, z] = point;
  if (kind_ == SweepKind::Conic && z == 0) {
    return Membership::Undecided;
  }
  HalfLine horizontal;  // to the right
  HalfLine vertical;    // upwards
  for (const Piece& piece : pieces_) {
    // Of a rotational sweep u is not rational, and its square takes its place: u >= 0.
    const bool is_turned = kind_ == SweepKind::Rotational;
    const Rational v0 = is_turned ? z : kind_ == SweepKind::Conic ? Rational(y / z) : y;
    const Rational u0 = kind_ == SweepKind::Conic ? Rational(x / z) : x;
    const Polynomial u = is_turned ? sum(product(piece.u, piece.u), constant(-x * x - y * y))
                                   : sum(piece.u, constant(-u0));
    const Polynomial v = sum(piece.v, constant(-v0));
    horizontal.line.push_back(v);
    horizontal.along.push_back(u);
    vertical.line.push_back(u);
    vertical.along.push_back(v);
  }
  std::vector<HalfLine> half_lines{horizontal};
  if (closed_) {
    half_lines.push_back(reversed(horizontal));
  }
  // On the axis, the square of u has double roots where u changes its sign.
  if (kind_ != SweepKind::Rotational || x != 0 || y != 0) {
    half_lines.push_back(vertical);
    half_lines.push_back(reversed(vertical));
  }
  for (const HalfLine& half_line : half_lines) {
    const Membership found = counted(half_line, kBits.front());
    if (found != Membership::Undecided) {
      return found;
    }
  }
  return Membership::Undecided;
}

}  // namespace lamina::reference
