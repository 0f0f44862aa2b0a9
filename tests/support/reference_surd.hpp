// A second oracle, part two: numbers p + q sqrt(d), compared by rational arithmetic alone.
#pragma once

#include "number/rational.hpp"

namespace lamina::reference {

class Surd {
 public:
  using Rational = number::Rational;

  /// p + q sqrt(d) with d >= 0.
  Surd(Rational p, Rational q, Rational d);

  /// Off by no more than error().
  [[nodiscard]] double approximation() const { return approximation_; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] bool is_rational() const;

  /// -1, 0 or 1: exact.
  [[nodiscard]] int sign() const;
  friend int compare(const Surd& a, const Surd& b);

 private:
  Rational p_;
  Rational q_;
  Rational d_;
  double approximation_;
  double error_;
};

}  // namespace lamina::reference
