#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "poly/laguerre.hpp"
#include "poly/quadratic.hpp"
#include "poly/scaling.hpp"

namespace lamina::poly {
namespace detail {

// std::complex is for the hardware types only.
template <RoundedNumber Number>
struct Complex {
  Number re;
  Number im;

  friend Complex operator+(const Complex& a, const Number& b) { return {a.re + b, a.im}; }
  friend Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend Complex operator*(const Complex& a, const Number& b) { return {a.re * b, a.im * b}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  // By the ratio of the divisor's parts, whose squares may underflow (Smith 1962).
  friend Complex operator/(const Complex& a, const Complex& b) {
    using std::abs;
    if (abs(b.re) < abs(b.im)) {
      return Complex{a.im, -a.re} / Complex{b.im, -b.re};
    }
    const Number ratio = b.im / b.re;
    const Number divisor = b.re + b.im * ratio;
    return {(a.re + a.im * ratio) / divisor, (a.im - a.re * ratio) / divisor};
  }
};

template <RoundedNumber Number>
Number magnitude(const Complex<Number>& z) {
  using std::abs;
  using std::sqrt;
  const Number large = std::max(Number(abs(z.re)), Number(abs(z.im)));
  const Number small = std::min(Number(abs(z.re)), Number(abs(z.im)));
  if (small == 0) {
    return large;
  }
  const Number ratio = small / large;
  return large * sqrt(Number(1 + ratio * ratio));
}

// The square root in the right half-plane.
template <RoundedNumber Number>
Complex<Number> square_root(const Complex<Number>& z) {
  using std::abs;
  using std::sqrt;
  if (z.re == 0 && z.im == 0) {
    return z;
  }
  const Number part = sqrt(Number((magnitude(z) + abs(z.re)) / 2));
  const Number other = z.im / (2 * part);
  if (z.re >= 0) {
    return {part, other};
  }
  return {abs(other), z.im < 0 ? Number(-part) : part};
}

template <RoundedNumber Number>
struct ComplexValue {
  Complex<Number> value;
  Complex<Number> slope;
  Complex<Number> half_curvature;
  Number error;  // of the value, at most

  [[nodiscard]] bool is_zero() const { return magnitude(value) <= error; }
};

// By Horner's rule, where each step errs by at most 2 sqrt(2) u of the product and u of the sum.
template <RoundedNumber Number>
ComplexValue<Number> complex_value(const Polynomial<Number>& p, const Complex<Number>& z) {
  using std::abs;
  const Number zero = 0;
  ComplexValue<Number> at{{p.c[p.degree], zero}, {zero, zero}, {zero, zero}, zero};
  const Number distance = magnitude(z);
  Number sum = abs(p.c[p.degree]);
  for (int i = p.degree - 1; i >= 0; --i) {
    at.half_curvature = at.half_curvature * z + at.slope;
    at.slope = at.slope * z + at.value;
    at.value = at.value * z + p.c[i];
    sum = sum * distance + abs(at.value.re) + abs(at.value.im);
  }
  at.error = 4 * number::unit_roundoff<Number>() * sum;
  return at;
}

// A root, mostly one of the least. Contract: the roots are at least 1 and one is at most 4 n in
// magnitude, n >= 2.
template <RoundedNumber Number>
Complex<Number> laguerre_root(const Polynomial<Number>& p) {
  // Cubic convergence takes a handful of steps; a multiple root gives a bit or so in each.
  constexpr int kMostSteps = 40 + 2 * number::number_traits<Number>::kSignificandBits;
  const auto n = static_cast<Number>(p.degree);
  Complex<Number> z{Number(0), Number(0)};
  for (int step = 1; step <= kMostSteps; ++step) {
    const ComplexValue<Number> at = complex_value(p, z);
    if (at.is_zero()) {
      break;
    }
    // n p / (p' + sqrt((n-1)^2 p'^2 - n (n-1) p p'')) with nothing squared.
    const Complex<Number> newton = at.value / at.slope;
    const Complex<Number> curved = newton * (at.half_curvature / at.slope);
    const Complex<Number> radicand = (curved * Number(-2 * n) + Number(n - 1)) * Number(n - 1);
    Complex<Number> move = newton * n / (square_root(radicand) + Number(1));
    const Number length = magnitude(move);
    if (!(length <= std::numeric_limits<Number>::max())) {
      move = {Number(-1), Number(0)};  // the slope is zero: try elsewhere
    } else if (length > n) {
      move = move * Number(n / length);  // keeps powers of z from overflow
    } else if (step % 10 == 0) {
      move = move * Number(0.375);  // leaves a cycle, if this is one
    }
    z = z - move;
  }
  return z;
}

template <RoundedNumber Number>
Polynomial<Number> without_root(const Polynomial<Number>& p, const Number& root) {
  Polynomial<Number> quotient;
  quotient.degree = p.degree - 1;
  quotient.c[p.degree - 1] = p.c[p.degree];
  for (int i = p.degree - 1; i > 0; --i) {
    quotient.c[i - 1] = p.c[i] + root * quotient.c[i];
  }
  return quotient;
}

// Divides by t^2 - 2 re t + |z|^2. Contract: the degree is at least 3.
template <RoundedNumber Number>
Polynomial<Number> without_pair(const Polynomial<Number>& p, const Complex<Number>& z) {
  const Number sum = 2 * z.re;
  const Number product = z.re * z.re + z.im * z.im;
  const int n = p.degree;
  Polynomial<Number> quotient;
  quotient.degree = n - 2;
  quotient.c[n - 2] = p.c[n];
  quotient.c[n - 3] = p.c[n - 1] + sum * p.c[n];
  for (int i = n - 2; i > 1; --i) {
    quotient.c[i - 2] = p.c[i] + sum * quotient.c[i - 1] - product * quotient.c[i];
  }
  return quotient;
}

// Newton's steps while each is at most half of the one before; stays between the bounds.
template <RoundedNumber Number>
Number polished(const Polynomial<Number>& p, Number t, const Number& low, const Number& high) {
  using std::abs;
  Number most = std::numeric_limits<Number>::infinity();
  for (int step = 0; step < number::number_traits<Number>::kSignificandBits; ++step) {
    const ValueAndSlope<Number> at = value_and_slope(p, t);
    const Number move = at.value / at.slope;
    const Number next = t - move;
    if (!(abs(move) <= most && low <= next && next <= high)) {
      break;
    }
    t = next;
    most = abs(move) / 2;
  }
  return t;
}

}  // namespace detail

template <RoundedNumber Number>
RealRoots<Number> laguerre_roots(const Polynomial<Number>& p) {
  RealRoots<Number> roots;
  const std::int64_t mean = mean_root_exponent(p);
  Polynomial<Number> rest = in_units_of_power_of_two(p, mean);
  while (rest.degree > 0) {
    if (rest.c[0] == 0) {
      roots.add(Number(0));
      rest = detail::without_root(rest, Number(0));
      continue;
    }
    // Each root is sought in units in which it is near 1, and divided out in those in which the
    // polynomial loses nothing.
    const std::int64_t least = least_root_exponent(rest);
    const Polynomial<Number> scaled = in_units_of_power_of_two(rest, least);
    if (rest.degree <= 2) {
      const RealRoots<Number> last = quadratic_roots(scaled, Solver::Kahan);
      for (int i = 0; i < last.count; ++i) {
        for (int times = 0; times < last.multiplicity[i]; ++times) {
          roots.add(times_power_of_two(last.t[i], least + mean));
        }
      }
      break;
    }
    const detail::Complex<Number> z = detail::laguerre_root(scaled);
    const detail::Complex<Number> root{times_power_of_two(z.re, least),
                                       times_power_of_two(z.im, least)};
    if (detail::complex_value(scaled, detail::Complex<Number>{z.re, Number(0)}).is_zero()) {
      roots.add(times_power_of_two(root.re, mean));
      rest = detail::without_root(rest, root.re);
    } else {
      rest = detail::without_pair(rest, root);
    }
  }
  return roots;
}

template <RoundedNumber Number>
RealRoots<Number> laguerre_polished_roots(const Polynomial<Number>& p) {
  const RealRoots<Number> rough = laguerre_roots(p);
  RealRoots<Number> roots;
  const Number infinity = std::numeric_limits<Number>::infinity();
  for (int i = 0; i < rough.count; ++i) {
    const Number& t = rough.t[i];
    const Number low =
        i > 0 ? Number(rough.t[i - 1] + (t - rough.t[i - 1]) / 2) : Number(-infinity);
    const Number high = i + 1 < rough.count ? Number(t + (rough.t[i + 1] - t) / 2) : infinity;
    roots.add(detail::polished(p, t, low, high));
  }
  return roots;
}

}  // namespace lamina::poly
