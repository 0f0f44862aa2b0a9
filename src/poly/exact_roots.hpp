// The exact roots of a polynomial with rounded coefficients.
#pragma once

#include "number/algebraic.hpp"
#include "poly/real_roots.hpp"

namespace lamina::poly {

/// The polynomial as the number type holds it, with integer coefficients.
template <RoundedNumber Number>
number::IntegerPolynomial exact_polynomial(std::span<const Number> ascending) {
  std::vector<number::Rational> exact;
  exact.reserve(ascending.size());
  for (const Number& c : ascending) {
    exact.push_back(number::number_traits<Number>::to_exact(c));
  }
  return number::with_cleared_denominators(exact);
}

/// Returns the number nearest to the root.
template <RoundedNumber Number>
Number nearest(const number::Root& root) {
  using Traits = number::number_traits<Number>;
  constexpr int kBits = Traits::kSignificandBits;
  // Twice the bits tell the nearest number, unless the root is closer to the middle of two
  // than that, or is the middle: the root itself is as near to one as to the other then.
  for (int bits = 2 * kBits;; bits *= 2) {
    const number::Enclosure bounds = enclosure(root, bits);
    const Number low = Traits::from_exact(bounds.lower);
    if (low == Traits::from_exact(bounds.upper) || bits > 16 * kBits) {
      return low;
    }
  }
}

/// Returns the distinct real roots in the range, with their multiplicities, each rounded once
/// (see number/algebraic.hpp). Allocates.
template <RoundedNumber Number>
RealRoots<Number> exact_roots(const Polynomial<Number>& p, const Range<Number>& range) {
  using Traits = number::number_traits<Number>;
  RealRoots<Number> roots;
  const auto finite = [](const Number& x) { return x - x == 0; };
  for (const number::Root& root :
       number::real_roots(exact_polynomial(std::span<const Number>(p.c).first(p.degree + 1)))) {
    const bool below = finite(range.low) && compare(root, Traits::to_exact(range.low)) < 0;
    const bool above = finite(range.high) && compare(root, Traits::to_exact(range.high)) > 0;
    if (!below && !above) {
      roots.add(nearest<Number>(root), static_cast<int>(root.multiplicity()));
    }
  }
  return roots;
}

}  // namespace lamina::poly
