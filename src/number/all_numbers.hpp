// The list of number types, written once: instantiation, tests, the program and the
// experiments are driven by it. To add a type, give it traits and a line here.
#pragma once

#include <tuple>

#include "number/traits.hpp"

#define LAMINA_FOR_EACH_HARDWARE_NUMBER(X) \
  X(float)                                 \
  X(double)                                \
  X(long double)

#define LAMINA_FOR_EACH_NARROW_BIN_NUMBER(X) \
  X(::lamina::number::bin<11>)               \
  X(::lamina::number::bin<24>)               \
  X(::lamina::number::bin<53>)

#define LAMINA_FOR_EACH_WIDE_BIN_NUMBER(X) \
  X(::lamina::number::bin<64>)             \
  X(::lamina::number::bin<113>)            \
  X(::lamina::number::bin<237>)

#define LAMINA_FOR_EACH_MPFR_NUMBER(X) \
  X(::lamina::number::mpfr<16>)        \
  X(::lamina::number::mpfr<50>)

#define LAMINA_FOR_EACH_ROUNDED_NUMBER(X) \
  LAMINA_FOR_EACH_HARDWARE_NUMBER(X)      \
  LAMINA_FOR_EACH_NARROW_BIN_NUMBER(X)    \
  LAMINA_FOR_EACH_WIDE_BIN_NUMBER(X)      \
  LAMINA_FOR_EACH_MPFR_NUMBER(X)

#define LAMINA_FOR_EACH_NUMBER(X)   \
  LAMINA_FOR_EACH_ROUNDED_NUMBER(X) \
  X(::lamina::number::exact)

namespace lamina::number {

namespace detail {
struct Nothing {};
template <typename First, typename... Rest>
std::tuple<Rest...> without_first(std::tuple<First, Rest...>);
}  // namespace detail

#define LAMINA_COMMA_NUMBER(Number) , Number
using RoundedNumbers = decltype(detail::without_first(
    std::tuple<detail::Nothing LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_COMMA_NUMBER)>{}));
using AllNumbers = decltype(detail::without_first(
    std::tuple<detail::Nothing LAMINA_FOR_EACH_NUMBER(LAMINA_COMMA_NUMBER)>{}));
#undef LAMINA_COMMA_NUMBER

}  // namespace lamina::number
