// Newton's and Halley's method between bounds.
#pragma once

#include <array>
#include <span>

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

/// A root that is being searched for, between two numbers.
template <RoundedNumber Number>
struct Bracket {
  Number low;  ///< the polynomial changes its sign once from here to high
  Number high;
  Number t;     ///< the best so far
  bool rising;  ///< to positive at high
};

/// Moves each t from its start between the bounds to the root: Halley's steps, or halving where a
/// step leaves the bounds or does not halve the one before. It ends where a step changes nothing,
/// or the next one would be below a quarter of a unit, steps going down as they do. All roots go
/// on at the same time, as each alone waits for its own arithmetic most of the time.
///
/// Contract: the degree of p, an int or an integral_constant; no more brackets than that.
template <typename Degree, RoundedNumber Number>
void halley_roots(const Polynomial<Number>& p, Degree degree, std::span<Bracket<Number>> brackets) {
  using std::abs;
  const Number quarter_unit = number::unit_roundoff<Number>() / 2;  // of a number, at most
  std::array<Number, kMostOf<Degree>> limits;
  std::array<Number, kMostOf<Degree>> last_steps;  // of Halley's, directly before
  std::array<int, kMostOf<Degree>> active;
  int left = 0;
  for (std::size_t i = 0; i < brackets.size(); ++i) {
    limits[i] = brackets[i].high - brackets[i].low;
    last_steps[i] = 0;
    active[left++] = static_cast<int>(i);
  }
  while (left > 0) {
    int still = 0;
    for (int k = 0; k < left; ++k) {
      const int i = active[k];
      Bracket<Number>& bracket = brackets[i];
      const Number t = bracket.t;
      const TaylorAt<Number> at = taylor_at(p, degree, t);
      if (at.value == 0) {
        continue;
      }
      const bool below = (at.value > 0) != bracket.rising;
      bracket.low = below ? t : bracket.low;
      bracket.high = below ? bracket.high : t;
      const Number newton = at.value / at.slope;
      const Number bend = newton * (at.half_bend / at.slope);
      // Of no use where the parabola is far from the line.
      const Number step =
          bend < Number(0.5) && bend > Number(-0.5) ? Number(newton / (1 - bend)) : newton;
      const Number size = abs(step);
      Number next = t - step;
      if (next == t) {
        continue;
      }
      bool done = false;
      if (!(bracket.low < next && next < bracket.high) || !(size <= limits[i] / 2)) {
        next = bracket.low + (bracket.high - bracket.low) / 2;
        limits[i] = bracket.high - bracket.low;
        last_steps[i] = 0;
        done = !(bracket.low < next && next < bracket.high);
      } else {
        // Each step is about a constant times the cube of the one before.
        const Number shrunk = size / last_steps[i];  // infinite the first time
        done = size * shrunk * shrunk * shrunk <= quarter_unit * abs(next);
        limits[i] = last_steps[i] = size;
      }
      bracket.t = next;
      if (!done) {
        active[still++] = i;
      }
    }
    left = still;
  }
}

}  // namespace lamina::poly
