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
  if (!(nearest - nearest == 0)) {  // beyond the range
    return exact < 0 ? nearest : std::numeric_limits<Number>::max();
  }
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

// Of a piece whose coefficients are these: two or four.
template <number::RoundedNumber Number>
std::array<Number, 4> control_points(const std::vector<number::Rational>& c) {
  const number::Rational c_2 = c.size() > 2 ? c[2] : number::Rational(0);
  const number::Rational end = geometry::value_at(c, number::Rational(1));
  const auto rounded = [](const number::Rational& q) {
    return number::number_traits<Number>::from_exact(q);
  };
  return {rounded(c[0]), rounded(c[0] + c[1] / 3), rounded(c[0] + (2 * c[1] + c_2) / 3),
          rounded(end)};
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
Number value_at(const std::vector<Number>& ascending, const Number& z) {
  Number value(0);
  for (auto c = ascending.rbegin(); c != ascending.rend(); ++c) {
    value = value * z + *c;
  }
  return value;
}

template <number::RoundedNumber Number>
Number slope_at(const std::vector<Number>& ascending, const Number& z) {
  Number slope(0);
  for (std::size_t i = ascending.size() - 1; i > 0; --i) {
    slope = slope * z + static_cast<Number>(static_cast<int>(i)) * ascending[i];
  }
  return slope;
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
RoundedSweep<Number>::RoundedSweep(const SweptSurface& exact, const AsPrinted& printed)
    : sweep_(exact.sweep()), orientation_(exact.contour().orientation()), printed_(printed) {
  using Traits = number::number_traits<Number>;
  const geometry::Contour& contour = exact.contour();
  const auto count = static_cast<std::uint32_t>(contour.pieces().size());
  // Is there no surface where a piece begins or ends, but the axis?
  const auto is_pole = [&](std::uint32_t neighbour, bool at_end_of_all) {
    return (at_end_of_all && !contour.closed()) || !exact.sweeps(neighbour);
  };
  std::transform(exact.scaling().x.begin(), exact.scaling().x.end(), std::back_inserter(scale_x_),
                 Traits::from_exact);
  std::transform(exact.scaling().y.begin(), exact.scaling().y.end(), std::back_inserter(scale_y_),
                 Traits::from_exact);
  std::vector<PlaneBox<Number>> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const geometry::ContourPiece& from = contour.pieces()[i];
    const geometry::Rectangle& box = contour.boxes()[i];
    Piece piece{static_cast<int>(from.u.size()) - 1,
                {},
                {},
                {detail::control_points<Number>(from.u), detail::control_points<Number>(from.v)},
                {detail::rounded_down<Number>(box.u_min), detail::rounded_up<Number>(box.u_max),
                 detail::rounded_down<Number>(box.v_min), detail::rounded_up<Number>(box.v_max)},
                exact.sweeps(i),
                is_pole((i + count - 1) % count, i == 0),
                is_pole((i + 1) % count, i + 1 == count)};
    piece.u.fill(Number(0));
    piece.v.fill(Number(0));
    std::transform(from.u.begin(), from.u.end(), piece.u.begin(), Traits::from_exact);
    std::transform(from.v.begin(), from.v.end(), piece.v.begin(), Traits::from_exact);
    boxes.push_back(piece.box);
    pieces_.push_back(std::move(piece));
  }
  tree_ = BoxTree<Number>(boxes);
}

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::scales_at(const Number& z) const -> Scales {
  return {detail::value_at(scale_x_, z), detail::value_at(scale_y_, z)};
}

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::image(const geometry::Ray<Number>& local) const -> Image {
  using std::abs;
  using std::sqrt;
  const auto& [o, d] = local;
  Image e;
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
    case Sweep::GeneralisedConic: {  // of a level ray
      const auto [p, q] = scales_at(o.z);
      e.u = d.y * p;
      e.v = -d.x * q;
      e.most_u = abs(e.u);
      e.most_v = abs(e.v);
      e.constant = minor(d.x, o.y, d.y, o.x, e.most_constant);
      break;
    }
    case Sweep::Rotational: {
      if (is_level(local)) {
        e.v = e.most_v = Number(1);
        e.constant = -o.z;
        e.most_constant = abs(o.z);
        break;
      }
      if (is_upright(local)) {
        e.u = Number(-1);
        e.most_u = Number(1);
        e.constant = e.most_constant = sqrt(o.x * o.x + o.y * o.y);
        break;
      }
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

template <number::RoundedNumber Number>
bool RoundedSweep<Number>::rules_out(const geometry::Ray<Number>& local,
                                     std::uint32_t piece) const {
  return image(local).over(pieces_[piece].box).exclude_zero();
}

template <number::RoundedNumber Number>
auto RoundedSweep<Number>::polynomial(const Piece& piece, const Image& e) const -> Polynomial {
  Polynomial p;
  p.c.fill(Number(0));
  p.degree = piece.degree;
  for (std::size_t k = 0; k < piece.u.size(); ++k) {
    p.c[k] = e.u * piece.u[k] + e.v * piece.v[k];
  }
  p.c[0] = p.c[0] + e.constant;
  if (!e.is_line()) {
    detail::add_product(p.c, e.vv, piece.v, piece.v);
    detail::add_product(p.c, e.uu, piece.u, piece.u);
    p.degree *= 2;
  }
  return p;
}

template <number::RoundedNumber Number>
poly::RealRoots<Number> RoundedSweep<Number>::roots_of(const Piece& piece, const Image& e,
                                                       const poly::Solvers& solvers) const {
  const Polynomial p = polynomial(piece, e);
  return poly::real_roots(
      std::span<const Number>(p.c.data(), static_cast<std::size_t>(p.degree) + 1),
      poly::Range<Number>{Number(0), Number(1)},
      p.degree == 6   ? solvers.sextic
      : p.degree == 3 ? solvers.cubic
                      : poly::default_solver(2));
}

template <number::RoundedNumber Number>
template <typename Cross>
bool RoundedSweep<Number>::search(const Piece& piece, const Image& e, const poly::Solvers& solvers,
                                  const Cross& cross) const {
  switch (solvers.search) {
    case poly::SweepSearch::Polynomial:
      break;
    case poly::SweepSearch::Subdivision:
      return cross_by_subdivision(e, piece, cross);
    case poly::SweepSearch::StripTree:
      return cross_by_strips(e, piece, cross);
  }
  const poly::RealRoots<Number> roots = roots_of(piece, e, solvers);
  bool passed_pole = false;
  for (int k = 0; k < roots.count; ++k) {
    const Number& s = roots.t[k];
    if ((piece.from_pole && s == 0) || (piece.to_pole && s == 1)) {
      if (!passed_pole) {
        cross(s);
      }
      passed_pole = true;
      continue;
    }
    const bool touches = roots.multiplicity[k] != 0 && roots.multiplicity[k] % 2 == 0;
    if (!touches && s < 1) {
      cross(s);
    }
  }
  return roots.outcome != poly::Outcome::Everywhere;
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
    case Sweep::GeneralisedConic: {  // of a level ray
      const auto [p, q] = scales_at(o.z);
      add(detail::of_larger_divisor<Number>({{u * p - o.x, d.x}, {v * q - o.y, d.y}}));
      break;
    }
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
geometry::Ray<Number> RoundedSweep<Number>::with_small_values(geometry::Ray<Number> local) const {
  auto& d = local.direction;
  if (printed_.small_value) {
    const auto small = static_cast<Number>(*printed_.small_value);
    const bool conic = sweep_ == Sweep::Conic || sweep_ == Sweep::GeneralisedConic;
    if (!conic && d.x == 0 && d.y == 0) {
      d.x = d.y = small;
    }
    if (is_level(local)) {
      d.z = small;
    }
  }
  return local;
}

template <number::RoundedNumber Number>
bool RoundedSweep<Number>::find_crossings(const geometry::Ray<Number>& as_given,
                                          const poly::Solvers& solvers,
                                          std::vector<Crossing>& crossings) const {
  const geometry::Ray<Number> local = with_small_values(as_given);
  const auto& [o, d] = local;
  crossings.clear();
  if (sweep_ == Sweep::Translational && d.x == 0 && d.y == 0) {
    return true;
  }
  if (sweep_ == Sweep::GeneralisedConic) {
    if (d.z != 0) {
      find_by_sides(local, solvers, crossings);
      return true;
    }
    if (const auto [p, q] = scales_at(o.z); p == 0 || q == 0) {
      return true;
    }
  }
  bool runs_along = false;
  const Image e = image(local);
  const Number square = d.x * d.x + d.y * d.y;
  const Number across = d.x * o.y - d.y * o.x;
  const auto add_of_piece = [&](std::uint32_t i) {
    const Piece& piece = pieces_[i];
    if (!piece.sweeps || e.over(piece.box).exclude_zero()) {
      return true;
    }
    // At the height of a flat piece, but beyond its rim.
    if (is_level(local) && across * across > square * piece.box.u_max * piece.box.u_max) {
      return true;
    }
    const bool crosses = search(piece, e, solvers, [&](const Number& s) {
      if (s < 1 || piece.to_pole) {
        add_crossings(local, i, s, crossings);
      } else {
        add_crossings(local, i + 1 < pieces_.size() ? i + 1 : 0, Number(0), crossings);
      }
    });
    runs_along = !crosses;
    return crosses;
  };
  if (printed_.each_piece) {
    std::uint32_t i = 0;
    while (i < pieces_.size() && add_of_piece(i)) {
      ++i;
    }
  } else {
    // A bound over a rectangle is off by 9.1 u of its absolute terms, so that a rectangle in it, of
    // smaller terms, has one which is above it but for twice that: three times 16 u leave to it
    // more than its own 16 u. So what is excluded here, its own rectangle rules out.
    tree_.visit_pieces([&e](const PlaneBox<Number>& box) { return e.over(box).exclude_zero(3); },
                       add_of_piece);
  }
  if (runs_along) {
    crossings.clear();
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
  return !runs_along;
}

template <number::RoundedNumber Number>
geometry::Vector3<Number> RoundedSweep<Number>::normal(const geometry::Vector3<Number>& local,
                                                       const Crossing& crossing) const {
  using std::sqrt;
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
      const Number radial = n_u * u + n_v * v;
      Number n_z = -radial;
      if (printed_.conic_normal) {
        n_z = sqrt((u * u + v * v) * (n_u * n_u + n_v * n_v));
        n_z = radial < 0 ? n_z : Number(-n_z);
      }
      const geometry::Vector3<Number> normal{n_u, n_v, n_z};
      return local.z < 0 ? Number(-1) * normal : normal;
    }
    case Sweep::GeneralisedConic: {
      const auto [p, q] = scales_at(local.z);
      const Number u = detail::cubic_at(piece.u, crossing.s);
      const Number v = detail::cubic_at(piece.v, crossing.s);
      const Number n_z = -(n_u * u * detail::slope_at(scale_x_, local.z) * q +
                           n_v * v * detail::slope_at(scale_y_, local.z) * p);
      const geometry::Vector3<Number> normal{n_u * q, n_v * p, n_z};
      return (p < 0) != (q < 0) ? Number(-1) * normal : normal;
    }
    case Sweep::Rotational: {
      const Number u = detail::cubic_at(piece.u, crossing.s);
      if (!(u > 0)) {  // on the axis
        return {Number(0), Number(0), n_v};
      }
      return {n_u * local.x, n_u * local.y, n_v * u};
    }
  }
  return {};
}

template <number::RoundedNumber Number>
int RoundedSweep<Number>::side(const geometry::Vector3<Number>& local, const poly::Solvers& solvers,
                               std::vector<Crossing>& scratch) const {
  if (sweep_ == Sweep::Conic && local.z == 0) {
    return local.x == 0 && local.y == 0 ? 0 : 1;
  }
  // Two directions that span the contour's plane at the point; the first goes away from the axis.
  using Vector = geometry::Vector3<Number>;
  const bool is_turned = sweep_ == Sweep::Rotational;
  const bool is_aside = is_turned && (local.x != 0 || local.y != 0);
  const Vector across =
      is_aside ? Vector{local.x, local.y, Number(0)} : Vector{Number(1), Number(0), Number(0)};
  const Vector up =
      is_turned ? Vector{Number(0), Number(0), Number(1)} : Vector{Number(0), Number(1), Number(0)};
  // No more lines through the point than there are pieces can have one of these on them.
  const auto most = static_cast<int>(pieces_.size());
  bool found = find_crossings({local, across}, solvers, scratch);
  for (int slope = 1; !found && slope <= most; ++slope) {
    found = find_crossings({local, across + static_cast<Number>(slope) * up}, solvers, scratch);
  }
  int side = 1;
  for (const Crossing& crossing : scratch) {
    if (crossing.t == 0) {
      return 0;
    }
    side = crossing.t > 0 ? -side : side;
  }
  return side;
}

template <number::RoundedNumber Number>
int RoundedSweep<Number>::side_at_minus_infinity(const geometry::Ray<Number>& local,
                                                 const std::vector<Crossing>& crossings,
                                                 const poly::Solvers& solvers,
                                                 std::vector<Crossing>& scratch) const {
  using std::abs;
  const auto& [o, d] = local;
  if (sweep_ == Sweep::Translational && d.x == 0 && d.y == 0) {
    return side(o, solvers, scratch);
  }
  if (sweep_ == Sweep::GeneralisedConic) {
    if (crossings.empty()) {
      return d.z == 0 || side(o, solvers, scratch) >= 0 ? 1 : -1;
    }
    const Number first = crossings.front().t;
    return d.z == 0 ? 1 : side(o + Number(first - abs(first) - 1) * d, solvers, scratch);
  }
  if (sweep_ != Sweep::Conic || d.z == 0) {
    return 1;
  }
  // Far away, the ray is where its direction points; or, beside a ruling that it is parallel to,
  // where it is before all that happens to it.
  if (const int far = side(d, solvers, scratch); far != 0) {
    return far;
  }
  Number before = -o.z / d.z;
  if (!crossings.empty() && crossings.front().t < before) {
    before = crossings.front().t;
  }
  before = 2 * before < before ? Number(2 * before) : Number(0);
  return side(o + Number(before - 1) * d, solvers, scratch);
}

template <number::RoundedNumber Number>
Number RoundedSweep<Number>::value(const geometry::Vector3<Number>& local,
                                   const Crossing& crossing) const {
  using std::sqrt;
  const geometry::Vector3<Number> n = normal(local, crossing);
  const Number u = detail::cubic_at(pieces_[crossing.piece].u, crossing.s);
  const Number v = detail::cubic_at(pieces_[crossing.piece].v, crossing.s);
  switch (sweep_) {
    case Sweep::Translational:
      return n.x * (local.x - u) + n.y * (local.y - v);
    case Sweep::Conic:
      return n.x * (local.x - u * local.z) + n.y * (local.y - v * local.z);
    case Sweep::GeneralisedConic: {
      const auto [p, q] = scales_at(local.z);
      return n.x * (local.x - u * p) + n.y * (local.y - v * q);
    }
    case Sweep::Rotational: {
      // With n_u times the radius for both n.x and n.y.
      const Number radius = sqrt(local.x * local.x + local.y * local.y);
      const Number across = sqrt(n.x * n.x + n.y * n.y);
      const bool outward = n.x * local.x + n.y * local.y >= 0;
      return (outward ? across : Number(-across)) * (radius - u) + n.z * (local.z - v);
    }
  }
  return Number(0);
}

// Roundings on the way to a term: 5 of a local coordinate (its row's entry, a product, three sums),
// 3 more of a radius, 7 of a point of the curve (a coefficient, and Horner's rule), and 3 for the
// difference, its product and the sum. What n is off by changes the plane's tilt, which is of
// second order. 16 are enough for all.
template <number::RoundedNumber Number>
Number RoundedSweep<Number>::rounding_error(const geometry::Vector3<Number>& magnitude,
                                            const Crossing& crossing) const {
  using std::abs;
  using std::sqrt;
  const Piece& piece = pieces_[crossing.piece];
  const auto most = [&crossing](const std::array<Number, 4>& c) -> Number {
    return ((abs(c[3]) * crossing.s + abs(c[2])) * crossing.s + abs(c[1])) * crossing.s + abs(c[0]);
  };
  const Number u = most(piece.u);
  const Number v = most(piece.v);
  const Number n_u = abs(detail::cubic_slope_at(piece.v, crossing.s));
  const Number n_v = abs(detail::cubic_slope_at(piece.u, crossing.s));
  int roundings = 16;
  Number terms(0);
  switch (sweep_) {
    case Sweep::Translational:
      terms = n_u * (magnitude.x + u) + n_v * (magnitude.y + v);
      break;
    case Sweep::Conic:
      terms = n_u * (magnitude.x + u * magnitude.z) + n_v * (magnitude.y + v * magnitude.z);
      break;
    case Sweep::GeneralisedConic: {
      // p, of degree 5 at most, has 5 powers of a local coordinate, and 11 roundings by Horner's
      // rule; it stands in a term once, as does q.
      roundings += 2 * (5 * 5 + 11);
      const auto size_at = [](const std::vector<Number>& ascending, const Number& z) {
        Number sum(0);
        for (auto c = ascending.rbegin(); c != ascending.rend(); ++c) {
          sum = sum * z + abs(*c);
        }
        return sum;
      };
      const Number p = size_at(scale_x_, magnitude.z);
      const Number q = size_at(scale_y_, magnitude.z);
      terms = n_u * q * (magnitude.x + u * p) + n_v * p * (magnitude.y + v * q);
      break;
    }
    case Sweep::Rotational: {
      const Number radius = sqrt(magnitude.x * magnitude.x + magnitude.y * magnitude.y);
      terms = radius * (n_u * (radius + u) + n_v * (magnitude.z + v));
      break;
    }
  }
  const Number relative = static_cast<Number>(roundings) * number::unit_roundoff<Number>();
  return relative / (1 - relative) * terms;
}

}  // namespace lamina::surface
