// Newton's and Halley's method between bounds.
#pragma once

#include "poly/polynomial.hpp"

namespace lamina::poly {

/// Returns the root of a piece between low and high on which the polynomial changes its sign
/// once (to positive at high if `rising`): Newton's steps from the middle, or halving where a step
/// leaves the bounds or does not halve the one before. It ends where a step changes nothing: what
/// is left is the error of the value as computed, divided by the slope.
template <RoundedNumber Number>
Number newton_root(const Polynomial<Number>& p, const Polynomial<Number>& slope, Number low,
                   Number high, bool rising) {
  using std::abs;
  Number t = low + (high - low) / 2;
  Number last_step = high - low;
  while (low < t && t < high) {
    const Number at = value(p, t);
    if (at == 0) {
      return t;
    }
    ((at > 0) == rising ? high : low) = t;
    const Number step = at / value(slope, t);
    Number next = t - step;
    if (!(low < next && next < high) || abs(step) > last_step / 2) {
      next = low + (high - low) / 2;
      last_step = high - low;
    } else {
      last_step = abs(step);
    }
    if (next == t) {
      return t;
    }
    t = next;
  }
  return t;
}

/// The same by Halley's steps from a start between the bounds. It ends, too, where the next step
/// would be below a quarter of a unit, steps going down as they do.
template <RoundedNumber Number>
Number halley_root(const Polynomial<Number>& p, Number low, Number high, bool rising, Number t) {
  using std::abs;
  const Number quarter_unit = number::unit_roundoff<Number>() / 2;  // of a number, at most
  Number limit = high - low;
  Number last_step = 0;  // of Halley's, directly before
  while (low < t && t < high) {
    const TaylorAt<Number> at = taylor_at(p, t);
    if (at.value == 0) {
      return t;
    }
    ((at.value > 0) == rising ? high : low) = t;
    const Number newton = at.value / at.slope;
    const Number bend = newton * (at.half_bend / at.slope);
    // Of no use where the parabola is far from the line.
    const Number step =
        bend < Number(0.5) && bend > Number(-0.5) ? Number(newton / (1 - bend)) : newton;
    const Number size = abs(step);
    Number next = t - step;
    if (next == t) {
      return t;
    }
    if (!(low < next && next < high) || !(size <= limit / 2)) {
      next = low + (high - low) / 2;
      limit = high - low;
      last_step = 0;
    } else {
      // Each step is about a constant times the cube of the one before.
      if (last_step != 0) {
        const Number shrunk = size / last_step;
        if (size * shrunk * shrunk * shrunk <= quarter_unit * abs(next)) {
          return next;
        }
      }
      limit = last_step = size;
    }
    t = next;
  }
  return t;
}

}  // namespace lamina::poly
