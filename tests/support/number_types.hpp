// The list of number types as GoogleTest takes it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "number/all_numbers.hpp"

namespace lamina::support {

template <typename Tuple>
struct TypesOf;
template <typename... Numbers>
struct TypesOf<std::tuple<Numbers...>> {
  using type = ::testing::Types<Numbers...>;
};

using RoundedNumberTypes = typename TypesOf<number::RoundedNumbers>::type;

struct NumberNames {
  template <typename Number>
  static std::string GetName(int) {
    return number::number_traits<Number>::name();
  }
};

}  // namespace lamina::support
