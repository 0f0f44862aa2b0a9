// Mends Boost.Multiprecision 1.74's cpp_bin_float where it is wrong: a subtraction that is not
// correctly rounded, and a quotient that overflows its buffer. Being more specialised than
// Boost's functions of these names, the ones here are what the operators call.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace boost::multiprecision::backends {

/// Where the exponents of a and b differ by one more than the number of bits, the smaller
/// operand is at least a quarter and below half a unit in the last place of the larger. The
/// difference of magnitudes then rounds to the larger operand, unless that is a power of two.
/// Boost rounds a tie instead and is one unit off for odd significands.
template <unsigned Digits>
void do_eval_subtract(cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>& result,
                      const cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>& a,
                      const cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>& b) {
  using Float = cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>;
  constexpr int kGap = static_cast<int>(Float::bit_count) + 1;
  const auto is_finite = [](const Float& x) { return x.exponent() <= Float::max_exponent; };
  const auto is_power_of_two = [](const Float& x) {
    return eval_lsb(x.bits()) == Float::bit_count - 1;
  };
  if (is_finite(a) && is_finite(b)) {
    if (a.exponent() - b.exponent() == kGap && !is_power_of_two(a)) {
      result = a;
      return;
    }
    if (b.exponent() - a.exponent() == kGap && !is_power_of_two(b)) {
      const bool sign = !a.sign();
      result = b;
      result.sign() = sign;
      return;
    }
  }
  do_eval_subtract<Digits, digit_base_2, void, int, 0, 0>(result, a, b);
}

/// Boost divides by an integer in a buffer of twice the significand's bits, which a divisor of
/// as many bits overflows: 1 / 3628800 is wrong for 11 bits, and so are the functions that
/// divide by factorials. Such divisors are rounded to the type, and it divides by that; rounded
/// here, since Boost's own conversion truncates.
template <unsigned Digits, class Unsigned>
typename enable_if_c<is_unsigned<Unsigned>::value>::type eval_divide(
    cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>& result,
    const cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>& a, const Unsigned& b) {
  using Float = cpp_bin_float<Digits, digit_base_2, void, int, 0, 0>;
  constexpr int kBits = static_cast<int>(Float::bit_count) - 1;
  if constexpr (kBits < std::numeric_limits<Unsigned>::digits) {
    if ((b >> kBits) != 0) {
      const int extra = static_cast<int>(std::bit_width(b)) - static_cast<int>(Float::bit_count);
      Unsigned nearest = b >> extra;
      if (extra > 0) {
        const Unsigned rest = b - (nearest << extra);
        const Unsigned half = Unsigned(1) << (extra - 1);
        nearest += rest > half || (rest == half && nearest % 2 != 0) ? 1 : 0;
      }
      Float divisor;
      divisor = nearest;
      eval_ldexp(divisor, divisor, extra);
      eval_divide(result, a, divisor);
      return;
    }
  }
  eval_divide<Digits, digit_base_2, void, int, 0, 0, Unsigned>(result, a, b);
}

}  // namespace boost::multiprecision::backends
