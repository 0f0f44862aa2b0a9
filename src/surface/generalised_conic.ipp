// Rays that are not level in generalised conic sweeps, in a rounded number type.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "surface/polynomials.hpp"
#include "surface/rounded_sweep.ipp"

namespace lamina::surface {
namespace detail {

// The resultant over s of u(s) w - u and v(s) w - v, by Bezout's matrix without a factor w in each
// entry; u, v and w are polynomials in t.
template <number::RoundedNumber Number>
std::vector<Number> eliminated(const RoundedPiece<Number>& piece, const std::vector<Number>& u,
                               const std::vector<Number>& v, const std::vector<Number>& w) {
  using Polynomial = std::vector<Number>;
  const bool straight = piece.u[2] == 0 && piece.v[2] == 0 && piece.u[3] == 0 && piece.v[3] == 0;
  const std::size_t n = straight ? 1 : piece.u[3] == 0 && piece.v[3] == 0 ? 2 : 3;
  const auto add_bracket = [&](Polynomial& sum, std::size_t p, std::size_t q, const Number& sign) {
    const Number minor = piece.u[p] * piece.v[q] - piece.u[q] * piece.v[p];
    add(sum, w, Number(sign * minor));
    if (q == 0) {
      add(sum, v, Number(-sign * piece.u[p]));
      add(sum, u, Number(sign * piece.v[p]));
    }
  };
  std::array<std::array<Polynomial, 3>, 3> m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k <= std::min(i, n - 1 - j); ++k) {
        const std::size_t p = j + k + 1;
        const std::size_t q = i - k;
        if (p != q) {
          add_bracket(m[i][j], std::max(p, q), std::min(p, q), Number(p > q ? 1 : -1));
        }
      }
      m[i][j].resize(std::max({u.size(), v.size(), w.size()}), Number(0));
    }
  }
  if (n == 1) {
    return m[0][0];
  }
  const auto minor = [&m](std::size_t row, std::size_t a, std::size_t b) {
    Polynomial result = multiply(m[row][a], m[row + 1][b]);
    add(result, multiply(m[row][b], m[row + 1][a]), Number(-1));
    return result;
  };
  if (n == 2) {
    return minor(0, 0, 1);
  }
  Polynomial result = multiply(m[0][0], minor(1, 1, 2));
  add(result, multiply(m[0][1], minor(1, 0, 2)), Number(-1));
  add(result, multiply(m[0][2], minor(1, 0, 1)));
  return result;
}

}  // namespace detail

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::foot_of(const Piece& piece, const std::array<Number, 2>& place,
                                   const poly::Solvers& solvers) const -> Foot {
  Foot best{Number(0), std::numeric_limits<Number>::infinity()};
  const auto consider = [&](const Number& s) {
    const Number du = detail::cubic_at(piece.u, s) - place[0];
    const Number dv = detail::cubic_at(piece.v, s) - place[1];
    const Number distance = du * du + dv * dv;
    if (distance < best.distance) {
      best = {s, distance};
    }
  };
  consider(Number(0));
  for (const bool by_v : {false, true}) {
    std::array<Number, 4> c = by_v ? piece.v : piece.u;
    c[0] = c[0] - place[by_v ? 1 : 0];
    const auto roots = poly::real_roots(
        std::span<const Number>(c.data(), static_cast<std::size_t>(piece.degree) + 1),
        poly::Range<Number>{Number(0), Number(1)},
        piece.degree == 3 ? solvers.cubic : poly::default_solver(2));
    for (int k = 0; k < roots.count; ++k) {
      consider(roots.t[k]);
    }
  }
  return best;
}

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::polished(const geometry::Ray<Number>& local, Crossing crossing) const
    -> Crossing {
  using std::abs;
  constexpr int kMostSteps = 4;
  const auto& o = local.origin;
  const auto& d = local.direction;
  const Piece& piece = pieces_[crossing.piece];
  struct Point {
    Number t, s;
    Number p, q, u, v;
    Number off_x, off_y;
  };
  const auto at = [&](const Number& t, const Number& s) {
    const auto [p, q] = scales_at(o.z + t * d.z);
    const Number u = detail::cubic_at(piece.u, s);
    const Number v = detail::cubic_at(piece.v, s);
    return Point{t, s, p, q, u, v, o.x + t * d.x - u * p, o.y + t * d.y - v * q};
  };
  const auto off = [](const Point& point) { return Number(abs(point.off_x) + abs(point.off_y)); };
  Point now = at(crossing.t, crossing.s);
  for (int step = 0; step < kMostSteps; ++step) {
    const Number z = o.z + now.t * d.z;
    const Number x_t = d.x - now.u * detail::slope_at(scale_x_, z) * d.z;
    const Number y_t = d.y - now.v * detail::slope_at(scale_y_, z) * d.z;
    const Number x_s = -detail::cubic_slope_at(piece.u, now.s) * now.p;
    const Number y_s = -detail::cubic_slope_at(piece.v, now.s) * now.q;
    const Number determinant = x_t * y_s - x_s * y_t;
    const Point next = at(now.t - (now.off_x * y_s - now.off_y * x_s) / determinant,
                          now.s - (x_t * now.off_y - y_t * now.off_x) / determinant);
    if (!(off(next) < off(now))) {
      break;
    }
    now = next;
  }
  // Rounding may take s beyond an end of its piece.
  crossing.t = now.t;
  crossing.s = now.s < 0 ? Number(0) : now.s;
  if (!(crossing.s < 1)) {
    crossing.s = Number(0);
    crossing.piece = crossing.piece + 1 < pieces_.size() ? crossing.piece + 1 : 0;
  }
  return crossing;
}

template <number::RoundedNumber Number>
void RoundedSweep<Number>::find_by_sides(const geometry::Ray<Number>& as_given,
                                         const poly::Solvers& solvers,
                                         std::vector<Crossing>& crossings) const {
  using std::abs;
  using InT = std::vector<Number>;  // a polynomial, ascending
  // From the ray's point that is nearest to the origin: from far away powers of t are of any size.
  const auto& d = as_given.direction;
  const Number shift = -dot(as_given.origin, d) / dot(d, d);
  const geometry::Ray<Number> local{as_given.origin + shift * d, d};
  const auto& o = local.origin;
  const InT z{o.z, d.z};
  const auto as_it_is = [](const Number& c) { return c; };
  const InT p = composed(scale_x_, z, as_it_is);
  const InT q = composed(scale_y_, z, as_it_is);
  const bool alike = scale_x_ == scale_y_;
  const InT u = alike ? InT{o.x, d.x} : multiply({o.x, d.x}, q);
  const InT v = alike ? InT{o.y, d.y} : multiply({o.y, d.y}, p);
  const InT w = alike ? p : multiply(p, q);
  std::vector<Crossing> candidates;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const InT f = detail::eliminated(pieces_[i], u, v, w);
    const int degree = static_cast<int>(f.size()) - 1;
    const auto roots = poly::real_roots<Number>(
        f, {}, poly::fits(solvers.sextic, degree) ? solvers.sextic : poly::default_solver(degree));
    for (int k = 0; k < roots.count; ++k) {
      if (roots.t[k] - roots.t[k] == 0) {
        candidates.push_back({roots.t[k], Number(0), i});
      }
    }
  }
  if (candidates.empty()) {
    return;
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
  std::vector<Crossing> scratch;
  const auto side_at = [&](const Number& t) { return side(o + t * d, solvers, scratch); };
  const Number before = candidates.front().t;
  int last = side_at(before - abs(before) - 1);
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto end = std::find_if(first, candidates.end(),
                                  [first](const Crossing& later) { return first->t < later.t; });
    const Number t = first->t;
    const int next =
        side_at(end == candidates.end() ? Number(t + abs(t) + 1) : Number(t + (end->t - t) / 2));
    if (next != 0 && next == -last) {
      const geometry::Vector3<Number> at = o + t * d;
      const auto [scale_x, scale_y] = scales_at(at.z);
      const std::array<Number, 2> place{at.x / scale_x, at.y / scale_y};
      Foot least{Number(0), std::numeric_limits<Number>::infinity()};
      Crossing crossing = *first;
      for (auto candidate = first; candidate != end; ++candidate) {
        const Foot foot = foot_of(pieces_[candidate->piece], place, solvers);
        if (foot.distance < least.distance) {
          least = foot;
          crossing = {t, foot.s, candidate->piece};
        }
      }
      crossings.push_back(polished(local, crossing));
      crossings.back().t = crossings.back().t + shift;
    }
    last = next != 0 ? next : last;
    first = end;
  }
}

}  // namespace lamina::surface
