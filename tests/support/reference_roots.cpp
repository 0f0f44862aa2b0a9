#include "support/reference_roots.hpp"

#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace lamina::reference {

using number::Integer;
using number::Rational;

namespace {

// FLINT's and Arb's objects, freed at the end of their scope.
class Number {
 public:
  Number() { fmpz_init(value_); }
  explicit Number(const Integer& value) : Number() { fmpz_set_mpz(value_, value.backend().data()); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { fmpz_clear(value_); }
  fmpz* get() { return value_; }

  [[nodiscard]] Integer integer() const {
    Integer result;
    fmpz_get_mpz(result.backend().data(), value_);
    return result;
  }

 private:
  fmpz_t value_;
};

class Polynomial {
 public:
  explicit Polynomial(const std::vector<Integer>& ascending) {
    fmpz_poly_init(value_);
    for (std::size_t i = 0; i < ascending.size(); ++i) {
      fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(i), Number(ascending[i]).get());
    }
  }
  Polynomial(const Polynomial&) = delete;
  Polynomial& operator=(const Polynomial&) = delete;
  ~Polynomial() { fmpz_poly_clear(value_); }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

class SquareFreeFactors {
 public:
  explicit SquareFreeFactors(const Polynomial& polynomial) {
    fmpz_poly_factor_init(value_);
    fmpz_poly_factor_squarefree(value_, polynomial.get());
  }
  SquareFreeFactors(const SquareFreeFactors&) = delete;
  SquareFreeFactors& operator=(const SquareFreeFactors&) = delete;
  ~SquareFreeFactors() { fmpz_poly_factor_clear(value_); }

  [[nodiscard]] slong count() const { return value_->num; }
  [[nodiscard]] const fmpz_poly_struct* factor(slong i) const { return value_->p + i; }
  [[nodiscard]] unsigned multiplicity(slong i) const {
    return static_cast<unsigned>(value_->exp[i]);
  }

 private:
  fmpz_poly_factor_t value_;
};

class ComplexRoots {
 public:
  // Of a square-free polynomial.
  ComplexRoots(const fmpz_poly_struct* polynomial, slong bits)
      : count_(fmpz_poly_degree(polynomial)), roots_(_acb_vec_init(count_)) {
    arb_fmpz_poly_complex_roots(roots_, polynomial, 0, bits);
  }
  ComplexRoots(const ComplexRoots&) = delete;
  ComplexRoots& operator=(const ComplexRoots&) = delete;
  ~ComplexRoots() { _acb_vec_clear(roots_, count_); }

  [[nodiscard]] const acb_struct* begin() const { return roots_; }
  [[nodiscard]] const acb_struct* end() const { return roots_ + count_; }

 private:
  slong count_;
  acb_ptr roots_;
};

Rational times_power_of_two(const Integer& value, const Integer& exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(abs(exponent));
  return exponent < 0 ? Rational(value, power) : Rational(value * power);
}

// Arb looks for roots around 1, and for ever if all are very far from there: it is given those of
// p(2^shift t), whose first and last coefficients that are not zero have about the same size.
int balancing_shift(const std::vector<Integer>& ascending) {
  const auto not_zero = [](const Integer& c) { return c != 0; };
  const auto first = std::find_if(ascending.begin(), ascending.end(), not_zero);
  const auto last = std::find_if(ascending.rbegin(), ascending.rend(), not_zero).base();
  if (last - first < 2) {
    return 0;
  }
  const int difference = static_cast<int>(msb(abs(*first))) - static_cast<int>(msb(abs(last[-1])));
  return difference / static_cast<int>(last - first - 1);
}

std::vector<Integer> with_stretched_argument(std::vector<Integer> ascending, int shift) {
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    ascending[i] <<= std::abs(shift) * (shift < 0 ? ascending.size() - 1 - i : i);
  }
  return ascending;
}

RealRoot bounds(const arb_struct* ball, int shift, unsigned multiplicity) {
  Number lower;
  Number upper;
  Number exponent;
  arb_get_interval_fmpz_2exp(lower.get(), upper.get(), exponent.get(), ball);
  const Integer shifted = exponent.integer() + shift;
  return {times_power_of_two(lower.integer(), shifted),
          times_power_of_two(upper.integer(), shifted), multiplicity};
}

bool is_narrow(const RealRoot& root, int bits) {
  const Rational least = std::min(Rational(abs(root.lower)), Rational(abs(root.upper)));
  return (root.upper - root.lower) * Rational(Integer(1) << static_cast<unsigned>(bits)) <= least;
}

}  // namespace

std::vector<RealRoot> real_roots(const std::vector<Integer>& ascending, int bits) {
  const int shift = balancing_shift(ascending);
  const Polynomial polynomial(with_stretched_argument(ascending, shift));
  if (fmpz_poly_is_zero(polynomial.get()) != 0) {
    throw std::invalid_argument("the zero polynomial has every number as a root");
  }
  const SquareFreeFactors factors(polynomial);
  // Roots of one factor are told apart by Arb, those of different factors only by their bounds.
  for (slong precision = bits + 2;; precision *= 2) {
    std::vector<RealRoot> found;
    for (slong i = 0; i < factors.count(); ++i) {
      for (const acb_struct& root : ComplexRoots(factors.factor(i), precision)) {
        if (acb_is_real(&root) != 0) {
          found.push_back(bounds(acb_realref(&root), shift, factors.multiplicity(i)));
        }
      }
    }
    std::sort(found.begin(), found.end(),
              [](const RealRoot& a, const RealRoot& b) { return a.lower < b.lower; });
    const auto meeting =
        std::adjacent_find(found.begin(), found.end(),
                           [](const RealRoot& a, const RealRoot& b) { return a.upper >= b.lower; });
    if (meeting == found.end() && std::all_of(found.begin(), found.end(), [&](const RealRoot& r) {
          return is_narrow(r, bits);
        })) {
      return found;
    }
  }
}

}  // namespace lamina::reference
