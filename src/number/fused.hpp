// Fused multiply-add: a*b + c with one rounding, on every rounded number type.
#pragma once

#include <cmath>

#include "number/traits.hpp"

namespace lamina::number {

/// Returns a*b + c rounded once, to nearest. Boost's generic `fma` rounds twice on
/// cpp_bin_float, so software floats get their own: the product and the sum are exact in
/// pairs of numbers of twice the bits (the second by Knuth's two-sum), and the rest of the
/// sum decides where the first rounds from a tie.
template <RoundedNumber Number>
Number fused_multiply_add(const Number& a, const Number& b, const Number& c) {
  if constexpr (std::is_floating_point_v<Number>) {
    return std::fma(a, b, c);
  } else if constexpr (requires(Number n) {
                         mpfr_fma(n.backend().data(), n.backend().data(), n.backend().data(),
                                  n.backend().data(), MPFR_RNDN);
                       }) {
    Number result;
    mpfr_fma(result.backend().data(), a.backend().data(), b.backend().data(), c.backend().data(),
             MPFR_RNDN);
    return result;
  } else {
    using Wide = bin<2 * number_traits<Number>::kSignificandBits>;
    const Wide product = Wide(a) * Wide(b);
    const Wide addend(c);
    const Wide sum = product + addend;
    const Wide part = sum - product;
    const Wide rest = (product - (sum - part)) + (addend - part);
    const Number nearest(sum);
    if (rest == 0) {
      return nearest;
    }
    const Wide other = sum + (sum - Wide(nearest));  // nearest's mirror image in the sum
    const Number mirrored(other);
    if (sum == nearest || Wide(mirrored) != other) {
      return nearest;  // not a tie
    }
    return (rest > 0) == (mirrored > nearest) ? mirrored : nearest;
  }
}

/// Returns a*b - c*d.
///
/// Error:  at most 3/2 ulp if nothing over- or underflows (Jeannerod, Louvet and Muller,
///         Math. Comp. 82, 2013); plain evaluation has no relative bound at all.
/// Source: Kahan's scheme.
template <RoundedNumber Number>
Number difference_of_products(const Number& a, const Number& b, const Number& c, const Number& d) {
  const Number cd = c * d;
  const Number error = fused_multiply_add(Number(-c), d, cd);  // cd - c*d, exact
  const Number head = fused_multiply_add(a, b, Number(-cd));
  return head + error;
}

}  // namespace lamina::number
