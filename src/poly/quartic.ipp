#pragma once

#include <cmath>
#include <span>

#include "poly/quadratic.hpp"
#include "poly/quartic.hpp"

namespace lamina::poly {
namespace detail {

template <RoundedNumber Number>
Number horner(std::span<const Number> c, const Number& t) {
  Number value = 0;
  for (std::size_t i = c.size(); i-- > 0;) {
    value = value * t + c[i];
  }
  return value;
}

// The root of a monotone piece between low and high, where the polynomial has different
// signs (positive at high if `rising`): Newton's steps, or halving where a step leaves the
// bracket or does not halve the one before.
template <RoundedNumber Number>
Number bracketed_root(std::span<const Number> c, std::span<const Number> slope, Number low,
                      Number high, bool rising) {
  using std::abs;
  Number t = low + (high - low) / 2;
  Number last_step = high - low;
  while (low < t && t < high) {
    const Number value = horner(c, t);
    if (value == 0) {
      return t;
    }
    ((value > 0) == rising ? high : low) = t;
    const Number step = value / horner(slope, t);
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

// Beyond the outermost critical point: steps that double until the sign at infinity shows.
template <RoundedNumber Number>
Number far_bound(std::span<const Number> c, const Number& start, int direction, bool positive) {
  using std::abs;
  Number step = abs(start) > 1 ? Number(abs(start)) : Number(1);
  Number t = start;
  while (true) {
    const Number next = direction > 0 ? Number(start + step) : Number(start - step);
    if (next == t || !(abs(next) - abs(next) == 0)) {
      return t;  // the end of the number range
    }
    t = next;
    const Number value = horner(c, t);
    if (positive ? value > 0 : value < 0) {
      return t;
    }
    step = step * 2;
  }
}

// Crossings of a polynomial of degree at most 4, given as c[0] .. c[degree], c[degree] != 0.
template <RoundedNumber Number>
LineRoots<Number> monotone_crossings(std::span<const Number> c) {
  const std::size_t degree = c.size() - 1;
  if (degree <= 2) {
    return quadratic_crossings(degree == 2 ? c[2] : Number(0),
                               degree >= 1 ? Number(c[1] / 2) : Number(0), c[0],
                               QuadraticSolver::Careful);
  }
  std::array<Number, 4> slope_storage;
  for (std::size_t i = 1; i <= degree; ++i) {
    slope_storage[i - 1] = static_cast<Number>(static_cast<int>(i)) * c[i];
  }
  const std::span<const Number> slope(slope_storage.data(), degree);
  const LineRoots<Number> critical = monotone_crossings(slope);

  LineRoots<Number> roots;
  const bool right_positive = c[degree] > 0;
  const bool left_positive = right_positive == (degree % 2 == 0);
  const Number first = critical.count > 0 ? critical.t[0] : Number(0);
  const Number last = critical.count > 0 ? critical.t[critical.count - 1] : Number(0);
  Number low = far_bound(c, first, -1, left_positive);
  bool low_positive = left_positive;
  for (int i = 0; i <= critical.count; ++i) {
    const bool at_end = i == critical.count;
    const Number high = at_end ? far_bound(c, last, 1, right_positive) : critical.t[i];
    const Number value = at_end ? Number(right_positive ? 1 : -1) : horner(c, high);
    // A critical point exactly on the axis touches it, or is an inflection: in both cases the
    // sign beyond it decides.
    if (value == 0) {
      continue;
    }
    const bool high_positive = value > 0;
    if (high_positive != low_positive) {
      roots.cross(bracketed_root(c, slope, low, high, high_positive));
    }
    low = high;
    low_positive = high_positive;
  }
  return roots;
}

// The largest real root of z^3 + a z^2 + b z + c.
template <RoundedNumber Number>
Number largest_cubic_root(const Number& a, const Number& b, const Number& c) {
  using std::abs;
  using std::acos;
  using std::cos;
  using std::pow;
  using std::sqrt;
  const Number q = (a * a - 3 * b) / 9;
  const Number r = (2 * a * a * a - 9 * a * b + 27 * c) / 54;
  const Number q3 = q * q * q;
  if (r * r < q3) {
    const Number third_of_turn = 2 * acos(Number(-1)) / 3;
    const Number angle = acos(Number(r / sqrt(q3))) / 3 + third_of_turn;
    return -2 * sqrt(q) * cos(angle) - a / 3;
  }
  const Number magnitude = pow(Number(abs(r) + sqrt(Number(r * r - q3))), Number(Number(1) / 3));
  const Number s = r > 0 ? Number(-magnitude) : magnitude;
  return s + (s == 0 ? Number(0) : Number(q / s)) - a / 3;
}

template <RoundedNumber Number>
LineRoots<Number> ferrari_crossings(const std::array<Number, 5>& c) {
  using std::sqrt;
  // Monic and depressed: t = u - shift, u^4 + p u^2 + q u + r.
  const Number a3 = c[3] / c[4];
  const Number a2 = c[2] / c[4];
  const Number a1 = c[1] / c[4];
  const Number a0 = c[0] / c[4];
  const Number shift = a3 / 4;
  const Number s2 = shift * shift;
  const Number p = a2 - 6 * s2;
  const Number q = a1 - 2 * a2 * shift + 8 * s2 * shift;
  const Number r = a0 - a1 * shift + a2 * s2 - 3 * s2 * s2;

  LineRoots<Number> roots;
  const auto add = [&](const Number& half_linear, const Number& constant) {
    const LineRoots<Number> pair =
        quadratic_crossings(Number(1), half_linear, constant, QuadraticSolver::Careful);
    for (int i = 0; i < pair.count; ++i) {
      roots.cross(Number(pair.t[i] - shift));
    }
  };
  if (q == 0) {  // u^4 + p u^2 + r: a quadratic in u^2
    const LineRoots<Number> squares =
        quadratic_crossings(Number(1), Number(p / 2), r, QuadraticSolver::Careful);
    for (int i = 0; i < squares.count; ++i) {
      if (squares.t[i] > 0) {
        add(Number(0), Number(-squares.t[i]));
      }
    }
    return roots;
  }
  const Number y = largest_cubic_root(Number(2 * p), Number(p * p - 4 * r), Number(-q * q));
  if (!(y > 0)) {
    return roots;
  }
  const Number s = sqrt(y);  // (u^2 + s u + m)(u^2 - s u + n), m + n - y = p, s (n - m) = q
  add(Number(s / 2), Number((p + y - q / s) / 2));
  add(Number(-s / 2), Number((p + y + q / s) / 2));
  return roots;
}

}  // namespace detail

template <RoundedNumber Number>
LineRoots<Number> quartic_crossings(const std::array<Number, 5>& c, QuarticSolver solver) {
  std::size_t degree = 4;
  while (degree > 0 && c[degree] == 0) {
    --degree;
  }
  if (degree == 4 && solver == QuarticSolver::Ferrari) {
    return detail::ferrari_crossings(c);
  }
  return detail::monotone_crossings(std::span<const Number>(c.data(), degree + 1));
}

}  // namespace lamina::poly
