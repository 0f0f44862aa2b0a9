// Mends the subtraction of Boost.Multiprecision 1.74's cpp_bin_float, which is not correctly
// rounded in one case.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace boost::multiprecision::backends {

/// Where the exponents of a and b differ by one more than the number of bits, the smaller
/// operand is at least a quarter and below half a unit in the last place of the larger. The
/// difference of magnitudes then rounds to the larger operand, unless that is a power of two.
/// Boost rounds a tie instead and is one unit off for odd significands. Being more specialised
/// than Boost's function of this name, this one is what the operators + and - call.
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

}  // namespace boost::multiprecision::backends
