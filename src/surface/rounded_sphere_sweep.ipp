#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "geometry/rounding.hpp"
#include "number/fused.hpp"
#include "surface/rounded_sphere_sweep.hpp"
#include "surface/rounded_sweep.ipp"

namespace lamina::surface {
namespace detail {

template <number::RoundedNumber Number, std::size_t A, std::size_t B>
std::array<Number, A + B - 1> product(const std::array<Number, A>& a,
                                      const std::array<Number, B>& b) {
  std::array<Number, A + B - 1> result;
  result.fill(Number(0));
  for (std::size_t i = 0; i < A; ++i) {
    for (std::size_t j = 0; j < B; ++j) {
      result[i + j] = result[i + j] + a[i] * b[j];
    }
  }
  return result;
}

// factor_a a + factor_b b
template <number::RoundedNumber Number, std::size_t Size>
std::array<Number, Size> combination(const Number& factor_a, const std::array<Number, Size>& a,
                                     const Number& factor_b, const std::array<Number, Size>& b) {
  std::array<Number, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    result[i] = factor_a * a[i] + factor_b * b[i];
  }
  return result;
}

template <number::RoundedNumber Number, std::size_t Size>
std::array<Number, Size - 1> slope_of(const std::array<Number, Size>& c) {
  std::array<Number, Size - 1> result;
  for (std::size_t i = 1; i < Size; ++i) {
    result[i - 1] = static_cast<Number>(static_cast<int>(i)) * c[i];
  }
  return result;
}

template <number::RoundedNumber Number>
std::array<Number, 7> sum_of_squares(const std::array<std::array<Number, 4>, 3>& v) {
  const Number one(1);
  return combination(one, combination(one, product(v[0], v[0]), one, product(v[1], v[1])), one,
                     product(v[2], v[2]));
}

template <number::RoundedNumber Number, std::size_t Size>
poly::RealRoots<Number> roots_in_unit(const std::array<Number, Size>& c, poly::Solver solver) {
  return poly::real_roots(std::span<const Number>(c), poly::Range<Number>{Number(0), Number(1)},
                          solver);
}

template <number::RoundedNumber Number>
Number sum_of_sizes(const geometry::Vector3<Number>& v) {
  using std::abs;
  return abs(v.x) + abs(v.y) + abs(v.z);
}

// Adds an interval to those whose ends these are, ascending and apart from each other.
template <typename Crossing>
void unite(std::vector<Crossing>& ends, Crossing low, Crossing high) {
  auto first = ends.begin();
  while (first != ends.end() && (first + 1)->t < low.t) {
    first += 2;
  }
  auto last = first;
  while (last != ends.end() && !(high.t < last->t)) {
    last += 2;
  }
  if (first != last) {
    low = first->t < low.t ? *first : low;
    high = high.t < (last - 1)->t ? *(last - 1) : high;
  }
  const auto place = ends.erase(first, last);
  ends.insert(place, {low, high});
}

}  // namespace detail

template <number::RoundedNumber Number>
RoundedSphereSweep<Number>::RoundedSphereSweep(const SphereSweep& exact)
    : radius_(number::number_traits<Number>::from_exact(exact.radius())) {
  using number::Rational;
  using std::sqrt;
  using Traits = number::number_traits<Number>;
  for (std::size_t i = 0; i < exact.trajectory().pieces().size(); ++i) {
    const geometry::TrajectoryPiece& from = exact.trajectory().pieces()[i];
    const geometry::Box& box = exact.trajectory().boxes()[i];
    Piece piece;
    for (std::size_t axis = 0; axis < from.size(); ++axis) {
      piece.c[axis].fill(Number(0));
      std::transform(from[axis].begin(), from[axis].end(), piece.c[axis].begin(),
                     Traits::from_exact);
    }
    piece.centre = geometry::rounded<Number>(Rational(1, 2) * (box.lower + box.upper));
    const auto farthest = [](const Number& centre, const Rational& lower, const Rational& upper) {
      const Rational at = Traits::to_exact(centre);
      const Rational most = std::max(Rational(upper - at), Rational(at - lower));
      return Rational(most * most);
    };
    const Rational squared = farthest(piece.centre.x, box.lower.x, box.upper.x) +
                             farthest(piece.centre.y, box.lower.y, box.upper.y) +
                             farthest(piece.centre.z, box.lower.z, box.upper.z);
    // A square root and a sum, each rounded: 4 u are more.
    piece.reach =
        (sqrt(detail::rounded_up<Number>(squared)) + detail::rounded_up<Number>(exact.radius())) *
        (1 + 4 * number::unit_roundoff<Number>());
    pieces_.push_back(std::move(piece));
  }
}

template <number::RoundedNumber Number>
auto RoundedSphereSweep<Number>::from(const Vector& p, Curve curve) -> Curve {
  curve[0][0] = curve[0][0] - p.x;
  curve[1][0] = curve[1][0] - p.y;
  curve[2][0] = curve[2][0] - p.z;
  return curve;
}

template <number::RoundedNumber Number>
auto RoundedSphereSweep<Number>::point(const Curve& curve, const Number& u) -> Vector {
  return {detail::cubic_at(curve[0], u), detail::cubic_at(curve[1], u),
          detail::cubic_at(curve[2], u)};
}

template <number::RoundedNumber Number>
bool RoundedSphereSweep<Number>::is_beyond(const Vector& gap, const Piece& piece,
                                           const Number& error) {
  // Three squares and their sum, the sum with the error and its square: 8 u are more.
  const Number most = (piece.reach + error) * (1 + 8 * number::unit_roundoff<Number>());
  return dot(gap, gap) > most * most;
}

template <number::RoundedNumber Number>
void RoundedSphereSweep<Number>::add_of_piece(const geometry::Ray<Number>& local,
                                              std::uint32_t index, const Number& shift,
                                              const poly::Solvers& solvers,
                                              std::vector<Crossing>& crossings,
                                              std::vector<Crossing>& walls) const {
  using std::abs;
  using std::sqrt;
  const auto& d = local.direction;
  const Curve arm = from(local.origin, pieces_[index].c);
  const Number one(1);
  const Curve across{detail::combination(d.z, arm[1], Number(-d.y), arm[2]),
                     detail::combination(d.x, arm[2], Number(-d.z), arm[0]),
                     detail::combination(d.y, arm[0], Number(-d.x), arm[1])};
  const Cubic along =
      detail::combination(one, detail::combination(d.x, arm[0], d.y, arm[1]), d.z, arm[2]);
  const Number length_squared = dot(d, d);
  const Number most = length_squared * radius_ * radius_;
  // D
  std::array<Number, 7> met = detail::sum_of_squares(across);
  for (Number& c : met) {
    c = -c;
  }
  met[0] = most + met[0];
  const auto met_at = [&](const Number& u) -> Number {
    const Vector x = point(across, u);
    return most - dot(x, x);
  };
  const poly::RealRoots<Number> ends = detail::roots_in_unit(met, solvers.sextic);
  const bool is_wall = ends.outcome == poly::Outcome::Everywhere;
  std::array<Number, poly::kMostDegree + 2> bounds;
  bounds[0] = Number(0);
  std::copy_n(ends.t.begin(), ends.count, bounds.begin() + 1);
  bounds[static_cast<std::size_t>(ends.count) + 1] = one;
  const Number middle_u(0.5);
  if (ends.count == 0 && !is_wall && !(met_at(bounds[0]) > 0) && !(met_at(middle_u) > 0) &&
      !(met_at(one) > 0)) {
    return;
  }
  const auto met_slope = detail::slope_of(met);
  const auto along_slope = detail::slope_of(along);
  const auto stationary =
      detail::combination(one, detail::product(met_slope, met_slope), Number(-4),
                          detail::product(met, detail::product(along_slope, along_slope)));
  const std::array turns{detail::roots_in_unit(stationary, solvers.sextic),
                         detail::roots_in_unit(met_slope, solvers.sextic),
                         detail::roots_in_unit(along_slope, poly::default_solver(2))};
  // By the sign of D where it is largest: near a tangent, roots of it in the range may be lost.
  const auto is_met = [&](const Number& from_u, const Number& to_u) {
    Number largest = met_at(Number(middle_u * (from_u + to_u)));
    const auto weigh = [&](const Number& u) {
      const Number value = met_at(u);
      if (abs(value) > abs(largest)) {
        largest = value;
      }
    };
    weigh(from_u);
    weigh(to_u);
    for (int k = 0; k < turns[1].count; ++k) {
      if (from_u < turns[1].t[k] && turns[1].t[k] < to_u) {
        weigh(turns[1].t[k]);
      }
    }
    return is_wall || largest > 0;
  };
  for (int range = 0; range <= ends.count; ++range) {
    const Number& from_u = bounds[static_cast<std::size_t>(range)];
    const Number& to_u = bounds[static_cast<std::size_t>(range) + 1];
    if (!is_met(from_u, to_u)) {
      continue;
    }
    std::optional<Crossing> low;
    std::optional<Crossing> high;
    const auto consider = [&](const Number& u) {
      const Number inside = met_at(u);
      const Number half = inside > 0 ? Number(sqrt(inside)) : Number(0);
      const Number middle = detail::cubic_at(along, u);
      const Number t_low = (middle - half) / length_squared + shift;
      const Number t_high = (middle + half) / length_squared + shift;
      if (t_high - t_low < 0 || !(t_low - t_low == 0) || !(t_high - t_high == 0)) {
        return;
      }
      if (!low || t_low < low->t) {
        low = Crossing{t_low, u, index};
      }
      if (!high || t_high > high->t) {
        high = Crossing{t_high, u, index};
      }
    };
    consider(from_u);
    consider(to_u);
    for (const poly::RealRoots<Number>& roots : turns) {
      for (int k = 0; k < roots.count; ++k) {
        if (from_u < roots.t[k] && roots.t[k] < to_u) {
          consider(roots.t[k]);
        }
      }
    }
    if (low && high && low->t < high->t) {
      detail::unite(is_wall ? walls : crossings, *low, *high);
    }
  }
}

template <number::RoundedNumber Number>
bool RoundedSphereSweep<Number>::find_crossings(const geometry::Ray<Number>& local,
                                                const poly::Solvers& solvers,
                                                std::vector<Crossing>& crossings) const {
  const auto& [o, d] = local;
  const Number length_squared = dot(d, d);
  std::vector<Crossing> walls;  // nearly always none
  crossings.clear();
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    // Any shift will do, so that its own rounding does no harm; the point is rounded once.
    const Number shift = dot(piece.centre - o, d) / length_squared;
    const Vector near{number::fused_multiply_add(shift, d.x, o.x),
                      number::fused_multiply_add(shift, d.y, o.y),
                      number::fused_multiply_add(shift, d.z, o.z)};
    // Of the shift some 8 u times its terms, which moves the point along the ray; by how much it is
    // then farther away than the nearest one is no more than that.
    const Number error = 16 * number::unit_roundoff<Number>() *
                         (detail::sum_of_sizes(o) + detail::sum_of_sizes(piece.centre));
    if (is_beyond(near - piece.centre, piece, error)) {
      continue;
    }
    add_of_piece({near, d}, i, shift, solvers, crossings, walls);
  }
  for (std::size_t wall = 0; wall < walls.size(); wall += 2) {
    bool is_inside = false;
    for (std::size_t i = 0; i < crossings.size(); i += 2) {
      is_inside =
          is_inside || (crossings[i].t <= walls[wall].t && walls[wall + 1].t <= crossings[i + 1].t);
    }
    if (!is_inside) {
      crossings.clear();
      return false;
    }
  }
  return true;
}

template <number::RoundedNumber Number>
auto RoundedSphereSweep<Number>::normal(const Vector& local, const Crossing& crossing) const
    -> Vector {
  return local - point(pieces_[crossing.piece].c, crossing.s);
}

template <number::RoundedNumber Number>
int RoundedSphereSweep<Number>::side(const Vector& local, const poly::Solvers& solvers,
                                     std::vector<Crossing>& /*scratch*/) const {
  const Number radius_squared = radius_ * radius_;
  int side = 1;
  for (const Piece& piece : pieces_) {
    const Number error = 2 * number::unit_roundoff<Number>() *
                         (detail::sum_of_sizes(local) + detail::sum_of_sizes(piece.centre));
    if (is_beyond(local - piece.centre, piece, error)) {
      continue;
    }
    const Curve arm = from(local, piece.c);
    const auto consider = [&](const Number& u) {
      const Vector to = point(arm, u);
      const Number beyond = dot(to, to) - radius_squared;
      side = std::min(side, beyond < 0 ? -1 : beyond > 0 ? 1 : 0);
    };
    consider(Number(0));
    consider(Number(1));
    const auto nearest =
        detail::roots_in_unit(detail::slope_of(detail::sum_of_squares(arm)), solvers.sextic);
    for (int k = 0; k < nearest.count; ++k) {
      consider(nearest.t[k]);
    }
  }
  return side;
}

template <number::RoundedNumber Number>
Number RoundedSphereSweep<Number>::value(const Vector& local, const Crossing& crossing) const {
  const Vector n = normal(local, crossing);
  return Number(0.5) * (dot(n, n) - radius_ * radius_);
}

// Roundings on the way to a term: 5 of a local coordinate (its row's entry, a product, three sums),
// or 7 of a point of the curve (a coefficient, and Horner's rule), and the difference, twice each,
// as they are squared; the square, two sums, and the difference from r^2: 20 in all.
template <number::RoundedNumber Number>
Number RoundedSphereSweep<Number>::rounding_error(const Vector& magnitude,
                                                  const Crossing& crossing) const {
  using std::abs;
  const auto most = [&crossing](const Cubic& c) -> Number {
    return ((abs(c[3]) * crossing.s + abs(c[2])) * crossing.s + abs(c[1])) * crossing.s + abs(c[0]);
  };
  const Curve& c = pieces_[crossing.piece].c;
  const Vector terms = magnitude + Vector{most(c[0]), most(c[1]), most(c[2])};
  const Number relative = 20 * number::unit_roundoff<Number>();
  return relative / (1 - relative) * Number(0.5) * (dot(terms, terms) + radius_ * radius_);
}

}  // namespace lamina::surface
