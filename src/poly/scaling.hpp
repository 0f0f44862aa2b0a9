// Powers of two taken out of a polynomial, so that its solver does not overflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "poly/polynomial.hpp"

namespace lamina::poly {

/// Returns e with 2^(e-1) <= |x| < 2^e, or one more if x rounds to 2^e as a double; 0 for zero, an
/// infinity and NaN.
template <RoundedNumber Number>
std::int64_t exponent_of(const Number& x) {
  using std::frexp;
  if (!(x - x == 0)) {
    return 0;
  }
  int e = 0;
  (void)frexp(x, &e);
  return e;
}

/// Returns x * 2^e: exact, or an infinity or zero or subnormal where that is out of range.
template <RoundedNumber Number>
Number times_power_of_two(const Number& x, std::int64_t e) {
  using std::ldexp;
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  return ldexp(x, static_cast<int>(std::clamp(e, -kMost, kMost)));
}

/// Are all coefficients so small that values of p may round as subnormal numbers do?
template <RoundedNumber Number>
bool is_tiny(const Polynomial<Number>& p) {
  using std::abs;
  using std::ldexp;
  const Number small = ldexp(Number(1), std::numeric_limits<Number>::min_exponent / 2);
  return std::all_of(p.c.begin(), p.c.begin() + p.degree + 1,
                     [&small](const Number& c) { return abs(c) < small; });
}

/// Returns p(2^exponent s) as a polynomial in s, times the power of two that brings its greatest
/// coefficient near 1. Others may underflow.
template <RoundedNumber Number>
Polynomial<Number> in_units_of_power_of_two(Polynomial<Number> p, std::int64_t exponent) {
  std::int64_t greatest = std::numeric_limits<std::int64_t>::min();
  for (int i = 0; i <= p.degree; ++i) {
    if (p.c[i] != 0) {
      greatest = std::max(greatest, exponent_of(p.c[i]) + exponent * i);
    }
  }
  for (int i = 0; i <= p.degree; ++i) {
    if (p.c[i] != 0) {
      p.c[i] = times_power_of_two(p.c[i], exponent * i - greatest);
    }
  }
  return p;
}

/// Returns the exponent of a power of two near the geometric mean of the roots' magnitudes, those
/// that are zero left out: in its units the coefficients are as close to each other as they can
/// be. Contract: the degree is at least 1.
template <RoundedNumber Number>
std::int64_t mean_root_exponent(const Polynomial<Number>& p) {
  int least = 0;
  while (p.c[least] == 0) {
    ++least;
  }
  return least == p.degree
             ? 0
             : (exponent_of(p.c[least]) - exponent_of(p.c[p.degree])) / (p.degree - least);
}

/// Returns e so that no root but zero is below 2^e in magnitude, and one is at most 4 n times as
/// great: from the bound of the roots of the reversed polynomial. Contract: p is not zero.
template <RoundedNumber Number>
std::int64_t least_root_exponent(const Polynomial<Number>& p) {
  Polynomial<Number> reversed;
  for (int i = p.degree; i >= 0; --i) {
    reversed.c[p.degree - i] = p.c[i];
    reversed.degree = p.c[i] == 0 ? reversed.degree : p.degree - i;
  }
  return reversed.degree == 0 ? 0 : 1 - exponent_of(root_bound(reversed));
}

}  // namespace lamina::poly
