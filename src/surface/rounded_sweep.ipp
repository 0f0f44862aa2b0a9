#pragma once

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "surface/rounded_sweep.hpp"

namespace lamina::surface {
namespace detail {

// Not above the exact value.
template <number::RoundedNumber Number>
Number rounded_down(const number::Rational& exact) {
  using std::abs;
  using Traits = number::number_traits<Number>;
  const Number nearest = Traits::from_exact(exact);
  if (Traits::to_exact(nearest) <= exact) {
    return nearest;
  }
  return nearest - 2 * number::unit_roundoff<Number>() * abs(nearest) -
         std::numeric_limits<Number>::min();
}

template <number::RoundedNumber Number>
Number rounded_up(const number::Rational& exact) {
  return -rounded_down<Number>(-exact);
}

template <number::RoundedNumber Number>
Number cubic_at(const std::array<Number, 4>& c, const Number& s) {
  return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
}

template <number::RoundedNumber Number>
Number cubic_slope_at(const std::array<Number, 4>& c, const Number& s) {
  return (3 * c[3] * s + 2 * c[2]) * s + c[1];
}

// Adds factor * a * b to a polynomial of degree 6.
template <number::RoundedNumber Number>
void add_product(std::array<Number, 7>& sum, const Number& factor, const std::array<Number, 4>& a,
                 const std::array<Number, 4>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      sum[i + j] = sum[i + j] + factor * (a[i] * b[j]);
    }
  }
}

template <number::RoundedNumber Number>
Number of_larger_divisor(std::initializer_list<std::array<Number, 2>> quotients) {
  using std::abs;
  const auto best =
      std::max_element(quotients.begin(), quotients.end(),
                       [](const auto& a, const auto& b) { return abs(a[1]) < abs(b[1]); });
  return (*best)[0] / (*best)[1];
}

}  // namespace detail

template <number::RoundedNumber Number>
RoundedSweep<Number>::RoundedSweep(const SweptSurface& exact)
    : sweep_(exact.sweep()), orientation_(exact.contour().orientation()) {
  using Traits = number::number_traits<Number>;
  const geometry::Contour& contour = exact.contour();
  const auto count = static_cast<std::uint32_t>(contour.pieces().size());
  // Is there no surface where a piece begins or ends, but the axis?
  const auto is_pole = [&](std::uint32_t neighbour, bool at_end_of_all) {
    return (at_end_of_all && !contour.closed()) || !exact.sweeps(neighbour);
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const geometry::ContourPiece& from = contour.pieces()[i];
    const geometry::Rectangle& box = contour.boxes()[i];
    Piece piece{static_cast<int>(from.u.size()) - 1,
                {},
                {},
                detail::rounded_down<Number>(box.u_min),
                detail::rounded_up<Number>(box.u_max),
                detail::rounded_down<Number>(box.v_min),
                detail::rounded_up<Number>(box.v_max),
                exact.sweeps(i),
                is_pole((i + count - 1) % count, i == 0),
                is_pole((i + 1) % count, i + 1 == count)};
    piece.u.fill(Number(0));
    piece.v.fill(Number(0));
    std::transform(from.u.begin(), from.u.end(), piece.u.begin(), Traits::from_exact);
    std::transform(from.v.begin(), from.v.end(), piece.v.begin(), Traits::from_exact);
    pieces_.push_back(std::move(piece));
  }
}

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::equation(const geometry::Ray<Number>& local) const -> Equation {
  using std::abs;
  const auto& [o, d] = local;
  Equation e;
  // p q - r s, and what it cannot exceed.
  const auto minor = [](const Number& p, const Number& q, const Number& r, const Number& s,
                        Number& most) {
    most = abs(p * q) + abs(r * s);
    return Number(p * q - r * s);
  };
  switch (sweep_) {
    case Sweep::Translational:
      e.u = d.y;
      e.v = -d.x;
      e.most_u = abs(d.y);
      e.most_v = abs(d.x);
      e.constant = minor(d.x, o.y, d.y, o.x, e.most_constant);
      break;
    case Sweep::Conic:
      e.u = minor(o.y, d.z, o.z, d.y, e.most_u);
      e.v = minor(o.z, d.x, o.x, d.z, e.most_v);
      e.constant = minor(o.x, d.y, o.y, d.x, e.most_constant);
      break;
    case Sweep::Rotational: {
      e.vv = e.most_vv = d.x * d.x + d.y * d.y;
      e.v = 2 * (d.z * (d.x * o.x + d.y * o.y) - o.z * e.vv);
      e.most_v = 2 * (abs(d.z) * (abs(d.x * o.x) + abs(d.y * o.y)) + abs(o.z) * e.vv);
      Number most_x;
      Number most_y;
      const Number x = minor(d.x, o.z, d.z, o.x, most_x);
      const Number y = minor(d.y, o.z, d.z, o.y, most_y);
      e.constant = x * x + y * y;
      e.most_constant = most_x * most_x + most_y * most_y;
      e.uu = -(d.z * d.z);
      e.most_uu = d.z * d.z;
      break;
    }
  }
  return e;
}

// The equation's left side over the rectangle, which is 0 somewhere in it if and only if it is not
// of one sign: it is a sum of a function of u and one of v, each least or greatest at an end, or
// where the parabola in v turns. A term has 9 roundings at most on its way from the ray's numbers
// to the sum, so that the sum is off by gamma_9 times that of the absolute terms (Higham
// 2002, 3.1); 16 u is more than that for u <= 2^-11, and what rounding the turn costs is of second
// order, since most_v^2 <= 4 vv most_constant.
template <number::RoundedNumber Number>
bool RoundedSweep<Number>::rules_out(const Equation& e, const Piece& piece) {
  using std::abs;
  const auto [u_min, u_max, v_min, v_max] =
      std::array{piece.u_min, piece.u_max, piece.v_min, piece.v_max};
  const auto in_u = [&e](const Number& u) -> Number { return (e.uu * u + e.u) * u; };
  const auto in_v = [&e](const Number& v) -> Number { return (e.vv * v + e.v) * v; };
  // The radius of a sweep begins at the axis, whatever its rectangle was rounded to.
  const Number u_low = e.uu < 0 && u_min < 0 ? Number(0) : u_min;
  const auto [least_u, greatest_u] = std::minmax({in_u(u_low), in_u(u_max)});
  auto [least_v, greatest_v] = std::minmax({in_v(v_min), in_v(v_max)});
  if (e.vv > 0) {
    const Number turn = -e.v / (2 * e.vv);
    if (v_min < turn && turn < v_max) {
      least_v = std::min(least_v, in_v(turn));
    }
  }
  const Number u = std::max(Number(abs(u_min)), Number(abs(u_max)));
  const Number v = std::max(Number(abs(v_min)), Number(abs(v_max)));
  const Number terms =
      (e.most_uu * u + e.most_u) * u + (e.most_vv * v + e.most_v) * v + e.most_constant;
  const Number rounding = 16 * number::unit_roundoff<Number>() * terms;
  return least_u + least_v + e.constant > rounding ||
         greatest_u + greatest_v + e.constant < -rounding;
}

template <number::RoundedNumber Number>
bool RoundedSweep<Number>::rules_out(const geometry::Ray<Number>& local,
                                     std::uint32_t piece) const {
  return rules_out(equation(local), pieces_[piece]);
}

template <number::RoundedNumber Number>
poly::RealRoots<Number> RoundedSweep<Number>::roots_of(const Piece& piece, const Equation& e,
                                                       const geometry::Ray<Number>& local,
                                                       const poly::Solvers& solvers) const {
  using std::sqrt;
  const auto& o = local.origin;
  std::array<Number, 7> p;
  p.fill(Number(0));
  int degree = piece.degree;
  if (is_level(local)) {
    std::copy(piece.v.begin(), piece.v.end(), p.begin());
    p[0] = p[0] - o.z;
  } else if (is_upright(local)) {
    std::copy(piece.u.begin(), piece.u.end(), p.begin());
    p[0] = p[0] - sqrt(o.x * o.x + o.y * o.y);
  } else {
    for (std::size_t k = 0; k < piece.u.size(); ++k) {
      p[k] = e.u * piece.u[k] + e.v * piece.v[k];
    }
    p[0] = p[0] + e.constant;
    if (sweep_ == Sweep::Rotational) {
      detail::add_product(p, e.vv, piece.v, piece.v);
      detail::add_product(p, e.uu, piece.u, piece.u);
      degree *= 2;
    }
  }
  return poly::real_roots(std::span<const Number>(p.data(), static_cast<std::size_t>(degree) + 1),
                          poly::Range<Number>{Number(0), Number(1)},
                          degree == 6   ? solvers.sextic
                          : degree == 3 ? solvers.cubic
                                        : poly::default_solver(2));
}

template <number::RoundedNumber Number>
void RoundedSweep<Number>::add_crossings(const geometry::Ray<Number>& local, std::uint32_t piece,
                                         const Number& s, std::vector<Crossing>& crossings) const {
  using std::sqrt;
  const auto& [o, d] = local;
  const Number u = detail::cubic_at(pieces_[piece].u, s);
  const Number v = detail::cubic_at(pieces_[piece].v, s);
  const auto add = [&](const Number& t) {
    if (t - t == 0) {  // a ray parallel to a ruling meets it at infinity
      crossings.push_back({t, s, piece});
    }
  };
  switch (sweep_) {
    case Sweep::Translational:
      add(detail::of_larger_divisor<Number>({{u - o.x, d.x}, {v - o.y, d.y}}));
      break;
    case Sweep::Conic:
      add(detail::of_larger_divisor<Number>({{o.z * u - o.x, d.x - d.z * u},
                                             {o.z * v - o.y, d.y - d.z * v},
                                             {o.y * u - o.x * v, d.x * v - d.y * u}}));
      break;
    case Sweep::Rotational:
      if (is_level(local)) {
        // The circle of radius u, by the ray's distance from the axis.
        const Number a = d.x * d.x + d.y * d.y;
        const Number half_b = d.x * o.x + d.y * o.y;
        const Number across = d.x * o.y - d.y * o.x;
        const Number discriminant = a * u * u - across * across;
        if (discriminant > 0) {
          const Number root = sqrt(discriminant);
          add((-half_b - root) / a);
          add((-half_b + root) / a);
        }
      } else {
        add((v - o.z) / d.z);
      }
      break;
  }
}

template <number::RoundedNumber Number>
void RoundedSweep<Number>::find_crossings(const geometry::Ray<Number>& local,
                                          const poly::Solvers& solvers,
                                          std::vector<Crossing>& crossings) const {
  const auto& [o, d] = local;
  crossings.clear();
  if (sweep_ == Sweep::Translational && d.x == 0 && d.y == 0) {
    return;
  }
  const Equation e = equation(local);
  const Number across = d.x * o.y - d.y * o.x;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    if (!piece.sweeps || rules_out(e, piece)) {
      continue;
    }
    // At the height of a flat piece, but beyond its rim.
    if (is_level(local) && across * across > e.vv * piece.u_max * piece.u_max) {
      continue;
    }
    const poly::RealRoots<Number> roots = roots_of(piece, e, local, solvers);
    if (roots.outcome == poly::Outcome::Everywhere) {
      crossings.clear();
      return;
    }
    bool passed_pole = false;
    for (int k = 0; k < roots.count; ++k) {
      const Number& s = roots.t[k];
      if ((piece.from_pole && s == 0) || (piece.to_pole && s == 1)) {
        if (!passed_pole) {
          add_crossings(local, i, s, crossings);
        }
        passed_pole = true;
        continue;
      }
      const bool touches = roots.multiplicity[k] != 0 && roots.multiplicity[k] % 2 == 0;
      if (!touches && s < 1) {
        add_crossings(local, i, s, crossings);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
}

template <number::RoundedNumber Number>
geometry::Vector3<Number> RoundedSweep<Number>::normal(const geometry::Ray<Number>& local,
                                                       const Crossing& crossing) const {
  const Piece& piece = pieces_[crossing.piece];
  const auto side = static_cast<Number>(orientation_);
  const Number n_u = side * detail::cubic_slope_at(piece.v, crossing.s);
  const Number n_v = -side * detail::cubic_slope_at(piece.u, crossing.s);
  switch (sweep_) {
    case Sweep::Translational:
      return {n_u, n_v, Number(0)};
    case Sweep::Conic: {
      const Number u = detail::cubic_at(piece.u, crossing.s);
      const Number v = detail::cubic_at(piece.v, crossing.s);
      const geometry::Vector3<Number> normal{n_u, n_v, -(n_u * u + n_v * v)};
      return local.origin.z + crossing.t * local.direction.z < 0 ? Number(-1) * normal : normal;
    }
    case Sweep::Rotational: {
      const Number u = detail::cubic_at(piece.u, crossing.s);
      const Number x = local.origin.x + crossing.t * local.direction.x;
      const Number y = local.origin.y + crossing.t * local.direction.y;
      return {n_u * x, n_u * y, n_v * u};
    }
  }
  return {};
}

}  // namespace lamina::surface
