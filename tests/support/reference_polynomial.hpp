// Polynomials of the oracles, as coefficients of 1, s, s^2 ..: they share no code with the
// project's.
#pragma once

#include <algorithm>
#include <vector>

#include "number/rational.hpp"

namespace lamina::reference {

using Polynomial = std::vector<number::Rational>;

inline Polynomial scaled(const number::Rational& factor, Polynomial a) {
  for (number::Rational& c : a) {
    c *= factor;
  }
  return a;
}

inline Polynomial sum(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] += b[i];
  }
  return a;
}

inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      result[i + j] += a[i] * b[j];
    }
  }
  return result;
}

// The same roots; without leading zeros.
inline std::vector<number::Integer> whole(Polynomial polynomial) {
  while (!polynomial.empty() && polynomial.back() == 0) {
    polynomial.pop_back();
  }
  number::Integer common = 1;
  for (const number::Rational& c : polynomial) {
    common = lcm(common, denominator(c));
  }
  std::vector<number::Integer> result;
  for (const number::Rational& c : polynomial) {
    result.push_back(numerator(number::Rational(c * common)));
  }
  return result;
}

}  // namespace lamina::reference
