// Quadratic equations in rounded arithmetic.
#pragma once

#include <cmath>

#include "number/fused.hpp"
#include "poly/line_roots.hpp"
#include "poly/real_roots.hpp"
#include "poly/solver.hpp"

namespace lamina::poly {
namespace detail {

// The root of 2 b t + c, or the two of a t^2 + 2 b t + c; equal ones where the discriminant is
// zero. Returns how many.
template <RoundedNumber Number>
int quadratic(const Number& a, const Number& b, const Number& c, Solver solver,
              std::array<Number, 2>& t) {
  using std::sqrt;
  if (a == 0) {
    if (b == 0) {
      return 0;
    }
    t[0] = -c / (b + b);
    return 1;
  }
  const Number discriminant =
      solver == Solver::Kahan ? number::difference_of_products(b, b, a, c) : Number(b * b - a * c);
  if (!(discriminant >= 0)) {
    return 0;
  }
  if (discriminant == 0) {
    t[0] = t[1] = -b / a;
    return 2;
  }
  const Number root = sqrt(discriminant);
  if (solver == Solver::Textbook) {
    t = {Number((-b - root) / a), Number((root - b) / a)};
  } else {
    const Number q = b < 0 ? Number(root - b) : Number(-(b + root));
    t = {Number(q / a), Number(c / q)};
  }
  return 2;
}

}  // namespace detail

/// Returns the crossings of a t^2 + 2 b t + c; of 2 b t + c where a is zero; none where
/// both are.
///
/// Textbook: (-b -+ sqrt(b^2 - ac)) / a. The discriminant has no relative error bound, and the
///           root of smaller magnitude loses the digits that b and the square root share.
/// Stable:   the roots q/a and c/q with q = -(b + sign(b) sqrt(b^2 - ac)), which cancel
///           nothing; the discriminant as the textbook's.
/// Kahan:    the same with the discriminant by Kahan's scheme (at most 3/2 ulp for the given
///           coefficients). Each root then has a relative error of at most 5 units of roundoff,
///           unless something over- or underflows: 3 u in the discriminant, 5/2 u in its root,
///           7/2 u in q, and one more in the quotient.
template <RoundedNumber Number>
LineRoots<Number> quadratic_crossings(const Number& a, const Number& b, const Number& c,
                                      Solver solver) {
  std::array<Number, 2> t;
  const int count = detail::quadratic(a, b, c, solver, t);
  LineRoots<Number> roots;
  for (int i = 0; i < count; ++i) {
    roots.cross(t[i]);
  }
  return roots;
}

/// Returns the real roots of a polynomial of degree 1 or 2 by the same formulas; a discriminant of
/// exactly zero is a root of multiplicity 2.
template <RoundedNumber Number>
RealRoots<Number> quadratic_roots(const Polynomial<Number>& p, Solver solver) {
  std::array<Number, 2> t;
  RealRoots<Number> roots;
  const Number a = p.degree == 2 ? p.c[2] : Number(0);
  const int count = detail::quadratic(a, Number(p.c[1] / 2), p.c[0], solver, t);
  if (count == 2 && t[0] == t[1]) {
    roots.add(t[0], 2);
    return roots;
  }
  for (int i = 0; i < count; ++i) {
    roots.add(t[i], 1);
  }
  return roots;
}

}  // namespace lamina::poly
