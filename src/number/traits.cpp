#include "number/traits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace lamina::number::detail {
namespace {

// The nearest value of a hardware type, or the zero or infinity it rounds to.
template <typename Float>
Float nearest_hardware(const Rational& q) {
  using Limits = std::numeric_limits<Float>;
  if (q.is_zero()) {
    return 0;
  }
  Scaled scaled = round_to_bits(q, Limits::digits);
  // The exponent of a number is one more than that of its leading bit.
  const long exponent = scaled.exponent + static_cast<long>(msb(Integer(abs(scaled.mantissa)))) + 1;
  if (exponent > Limits::max_exponent) {
    return static_cast<Float>(q.sign()) * Limits::infinity();
  }
  if (exponent < Limits::min_exponent) {  // subnormal: a multiple of the smallest number
    const long smallest = Limits::min_exponent - Limits::digits;
    const Rational multiple =
        scale_by_power_of_two(Integer(numerator(q)), -smallest) / Rational(Integer(denominator(q)));
    const Integer twice = 2 * numerator(multiple) + denominator(multiple) * multiple.sign();
    const Integer divisor = 2 * denominator(multiple);
    Integer rounded = twice / divisor;  // half away from zero, mended below
    if (twice % divisor == 0 && rounded % 2 != 0) {
      rounded -= multiple.sign();
    }
    scaled = {rounded, smallest};
  }
  Float value = 0;
  if constexpr (std::is_same_v<Float, long double>) {
    const auto magnitude = static_cast<std::uint64_t>(Integer(abs(scaled.mantissa)));
    value = static_cast<long double>(magnitude) * (scaled.mantissa.sign() < 0 ? -1 : 1);
  } else {
    value = static_cast<Float>(static_cast<std::int64_t>(scaled.mantissa));
  }
  return std::ldexp(value, static_cast<int>(scaled.exponent));
}

}  // namespace

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

float nearest_float(const Rational& q) { return nearest_hardware<float>(q); }

long double nearest_long_double(const Rational& q) { return nearest_hardware<long double>(q); }

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
