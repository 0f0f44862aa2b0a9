#include "support/reference_surd.hpp"

#include <cmath>

namespace lamina::reference {

using number::Integer;
using number::Rational;

namespace {

int sign_of(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// The sign of x + y where both signs and the sign of x^2 - y^2 are known.
int sign_of_sum(int x, int y, int squares) {
  if (x == y || y == 0) {
    return x;
  }
  return x == 0 ? y : squares == 0 ? 0 : squares > 0 ? x : y;
}

// The sign of p + q sqrt(d).
int sign_of_surd(const Rational& p, const Rational& q, const Rational& d) {
  const int root = d == 0 ? 0 : sign_of(q);
  return sign_of_sum(sign_of(p), root, sign_of(p * p - q * q * d));
}

bool is_square(const Integer& value) {
  const Integer root = sqrt(value);
  return root * root == value;
}

}  // namespace

Surd::Surd(Rational p, Rational q, Rational d)
    : p_(std::move(p)), q_(std::move(q)), d_(std::move(d)) {
  // Each conversion is off by less than 2^-52 of its value, and so is the root; the product of
  // q and the root then by less than 3 * 2^-52, and the sum by 2^-53 more.
  const auto first = p_.convert_to<double>();
  const double second = q_.convert_to<double>() * std::sqrt(d_.convert_to<double>());
  approximation_ = first + second;
  error_ = std::ldexp(std::abs(first) + std::abs(second), -49);
}

bool Surd::is_rational() const {
  return q_ == 0 || (is_square(numerator(d_)) && is_square(denominator(d_)));
}

int Surd::sign() const { return sign_of_surd(p_, q_, d_); }

// a - b is P + X with X = Q sqrt(c) - R sqrt(d): the sign of X is that of a difference of
// squares, and P^2 - X^2 is itself a surd, (P^2 - Q^2 c - R^2 d) + 2 Q R sqrt(c d).
int compare(const Surd& a, const Surd& b) {
  if (std::abs(a.approximation_ - b.approximation_) > 2 * (a.error_ + b.error_)) {
    return a.approximation_ < b.approximation_ ? -1 : 1;
  }
  const Rational difference = a.p_ - b.p_;
  const Rational first = a.q_ * a.q_ * a.d_;
  const Rational second = b.q_ * b.q_ * b.d_;
  const int roots = sign_of_sum(a.d_ == 0 ? 0 : sign_of(a.q_), b.d_ == 0 ? 0 : -sign_of(b.q_),
                                sign_of(first - second));
  const int squares =
      sign_of_surd(difference * difference - first - second, 2 * a.q_ * b.q_, a.d_ * b.d_);
  return sign_of_sum(sign_of(difference), roots, squares);
}

}  // namespace lamina::reference
