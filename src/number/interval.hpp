// Intervals of many bits: certified enclosures of numbers that are not written down.
#pragma once

#include <mpfi.h>

#include <optional>

#include "number/algebraic.hpp"

namespace lamina::number {

/// A closed interval that contains the number it stands for, its ends rounded outwards to a
/// number of bits (MPFI). Operations round to the larger number of bits of the two.
class Interval {
 public:
  /// Zero.
  Interval();
  /// The narrowest interval of that many bits around the value; exact if they hold it.
  Interval(const Rational& value, int bits);
  Interval(const Enclosure& bounds, int bits);
  Interval(const Interval& other);
  Interval(Interval&& other) noexcept;
  Interval& operator=(Interval other) noexcept;
  ~Interval();

  [[nodiscard]] int bits() const;
  [[nodiscard]] Rational lower() const;
  [[nodiscard]] Rational upper() const;
  /// The sign that all numbers of the interval have: -1, 0 (only for the number zero) or 1;
  /// none if they have not all the same.
  [[nodiscard]] std::optional<int> sign() const;

  Interval& operator+=(const Interval& other);
  friend Interval operator+(const Interval& a, const Interval& b);
  friend Interval operator-(const Interval& a, const Interval& b);
  friend Interval operator*(const Interval& a, const Interval& b);
  friend Interval operator*(const Integer& a, const Interval& b);
  friend Interval operator/(const Interval& a, const Integer& divisor);
  /// Contract: the divisor's sign is known, and not zero.
  friend Interval operator/(const Interval& a, const Interval& divisor);
  /// The narrowest interval that contains both.
  friend Interval hull(const Interval& a, const Interval& b);

 private:
  explicit Interval(mpfr_prec_t bits);

  mpfi_t value_;
};

}  // namespace lamina::number
