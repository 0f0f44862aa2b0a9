// Real algebraic numbers: the exact points at which a ray meets a surface.
//
// Degrees 1 and 2 are decided by signs of integers alone and, where two different
// quadratic roots meet, by CGAL's Sqrt_extension; degree 3 and above by CGAL's
// Algebraic_kernel_d_1. A certified pair of doubles around every root answers most
// comparisons before either is asked.
#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "number/rational.hpp"

namespace lamina::number {

/// A univariate polynomial with integer coefficients, ascending, no leading zeros;
/// the zero polynomial has no coefficients and degree -1.
class IntegerPolynomial {
 public:
  IntegerPolynomial() = default;
  explicit IntegerPolynomial(std::vector<Integer> ascending);

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  [[nodiscard]] const Integer& operator[](std::size_t power) const { return coefficients_[power]; }
  [[nodiscard]] const std::vector<Integer>& coefficients() const { return coefficients_; }

  /// Sign of the value, exact.
  [[nodiscard]] int sign_at(const Rational& t) const;
  /// Sign for t towards -infinity: sign(leading coefficient) * (-1)^degree; 0 only
  /// for the zero polynomial.
  [[nodiscard]] int sign_at_minus_infinity() const;

 private:
  std::vector<Integer> coefficients_;
};

/// Returns the polynomial with the given rational coefficients (ascending) times
/// the positive least common denominator: the same roots and the same signs.
IntegerPolynomial with_cleared_denominators(const std::vector<Rational>& ascending);

/// A closed interval of rationals.
struct Enclosure {
  Rational lower;
  Rational upper;
};

/// A real root of an integer polynomial. A value: cheap to copy. Two threads may use
/// copies of one root only if its polynomial has degree 2 or less, since CGAL refines
/// roots of higher degree in place.
class Root {
 public:
  /// The root that is this rational.
  explicit Root(const Rational& value);

  /// Multiplicity in the polynomial that real_roots was given; 1 for rationals.
  [[nodiscard]] unsigned multiplicity() const { return multiplicity_; }

  /// Certified bounds, at most a few ulps apart where the value is in double's range.
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }

  struct Representation;

 private:
  friend struct RootAccess;
  Root() = default;

  std::shared_ptr<const Representation> representation_;
  double lower_ = 0;
  double upper_ = 0;
  unsigned multiplicity_ = 1;
};

/// Returns the distinct real roots, ascending, each with its multiplicity. Exact.
/// Contract: the polynomial is not zero.
std::vector<Root> real_roots(const IntegerPolynomial& polynomial);

/// Exact order of two roots, whatever polynomials they are roots of.
std::strong_ordering compare(const Root& a, const Root& b);

/// Exact order of a root and a rational.
std::strong_ordering compare(const Root& a, const Rational& b);

/// Sign of the polynomial's value at the root, exact: -1, 0 or 1.
int sign_at(const IntegerPolynomial& polynomial, const Root& root);

/// Returns bounds with upper - lower <= 2^-bits * max(|root|, 2^-bits): certified.
Enclosure enclosure(const Root& root, int bits);

/// Returns the double nearest to the root, ties to even. Correctly rounded.
double nearest_double(const Root& root);

/// Returns scale * root + shift. Contract: scale > 0.
Root affine_image(const Root& root, const Rational& scale, const Rational& shift);

}  // namespace lamina::number
