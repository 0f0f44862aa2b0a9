// Real roots between neighbouring roots of the derivative.
#pragma once

#include <algorithm>

#include "poly/newton.hpp"
#include "poly/quadratic.hpp"
#include "poly/real_roots.hpp"
#include "poly/scaling.hpp"

namespace lamina::poly {
namespace detail {

// Beyond the outermost critical point: steps that double until the sign at infinity shows.
template <RoundedNumber Number>
Number far_bound(const Polynomial<Number>& p, const Number& start, int direction, bool positive) {
  using std::abs;
  Number step = abs(start) > 1 ? Number(abs(start)) : Number(1);
  Number t = start;
  constexpr int kMostSteps = 2048;  // beyond the exponents of double: software floats have 2^31
  for (int i = 0; i < kMostSteps; ++i) {
    const Number next = direction > 0 ? Number(start + step) : Number(start - step);
    if (next == t || !(abs(next) - abs(next) == 0)) {
      return t;  // the end of the number range
    }
    t = next;
    const Number at = value(p, t);
    if (positive ? at > 0 : at < 0) {
      return t;
    }
    step = step * 2;
  }
  return direction > 0 ? root_bound(p) : Number(-root_bound(p));
}

// The roots in the range, from the critical points there.
template <RoundedNumber Number>
RealRoots<Number> roots_between(const Polynomial<Number>& p, const Polynomial<Number>& slope,
                                const RealRoots<Number>& critical, const Range<Number>& range) {
  const auto is_finite = [](const Number& t) { return t - t == 0; };
  const int right = p.c[p.degree] > 0 ? 1 : -1;  // signs at infinity
  const int left = p.degree % 2 == 0 ? right : -right;
  RealRoots<Number> roots;
  Number before = range.low;
  int sign_before = 0;   // unknown until a value is not zero
  bool at_zero = false;  // the last point was a root
  for (int i = -1; i <= critical.count; ++i) {
    Number point;
    int sign = 0;
    if (i < 0 && !is_finite(range.low)) {
      const Number first = critical.count > 0 ? critical.t[0] : Number(0);
      point = far_bound(p, first, -1, left > 0);
      sign = left;
    } else if (i == critical.count && !is_finite(range.high)) {
      const Number last = critical.count > 0 ? critical.t[critical.count - 1] : Number(0);
      point = far_bound(p, last, 1, right > 0);
      sign = right;
    } else {
      point = i < 0 ? range.low : i < critical.count ? critical.t[i] : range.high;
      const Number at = value(p, point);
      sign = at > 0 ? 1 : at < 0 ? -1 : 0;
    }
    if (i >= 0 && !(before < point)) {
      continue;
    }
    if (sign == 0) {
      roots.add(point);
      at_zero = true;
    } else {
      if (at_zero && sign_before != 0) {
        roots.multiplicity[roots.count - 1] = sign == sign_before ? 2 : 3;
      } else if (!at_zero && sign_before != 0 && sign != sign_before) {
        roots.add(newton_root(p, slope, before, point, sign > 0), 1);
      }
      sign_before = sign;
      at_zero = false;
    }
    before = point;
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
  RealRoots<Number> roots;
  if (!(range.low <= range.high)) {
    return roots;
  }
  std::array<Polynomial<Number>, kMostDegree> derivatives;  // by degree
  derivatives[p.degree - 1] = p;
  for (int degree = p.degree - 1; degree > 1; --degree) {
    derivatives[degree - 1] = derivative(derivatives[degree]);
  }
  const RealRoots<Number> first = quadratic_roots(derivatives[1], Solver::Kahan);
  for (int i = 0; i < first.count; ++i) {
    if (range.contains(first.t[i])) {
      roots.add(first.t[i], first.multiplicity[i]);
    }
  }
  for (int degree = 3; degree <= p.degree; ++degree) {
    roots = detail::roots_between(derivatives[degree - 1], derivatives[degree - 2], roots, range);
  }
  return roots;
}

}  // namespace lamina::poly
