// The number types: hardware floats, software floats of any precision, and the exact one.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <string>
#include <type_traits>

#include "number/algebraic.hpp"
#include "number/bin_float_mended.hpp"
#include "number/concepts.hpp"
#include "number/rational.hpp"

namespace lamina::number {

/// A binary float with P significand bits, correctly rounded, and an exponent range far
/// beyond double's: `bin<53>` is `double` wherever double neither over- nor underflows.
template <unsigned P>
using bin = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<P, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// MPFR with D decimal digits as Boost counts them (significand_bits<mpfr<50>> is 168),
/// on the stack, expression templates off since Boost fuses a*b + c with them.
template <unsigned D>
using mpfr = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<D, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// The exact number type: rational coefficients, real algebraic roots.
using exact = Rational;

namespace detail {
/// mantissa * 2^exponent with at most `bits` bits, the value nearest to q.
struct Scaled {
  Integer mantissa;
  long exponent = 0;
};
Scaled round_to_bits(const Rational& q, int bits);

/// q * 2^exponent.
Rational scale_by_power_of_two(const Integer& mantissa, long exponent);

Rational exact_value(long double value);

std::string bin_name(int bits);
std::string mpfr_name(int digits);
}  // namespace detail

template <>
struct number_traits<float> {
  using Root = float;
  static std::string name() { return "float"; }
  static constexpr int kSignificandBits = 24;
  static float from_exact(const Rational& q) { return nearest_float(q); }
  static Rational to_exact(float value) { return Rational(value); }
};

template <>
struct number_traits<double> {
  using Root = double;
  static std::string name() { return "double"; }
  static constexpr int kSignificandBits = 53;
  static double from_exact(const Rational& q) { return nearest_double(q); }
  static Rational to_exact(double value) { return Rational(value); }
};

template <>
struct number_traits<long double> {
  using Root = long double;
  static std::string name() { return "longdouble"; }
  static constexpr int kSignificandBits = 64;
  static long double from_exact(const Rational& q) { return nearest_long_double(q); }
  static Rational to_exact(long double value) { return detail::exact_value(value); }
};

template <unsigned P>
struct number_traits<bin<P>> {
  using Root = bin<P>;
  static std::string name() { return detail::bin_name(P); }
  static constexpr int kSignificandBits = P;
  static bin<P> from_exact(const Rational& q) {
    const detail::Scaled scaled = detail::round_to_bits(q, P);
    return ldexp(bin<P>(scaled.mantissa), static_cast<int>(scaled.exponent));
  }
  static Rational to_exact(const bin<P>& value) {
    int exponent = 0;
    const bin<P> fraction = frexp(value, &exponent);
    const Integer mantissa = static_cast<Integer>(ldexp(fraction, static_cast<int>(P)));
    return detail::scale_by_power_of_two(mantissa, exponent - static_cast<long>(P));
  }
};

template <unsigned D>
struct number_traits<mpfr<D>> {
  using Root = mpfr<D>;
  static std::string name() { return detail::mpfr_name(D); }
  /// What Boost gives for D decimal digits (its digits10_2_2, which is not constexpr).
  static constexpr int kSignificandBits = D * 1000 / 301 + (D * 1000 % 301 != 0 ? 2 : 1);
  static mpfr<D> from_exact(const Rational& q) {
    mpfr<D> result;
    mpfr_set_q(result.backend().data(), q.backend().data(), MPFR_RNDN);
    return result;
  }
  static Rational to_exact(const mpfr<D>& value) {
    Rational result;
    mpfr_get_q(result.backend().data(), value.backend().data());
    return result;
  }
};

template <>
struct number_traits<exact> {
  using Root = number::Root;
  static std::string name() { return "exact"; }
  static constexpr int kSignificandBits = 0;
  static exact from_exact(const Rational& q) { return q; }
  static Rational to_exact(const exact& value) { return value; }
};

/// The double nearest to the value; infinities and NaN stay what they are.
template <RoundedNumber Number>
double to_double(const Number& value) {
  if constexpr (std::is_same_v<Number, float> || std::is_same_v<Number, double>) {
    return value;
  } else {
    return value - value == 0 ? nearest_double(number_traits<Number>::to_exact(value))
                              : static_cast<double>(value);
  }
}

/// Half the distance from 1 to the next number: 2^-significand bits.
template <RoundedNumber Number>
Number unit_roundoff() {
  using std::ldexp;
  return ldexp(Number(1), -number_traits<Number>::kSignificandBits);
}

}  // namespace lamina::number
