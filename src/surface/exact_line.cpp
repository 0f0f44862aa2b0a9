#include "surface/exact_line.hpp"

#include <cmath>

namespace lamina::surface {

using number::Enclosure;
using number::Rational;
using number::Root;

RationalPolynomial derivative(const RationalPolynomial& p) {
  RationalPolynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) {
    slope.push_back(static_cast<long>(i) * p[i]);
  }
  return slope;
}

int sign_after_zero(const RationalPolynomial& p) {
  return std::find_if(p.begin(), p.end(), [](const Rational& c) { return !c.is_zero(); })->sign();
}

Enclosure bounds_of(const Root& root) {
  return std::isfinite(root.lower()) && std::isfinite(root.upper())
             ? Enclosure{Rational(root.lower()), Rational(root.upper())}
             : enclosure(root, 1);
}

Rational between(const Root& a, const Root& b) {
  if (a.upper() < b.lower()) {
    return (Rational(a.upper()) + Rational(b.lower())) / 2;
  }
  for (int bits = 64;; bits *= 2) {
    const Rational low = enclosure(a, bits).upper;
    const Rational high = enclosure(b, bits).lower;
    if (low < high) {
      return (low + high) / 2;
    }
  }
}

}  // namespace lamina::surface
