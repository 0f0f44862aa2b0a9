// Intervals for counted events.
#pragma once

#include <cstdint>

namespace lamina::census {

/// Bounds of a probability.
struct Interval {
  double lower = 0;
  double upper = 1;
};

/// The Clopper-Pearson interval of 95 %: for `count` events in `n` independent trials it
/// covers the probability of an event at least 95 times in 100, whatever it is. For n = 0 it
/// is 0 .. 1. Source: Clopper and Pearson, Biometrika 26 (1934); Boost.Math.
Interval clopper_pearson(std::uint64_t count, std::uint64_t n);

}  // namespace lamina::census
