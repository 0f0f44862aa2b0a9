// Real roots between neighbouring roots of the derivative.
#pragma once

#include <algorithm>

#include "poly/newton.hpp"
#include "poly/quadratic.hpp"
#include "poly/real_roots.hpp"
#include "poly/scaling.hpp"

namespace lamina::poly {
namespace detail {

// The roots in [low, high], from the critical points there.
template <RoundedNumber Number>
RealRoots<Number> roots_between(const Polynomial<Number>& p, const RealRoots<Number>& critical,
                                const Number& low, const Number& high) {
  RealRoots<Number> roots;
  Number left = low;
  int left_sign = 0;     // unknown until a value is not zero
  bool at_zero = false;  // the last point was a root
  for (int i = -1; i <= critical.count; ++i) {
    const Number& point = i < 0 ? low : i < critical.count ? critical.t[i] : high;
    if (i >= 0 && !(left < point)) {
      continue;
    }
    const Number at = value(p, point);
    if (at == 0) {
      roots.add(point);
      at_zero = true;
    } else {
      const int sign = at > 0 ? 1 : -1;
      if (at_zero && left_sign != 0) {
        roots.multiplicity[roots.count - 1] = sign == left_sign ? 2 : 3;
      } else if (!at_zero && left_sign != 0 && sign != left_sign) {
        const Number middle = left + (point - left) / 2;
        roots.add(bracketed_root(p, left, point, sign > 0, middle), 1);
      }
      left_sign = sign;
      at_zero = false;
    }
    left = point;
  }
  return roots;
}

}  // namespace detail

/// Returns the real roots in the range: between neighbouring critical points, found in the same
/// way down to the quadratic, a polynomial is monotone, and a sign change there is one root
/// (Yuksel, "High-performance polynomial root finding for graphics", HPG 2022, without its
/// tolerance). Uses + - * / and sqrt only.
///
/// Error:  each root to the last bit of the value by Horner's rule, 2 n u sum |c_i t^i|. Two roots
///         are lost, or found where there are none, if at the critical point between them the
///         value is below that bound; a value of exactly zero there is a root of multiplicity 2,
///         or 3 where the signs beyond it differ.
template <RoundedNumber Number>
RealRoots<Number> monotone_roots(const Polynomial<Number>& given, const Range<Number>& range) {
  // The derivatives grow with n!, and the discriminant is of second degree in the coefficients.
  const Polynomial<Number> p = in_units_of_power_of_two(given, 0);
  // What bounds the roots bounds the critical points, too: these lie in the convex hull of the
  // complex roots (Gauss and Lucas).
  const Number bound = root_bound(p);
  const Number low = std::max(range.low, Number(-bound));
  const Number high = std::min(range.high, bound);
  RealRoots<Number> roots;
  if (!(low <= high)) {
    return roots;
  }
  std::array<Polynomial<Number>, kMostDegree> derivatives;  // by degree
  derivatives[p.degree - 1] = p;
  for (int degree = p.degree - 1; degree > 1; --degree) {
    derivatives[degree - 1] = derivative(derivatives[degree]);
  }
  const RealRoots<Number> first = quadratic_roots(derivatives[1], Solver::Kahan);
  for (int i = 0; i < first.count; ++i) {
    if (low <= first.t[i] && first.t[i] <= high) {
      roots.add(first.t[i], first.multiplicity[i]);
    }
  }
  for (int degree = 3; degree <= p.degree; ++degree) {
    roots = detail::roots_between(derivatives[degree - 1], roots, low, high);
  }
  return roots;
}

}  // namespace lamina::poly
