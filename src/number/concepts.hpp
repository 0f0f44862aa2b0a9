// What a number type must promise; the types themselves are in all_numbers.hpp.
#pragma once

#include <concepts>
#include <string>

#include "number/rational.hpp"

namespace lamina::number {

/// The promises of one number type, specialised in traits.hpp:
///   Root                      a point of a ray: the number itself, or an algebraic real
///   name()                    as in tables and on the command line: `double`, `bin24`
///   kSignificandBits          0 for exact types
///   from_exact(Rational)      correctly rounded (nearest, ties to even)
///   to_exact(Number)          the same value as a rational
template <typename Number>
struct number_traits;

template <typename Number>
concept RealNumber = requires(const Rational& q) {
  typename number_traits<Number>::Root;
  { number_traits<Number>::name() } -> std::convertible_to<std::string>;
  { number_traits<Number>::kSignificandBits } -> std::convertible_to<int>;
  { number_traits<Number>::from_exact(q) } -> std::same_as<Number>;
};

/// A type that rounds: every operation returns the nearest of finitely many values.
template <typename Number>
concept RoundedNumber = RealNumber<Number> &&(number_traits<Number>::kSignificandBits > 0);

/// A type that does not round; its ray points are algebraic reals.
template <typename Number>
concept ExactNumber = RealNumber<Number> &&(number_traits<Number>::kSignificandBits == 0);

}  // namespace lamina::number
