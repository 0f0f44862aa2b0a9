// Intervals for counted events, and tests between them.
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

/// The p-value of McNemar's test, exact and two-sided: of the trials on which two methods
/// differ, `only_first` went against the first and `only_second` against the second; the
/// probability of a split at least as uneven if both were equally good. 1 where none differ.
/// Source: McNemar, Psychometrika 12 (1947); Boost.Math's binomial distribution.
double mcnemar(std::uint64_t only_first, std::uint64_t only_second);

}  // namespace lamina::census
