// What the closed forms for cubics and quartics share: scaling, quadratic factors, polishing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "number/fused.hpp"
#include "poly/polynomial.hpp"
#include "poly/real_roots.hpp"
#include "poly/scaling.hpp"

namespace lamina::poly {

/// A polynomial in u, where t = 2^exponent u is what the unscaled one is in.
template <RoundedNumber Number>
struct ScaledPolynomial {
  Polynomial<Number> p;
  std::int64_t exponent = 0;

  [[nodiscard]] Number unscaled(const Number& u) const { return times_power_of_two(u, exponent); }
};

/// Returns p with its roots scaled to at most 2^(max_exponent / 8) and its leading coefficient into
/// [1/2, 1]: products of seven lengths do not overflow, and small roots are far from underflow.
/// By powers of two, so that it rounds nothing but what underflows. Coefficients may become
/// infinite only if a root is beyond the numbers' range. Contract: finite, of degree 1 to 4.
template <RoundedNumber Number>
ScaledPolynomial<Number> safely_scaled(const Polynomial<Number>& p) {
  // No more than for double: software floats, with far larger exponents, do as double does.
  constexpr long kRoom = std::min<long>(std::numeric_limits<Number>::max_exponent, 1024) / 8;
  ScaledPolynomial<Number> scaled;
  scaled.exponent = exponent_of(root_bound(p)) - 1 - kRoom;
  scaled.p.degree = p.degree;
  const std::int64_t leading = exponent_of(p.c[p.degree]);
  for (int i = 0; i <= p.degree; ++i) {
    scaled.p.c[i] = times_power_of_two(p.c[i], (i - p.degree) * scaled.exponent - leading);
  }
  return scaled;
}

/// Calls add(root, multiplicity) for the real roots of a t^2 + b t + c. The discriminant is
/// Kahan's, at most 3/2 ulp off; where it is exactly zero there is one root, of multiplicity 2.
/// The multiplicity of others is given as 0: what they are roots of may have other factors.
/// Contract: a is not zero.
template <RoundedNumber Number, typename Add>
void add_quadratic_roots(const Number& a, const Number& b, const Number& c, const Add& add) {
  using std::sqrt;
  const Number half_b = b / 2;
  const Number discriminant = number::difference_of_products(half_b, half_b, a, c);
  if (discriminant == 0) {
    add(Number(-half_b / a), 2);
  } else if (discriminant > 0) {
    const Number root = sqrt(discriminant);
    const Number q = half_b < 0 ? Number(root - half_b) : Number(-(half_b + root));
    add(Number(q / a), 0);
    add(Number(c / q), 0);
  }
}

inline constexpr int kPolishSteps = 8;

/// Takes up to kPolishSteps Newton steps on p from each root, each only if it lowers |p| as
/// Horner's rule gives it. Mends simple roots of a few correct digits; nothing keeps two close
/// ones from meeting.
template <RoundedNumber Number>
RealRoots<Number> polished(const Polynomial<Number>& p, const RealRoots<Number>& roots) {
  using std::abs;
  RealRoots<Number> result;
  for (int i = 0; i < roots.count; ++i) {
    Number t = roots.t[i];
    ValueAndSlope<Number> at = value_and_slope(p, t);
    for (int step = 0; step < kPolishSteps && at.slope != 0; ++step) {
      const Number next = t - at.value / at.slope;
      const ValueAndSlope<Number> next_at = value_and_slope(p, next);
      if (!(abs(next_at.value) < abs(at.value))) {
        break;
      }
      t = next;
      at = next_at;
    }
    result.add(t, roots.multiplicity[i]);
  }
  return result;
}

}  // namespace lamina::poly
