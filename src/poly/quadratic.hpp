// Quadratic equations in rounded arithmetic.
#pragma once

#include <cmath>

#include "number/fused.hpp"
#include "poly/line_roots.hpp"

namespace lamina::poly {

/// Returns the crossings of a t^2 + 2 b t + c; of 2 b t + c where a is zero; none where
/// both are.
///
/// Plain:   the textbook's (-b -+ sqrt(b^2 - ac)) / a. The discriminant has no relative error
///          bound, and the root of smaller magnitude loses the digits that b and the square
///          root share.
/// Careful: the discriminant by Kahan's scheme (at most 3/2 ulp for the given coefficients),
///          the roots q/a and c/q with q = -(b + sign(b) sqrt(b^2 - ac)), which cancel
///          nothing. Each root then has a relative error of a few units of roundoff, unless
///          the discriminant itself underflows.
template <RoundedNumber Number>
LineRoots<Number> quadratic_crossings(const Number& a, const Number& b, const Number& c,
                                      QuadraticSolver solver) {
  using std::sqrt;
  LineRoots<Number> roots;
  if (a == 0) {
    if (b != 0) {
      roots.cross(Number(-c / (b + b)));
    }
    return roots;
  }
  const bool careful = solver == QuadraticSolver::Careful;
  const Number discriminant =
      careful ? number::difference_of_products(b, b, a, c) : Number(b * b - a * c);
  if (!(discriminant > 0)) {
    return roots;
  }
  const Number root = sqrt(discriminant);
  if (careful) {
    const Number q = b < 0 ? Number(root - b) : Number(-(b + root));
    roots.cross(Number(q / a));
    roots.cross(Number(c / q));
  } else {
    roots.cross(Number((-b - root) / a));
    roots.cross(Number((root - b) / a));
  }
  return roots;
}

}  // namespace lamina::poly
