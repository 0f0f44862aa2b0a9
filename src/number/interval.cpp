#include "number/interval.hpp"

#include <mpfr.h>

#include <algorithm>

#include "base/contract.hpp"

namespace lamina::number {
namespace {

Rational rational_of(mpfr_srcptr value) {
  Rational result;
  mpfr_get_q(result.backend().data(), value);
  return result;
}

mpfr_prec_t wider(mpfi_srcptr a, mpfi_srcptr b) {
  return std::max(mpfi_get_prec(a), mpfi_get_prec(b));
}

}  // namespace

Interval::Interval(mpfr_prec_t bits) { mpfi_init2(value_, bits); }

Interval::Interval() : Interval(Rational(0), MPFR_PREC_MIN) {}

Interval::Interval(const Rational& value, int bits) : Interval(static_cast<mpfr_prec_t>(bits)) {
  mpfi_set_q(value_, value.backend().data());
}

Interval::Interval(const Enclosure& bounds, int bits) : Interval(static_cast<mpfr_prec_t>(bits)) {
  mpfi_interv_q(value_, bounds.lower.backend().data(), bounds.upper.backend().data());
}

Interval::Interval(const Interval& other) : Interval(mpfi_get_prec(other.value_)) {
  mpfi_set(value_, other.value_);
}

Interval::Interval(Interval&& other) noexcept : Interval(mpfr_prec_t{MPFR_PREC_MIN}) {
  mpfi_swap(value_, other.value_);
}

Interval& Interval::operator=(Interval other) noexcept {
  mpfi_swap(value_, other.value_);
  return *this;
}

Interval::~Interval() { mpfi_clear(value_); }

int Interval::bits() const { return static_cast<int>(mpfi_get_prec(value_)); }

Rational Interval::lower() const { return rational_of(&value_->left); }

Rational Interval::upper() const { return rational_of(&value_->right); }

std::optional<int> Interval::sign() const {
  const int left = mpfr_sgn(&value_->left);
  const int right = mpfr_sgn(&value_->right);
  if (left > 0) {
    return 1;
  }
  if (right < 0) {
    return -1;
  }
  return left == 0 && right == 0 ? std::optional(0) : std::nullopt;
}

Interval& Interval::operator+=(const Interval& other) { return *this = *this + other; }

Interval operator+(const Interval& a, const Interval& b) {
  Interval sum(wider(a.value_, b.value_));
  mpfi_add(sum.value_, a.value_, b.value_);
  return sum;
}

Interval operator-(const Interval& a, const Interval& b) {
  Interval difference(wider(a.value_, b.value_));
  mpfi_sub(difference.value_, a.value_, b.value_);
  return difference;
}

Interval operator*(const Interval& a, const Interval& b) {
  Interval product(wider(a.value_, b.value_));
  mpfi_mul(product.value_, a.value_, b.value_);
  return product;
}

Interval operator*(const Integer& a, const Interval& b) {
  Interval product(mpfi_get_prec(b.value_));
  mpfi_mul_z(product.value_, b.value_, a.backend().data());
  return product;
}

Interval operator/(const Interval& a, const Integer& divisor) {
  Interval quotient(mpfi_get_prec(a.value_));
  mpfi_div_z(quotient.value_, a.value_, divisor.backend().data());
  return quotient;
}

Interval operator/(const Interval& a, const Interval& divisor) {
  LAMINA_REQUIRE(divisor.sign().value_or(0) != 0, "division by what may be zero");
  Interval quotient(wider(a.value_, divisor.value_));
  mpfi_div(quotient.value_, a.value_, divisor.value_);
  return quotient;
}

Interval hull(const Interval& a, const Interval& b) {
  Interval both(wider(a.value_, b.value_));
  mpfi_union(both.value_, a.value_, b.value_);
  return both;
}

}  // namespace lamina::number
