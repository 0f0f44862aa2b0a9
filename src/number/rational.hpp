// Exact integers and rationals: the numbers that scenes and rays are read in.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <string_view>

namespace lamina::number {

/// Exact integers (GMP). Expression templates are off: `auto` is a value.
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Exact rationals (GMP), always in lowest terms with a positive denominator.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// Returns the rational that the text spells: `-12`, `0.1`, `6.02e23`, `978/997`,
/// `1.5/2`. Exact. Throws base::InputError if it spells none, if a denominator is
/// zero, or if an exponent exceeds 10^4 in magnitude.
Rational parse_rational(std::string_view text);

/// Returns the shortest text that parse_rational reads back to the same value: an
/// integer or a decimal where the denominator divides a power of ten not above
/// 10^30, else `a/b`.
std::string to_text(const Rational& value);

/// Return the float, double or long double nearest to the value, ties to even, subnormal
/// numbers included; infinity beyond the range.
float nearest_float(const Rational& value);
double nearest_double(const Rational& value);
long double nearest_long_double(const Rational& value);

/// -1, 0 or 1.
inline int sign(const Integer& value) { return value.sign(); }
inline int sign(const Rational& value) { return value.sign(); }

}  // namespace lamina::number
