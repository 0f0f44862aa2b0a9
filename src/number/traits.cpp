#include "number/traits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace lamina::number::detail {
Scaled round_to_bits(const Rational& q, int bits) {
  mpfr_t rounded;
  mpfr_init2(rounded, bits);
  mpfr_set_q(rounded, q.backend().data(), MPFR_RNDN);
  Scaled result;
  if (mpfr_zero_p(rounded) == 0) {
    result.exponent = mpfr_get_z_2exp(result.mantissa.backend().data(), rounded);
  }
  mpfr_clear(rounded);
  return result;
}

Rational scale_by_power_of_two(const Integer& mantissa, long exponent) {
  Rational result(mantissa);
  if (exponent >= 0) {
    mpq_mul_2exp(result.backend().data(), result.backend().data(), exponent);
  } else {
    mpq_div_2exp(result.backend().data(), result.backend().data(), -exponent);
  }
  return result;
}

Rational exact_value(long double value) {
  int exponent = 0;
  const long double fraction = std::frexp(value, &exponent);
  constexpr int kDigits = std::numeric_limits<long double>::digits;
  static_assert(kDigits == 64, "x87 extended precision");
  const auto magnitude = static_cast<std::uint64_t>(std::ldexp(std::fabs(fraction), kDigits));
  Integer mantissa = magnitude;
  if (value < 0) {
    mantissa = -mantissa;
  }
  return scale_by_power_of_two(mantissa, exponent - kDigits);
}

std::string bin_name(int bits) { return fmt::format("bin{}", bits); }

std::string mpfr_name(int digits) { return fmt::format("mpfr{}", digits); }

}  // namespace lamina::number::detail
