#pragma once

#include "base/contract.hpp"
#include "number/fused.hpp"
#include "poly/quadratic.hpp"
#include "surface/rounded_surface.hpp"

namespace lamina::surface {

template <RoundedNumber Number>
RoundedMap<Number>::RoundedMap(const geometry::AffineMap& exact) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      rows_[i][j] = number::number_traits<Number>::from_exact(exact.rows[i][j]);
    }
  }
}

template <RoundedNumber Number>
geometry::Vector3<Number> RoundedMap<Number>::direction(const geometry::Vector3<Number>& v) const {
  const auto row = [&v](const std::array<Number, 4>& r) -> Number {
    return r[0] * v.x + r[1] * v.y + r[2] * v.z;
  };
  return {row(rows_[0]), row(rows_[1]), row(rows_[2])};
}

template <RoundedNumber Number>
geometry::Vector3<Number> RoundedMap<Number>::point(const geometry::Vector3<Number>& p) const {
  const geometry::Vector3<Number> turned = direction(p);
  return {turned.x + rows_[0][3], turned.y + rows_[1][3], turned.z + rows_[2][3]};
}

template <RoundedNumber Number>
geometry::Vector3<Number> RoundedMap<Number>::magnitude(const geometry::Vector3<Number>& p) const {
  using std::abs;
  const auto row = [&p](const std::array<Number, 4>& r) -> Number {
    return abs(r[0] * p.x) + abs(r[1] * p.y) + abs(r[2] * p.z) + abs(r[3]);
  };
  return {row(rows_[0]), row(rows_[1]), row(rows_[2])};
}

template <RoundedNumber Number>
geometry::Vector3<Number> RoundedMap<Number>::gradient_to_world(
    const geometry::Vector3<Number>& g) const {
  const auto column = [&](std::size_t j) -> Number {
    return rows_[0][j] * g.x + rows_[1][j] * g.y + rows_[2][j] * g.z;
  };
  return {column(0), column(1), column(2)};
}

template <RoundedNumber Number>
RoundedSurface<Number>::RoundedSurface(const LocalSurface& exact) : kind_(exact.kind) {
  LAMINA_REQUIRE(kind_ != Kind::Sweep, "a sweep is a RoundedSweep");
  for (std::size_t i = 0; i < c_.size(); ++i) {
    c_[i] = number::number_traits<Number>::from_exact(exact.coefficients[i]);
  }
}

template <RoundedNumber Number>
RayPolynomial<Number> RoundedSurface<Number>::polynomial(const geometry::Ray<Number>& local,
                                                         bool recentred) const {
  RayPolynomial<Number> p;
  geometry::Vector3<Number> o = local.origin;
  const auto& d = local.direction;
  if (recentred) {
    // Any shift will do, so that its own rounding does no harm; the point is rounded once.
    p.shift = -dot(o, d) / dot(d, d);
    o = {number::fused_multiply_add(p.shift, d.x, o.x),
         number::fused_multiply_add(p.shift, d.y, o.y),
         number::fused_multiply_add(p.shift, d.z, o.z)};
  }
  std::array<Number, 5>& f = p.c;
  switch (kind_) {
    case Kind::Plane:
      p.degree = 1;
      f[0] = c_[0] * o.x + c_[1] * o.y + c_[2] * o.z + c_[3];
      f[1] = c_[0] * d.x + c_[1] * d.y + c_[2] * d.z;
      break;
    case Kind::Quadric: {
      p.degree = 2;
      // With g the gradient of the quadratic part: g(v).w is twice the bilinear form.
      const auto half_gradient = [this](const geometry::Vector3<Number>& v) {
        return geometry::Vector3<Number>{c_[0] * v.x + (c_[3] * v.y + c_[4] * v.z) / 2,
                                         c_[1] * v.y + (c_[3] * v.x + c_[5] * v.z) / 2,
                                         c_[2] * v.z + (c_[4] * v.x + c_[5] * v.y) / 2};
      };
      const Number linear_o = c_[6] * o.x + c_[7] * o.y + c_[8] * o.z;
      const Number linear_d = c_[6] * d.x + c_[7] * d.y + c_[8] * d.z;
      const geometry::Vector3<Number> along = half_gradient(d);
      f[2] = dot(along, d);
      f[1] = 2 * (dot(along, o) + linear_d / 2);
      f[0] = dot(half_gradient(o), o) + linear_o + c_[9];
      break;
    }
    case Kind::Torus: {
      p.degree = 4;
      const Number four_major_squared = 4 * c_[0] * c_[0];
      const Number dd = dot(d, d);
      const Number od = dot(o, d);
      const Number k = dot(o, o) + (c_[0] - c_[1]) * (c_[0] + c_[1]);
      f[4] = dd * dd;
      f[3] = 4 * dd * od;
      f[2] = 2 * dd * k + 4 * od * od - four_major_squared * (d.x * d.x + d.y * d.y);
      f[1] = 4 * od * k - 2 * four_major_squared * (o.x * d.x + o.y * d.y);
      f[0] = k * k - four_major_squared * (o.x * o.x + o.y * o.y);
      break;
    }
    case Kind::Sweep:
      break;
  }
  return p;
}

template <RoundedNumber Number>
bool RoundedSurface<Number>::is_recentred(const geometry::Vector3<Number>& origin,
                                          poly::Recentring which) const {
  if (kind_ == Kind::Torus && which != poly::Recentring::None) {
    const Number outer_diameter = 2 * (c_[0] + c_[1]);
    return dot(origin, origin) > outer_diameter * outer_diameter;
  }
  return kind_ == Kind::Quadric && which == poly::Recentring::All;
}

template <RoundedNumber Number>
SurfaceCrossings<Number> RoundedSurface<Number>::crossings(const geometry::Ray<Number>& local,
                                                           const poly::Solvers& solvers,
                                                           bool starts_on) const {
  const bool is_torus = kind_ == Kind::Torus;
  RayPolynomial<Number> p =
      polynomial(local, !starts_on && is_recentred(local.origin, solvers.recentring));
  std::array<Number, 5>& f = p.c;
  const poly::Solver solver = is_torus ? solvers.quartic : solvers.quadratic;
  SurfaceCrossings<Number> result;
  if (starts_on) {
    f[0] = 0;
    result.roots = poly::crossings(std::span<const Number>(f).subspan(1, p.degree), solver);
    result.roots.cross(Number(0));
  } else if (!is_torus && poly::is_quadratic_formula(solver)) {
    result.roots = poly::quadratic_crossings(f[2], Number(f[1] / 2), f[0], solver);
  } else {
    result.roots = poly::crossings(std::span<const Number>(f).first(p.degree + 1), solver);
  }
  for (int i = 0; p.shift != 0 && i < result.roots.count; ++i) {
    result.roots.t[i] = result.roots.t[i] + p.shift;
  }
  std::size_t degree = 4;
  while (degree > 0 && f[degree] == 0) {
    --degree;
  }
  result.starts_inside = degree % 2 == 0 ? f[degree] < 0 : f[degree] > 0;
  result.in_carrier = degree == 0 && f[0] == 0;
  if (result.in_carrier) {
    result.roots = {};
  }
  return result;
}

template <RoundedNumber Number>
Number RoundedSurface<Number>::value(const geometry::Vector3<Number>& p) const {
  switch (kind_) {
    case Kind::Plane:
      return c_[0] * p.x + c_[1] * p.y + c_[2] * p.z + c_[3];
    case Kind::Quadric:
      return p.x * (c_[0] * p.x + c_[3] * p.y + c_[4] * p.z + c_[6]) +
             p.y * (c_[1] * p.y + c_[5] * p.z + c_[7]) + p.z * (c_[2] * p.z + c_[8]) + c_[9];
    case Kind::Torus: {
      const Number k = dot(p, p) + (c_[0] - c_[1]) * (c_[0] + c_[1]);
      return k * k - 4 * c_[0] * c_[0] * (p.x * p.x + p.y * p.y);
    }
    case Kind::Sweep:
      break;
  }
  return Number(0);
}

template <RoundedNumber Number>
Number RoundedSurface<Number>::rounding_error(const geometry::Vector3<Number>& p) const {
  using std::abs;
  // Roundings of a factor on its way: each local coordinate has 5 (its row's entry, a product,
  // three sums), and f's own coefficients, products and sums come to these, per monomial.
  int roundings = 0;
  Number terms(0);
  switch (kind_) {
    case Kind::Plane:
      roundings = 5 + 5;
      terms = abs(c_[0]) * p.x + abs(c_[1]) * p.y + abs(c_[2]) * p.z + abs(c_[3]);
      break;
    case Kind::Quadric:
      roundings = 2 * 5 + 10;
      terms = p.x * (abs(c_[0]) * p.x + abs(c_[3]) * p.y + abs(c_[4]) * p.z + abs(c_[6])) +
              p.y * (abs(c_[1]) * p.y + abs(c_[5]) * p.z + abs(c_[7])) +
              p.z * (abs(c_[2]) * p.z + abs(c_[8])) + abs(c_[9]);
      break;
    case Kind::Torus: {
      roundings = 4 * 5 + 16;
      const Number k = dot(p, p) + c_[0] * c_[0] + c_[1] * c_[1];
      terms = k * k + 4 * c_[0] * c_[0] * (p.x * p.x + p.y * p.y);
      break;
    }
    case Kind::Sweep:
      break;
  }
  const Number relative = Number(roundings) * number::unit_roundoff<Number>();
  return relative / (1 - relative) * terms;
}

template <RoundedNumber Number>
geometry::Vector3<Number> RoundedSurface<Number>::gradient(
    const geometry::Vector3<Number>& p) const {
  switch (kind_) {
    case Kind::Plane:
      return {c_[0], c_[1], c_[2]};
    case Kind::Quadric:
      return {2 * c_[0] * p.x + c_[3] * p.y + c_[4] * p.z + c_[6],
              2 * c_[1] * p.y + c_[3] * p.x + c_[5] * p.z + c_[7],
              2 * c_[2] * p.z + c_[4] * p.x + c_[5] * p.y + c_[8]};
    case Kind::Torus: {
      const Number k = dot(p, p) + (c_[0] - c_[1]) * (c_[0] + c_[1]);
      const Number across = 4 * (k - 2 * c_[0] * c_[0]);
      return {across * p.x, across * p.y, 4 * k * p.z};
    }
    case Kind::Sweep:
      break;
  }
  return {};
}

}  // namespace lamina::surface
