// Polynomials with rounded coefficients, of any degree that fits on the stack.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "number/traits.hpp"

namespace lamina::poly {

using number::RoundedNumber;

/// The highest degree of the rounded root finders; the exact one has no limit.
inline constexpr int kMostDegree = 16;

/// c[0] + c[1] t + ... + c[degree] t^degree. Never allocates.
template <RoundedNumber Number>
struct Polynomial {
  std::array<Number, kMostDegree + 1> c;  ///< above the degree: unset
  int degree = -1;                        ///< c[degree] is not zero; -1 for the zero polynomial

  Polynomial() = default;
  /// Leading zeros lower the degree. Contract: at most kMostDegree + 1 coefficients.
  explicit Polynomial(std::span<const Number> ascending) {
    for (std::size_t i = 0; i < ascending.size(); ++i) {
      c[i] = ascending[i];
      if (!(ascending[i] == 0)) {
        degree = static_cast<int>(i);
      }
    }
  }
};

/// Returns p(t) by Horner's rule: off by at most 2 n u sum |c_i t^i| (Higham 2002, section 5.1).
template <RoundedNumber Number>
Number value(const Polynomial<Number>& p, const Number& t) {
  Number sum = p.c[p.degree];
  for (int i = p.degree - 1; i >= 0; --i) {
    sum = sum * t + p.c[i];
  }
  return sum;
}

template <RoundedNumber Number>
struct ValueAndSlope {
  Number value;
  Number slope;
};

/// Returns p(t) and p'(t) by Horner's rule.
template <RoundedNumber Number>
ValueAndSlope<Number> value_and_slope(const Polynomial<Number>& p, const Number& t) {
  ValueAndSlope<Number> at{p.c[p.degree], Number(0)};
  for (int i = p.degree - 1; i >= 0; --i) {
    at.slope = at.slope * t + at.value;
    at.value = at.value * t + p.c[i];
  }
  return at;
}

template <RoundedNumber Number>
struct TaylorAt {
  Number value;
  Number slope;
  Number half_bend;  ///< p''(t) / 2
};

/// A degree is an int, or where it is known when compiling a std::integral_constant, by which
/// loops over it are unrolled: the most that it can be.
template <typename Degree>
inline constexpr int kMostOf = kMostDegree;
template <int kDegree>
inline constexpr int kMostOf<std::integral_constant<int, kDegree>> = kDegree;

/// Returns p(t), p'(t) and p''(t) / 2 by Horner's rule. Contract: p has this degree.
template <typename Degree, RoundedNumber Number>
TaylorAt<Number> taylor_at(const Polynomial<Number>& p, Degree degree, const Number& t) {
  TaylorAt<Number> at{p.c[degree], Number(0), Number(0)};
  for (int i = degree - 1; i >= 0; --i) {
    at.half_bend = at.half_bend * t + at.slope;
    at.slope = at.slope * t + at.value;
    at.value = at.value * t + p.c[i];
  }
  return at;
}

/// Contract: the degree is at least 1.
template <RoundedNumber Number>
Polynomial<Number> derivative(const Polynomial<Number>& p) {
  Polynomial<Number> slope;
  slope.degree = p.degree - 1;
  for (int i = 1; i <= p.degree; ++i) {
    slope.c[i - 1] = Number(i) * p.c[i];
  }
  return slope;
}

/// Returns a power of two that no root exceeds in magnitude: at least Fujiwara's bound
/// 2 max |c_(n-k) / c_n|^(1/k), by exponents alone. Contract: finite, the degree is at least 1.
template <RoundedNumber Number>
Number root_bound(const Polynomial<Number>& p) {
  using std::frexp;
  using std::ldexp;
  const auto exponent = [](const Number& x) {  // 2^(exponent-1) <= |x| < 2^exponent
    int e = 0;
    (void)frexp(x, &e);
    return e;
  };
  const int leading = exponent(p.c[p.degree]) - 1;
  bool any = false;
  int most = 0;
  for (int k = 1; k <= p.degree; ++k) {
    const Number& c = p.c[p.degree - k];
    if (c == 0) {
      continue;
    }
    const int e = exponent(c) - leading;
    const int rooted = e >= 0 ? (e + k - 1) / k : -(-e / k);  // e/k rounded up
    most = any ? std::max(most, rooted) : rooted;
    any = true;
  }
  if (!any) {
    return Number(0);
  }
  const int most_exponent = std::numeric_limits<Number>::max_exponent - 2;  // twice it is finite
  const int least_exponent = std::numeric_limits<Number>::min_exponent;
  return ldexp(Number(1), std::clamp(most + 1, least_exponent, most_exponent));
}

}  // namespace lamina::poly
