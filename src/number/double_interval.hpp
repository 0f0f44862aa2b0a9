// Intervals of doubles: certified enclosures, fast. What includes this is compiled with
// -frounding-math, since the operations round upwards.
#pragma once

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "number/rational.hpp"

namespace lamina::number {

/// A closed interval; + - * / by CGAL, each of which contains all that its operands can make.
/// Contract: a RoundingUpwards lives in this thread.
using DoubleInterval = CGAL::Interval_nt<false>;

/// While one lives, this thread rounds upwards.
using RoundingUpwards = CGAL::Protect_FPU_rounding<true>;

/// The double that the number is, or its neighbours to either side.
inline DoubleInterval enclosing(const Rational& x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double near = nearest_double(x);
  if (std::isfinite(near) && Rational(near) == x) {
    return near;
  }
  return {std::nextafter(near, -kInfinity), std::nextafter(near, kInfinity)};
}

/// A number of the interval near its middle, rounded as the thread rounds.
inline double middle_of(const DoubleInterval& x) {
  return std::clamp(x.inf() + (x.sup() - x.inf()) / 2, x.inf(), x.sup());
}

/// The sign that all numbers of the interval have, 0 only for the number zero; none if they have
/// not all the same, or if an end overflowed to NaN.
inline std::optional<int> sign(const DoubleInterval& x) {
  if (x.inf() > 0) {
    return 1;
  }
  if (x.sup() < 0) {
    return -1;
  }
  return x.inf() == 0 && x.sup() == 0 ? std::optional(0) : std::nullopt;
}

}  // namespace lamina::number
