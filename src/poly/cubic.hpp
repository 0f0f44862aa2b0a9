// Cubic equations in rounded arithmetic.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "poly/closed_form.hpp"

namespace lamina::poly {

/// Returns the real roots of a cubic by the closed form: Cardano's where there is one, Viete's
/// cosines where there are three.
///
/// Multiplicity: 2 and 1, or 3, where the computed discriminant is exactly zero; else not known.
/// Error:  no bound relative to a root: off by some units of roundoff of the largest one, complex
///         ones included, far more where roots are close, and then it may invent or drop a pair.
///         Uses acos, cos and cbrt, which differ in the last bits between number types.
/// Source: Cardano 1545, Viete 1615.
template <RoundedNumber Number>
RealRoots<Number> cardano_roots(const Polynomial<Number>& p) {
  using std::abs;
  using std::acos;
  using std::cbrt;
  using std::cos;
  using std::sqrt;
  const ScaledPolynomial<Number> scaled = safely_scaled(p);
  const Number a = scaled.p.c[2] / scaled.p.c[3];
  const Number b = scaled.p.c[1] / scaled.p.c[3];
  const Number c = scaled.p.c[0] / scaled.p.c[3];
  // w^3 - 3 q w + 2 r with w = 3 u + a: no thirds, so that small whole coefficients stay exact
  // and a discriminant of zero is seen.
  const Number q = a * a - 3 * b;
  const Number r = (2 * a * a * a - 9 * a * b + 27 * c) / 2;
  const Number q3 = q * q * q;
  const Number r2 = r * r;

  RealRoots<Number> roots;
  const auto add = [&](const Number& w, int multiplicity) {
    roots.add(scaled.unscaled(Number((w - a) / 3)), multiplicity);
  };
  if (r2 < q3) {
    const Number angle = acos(Number(r / sqrt(q3)));
    const Number turn = 2 * acos(Number(-1));
    for (const Number& phase : {Number(angle - turn), angle, Number(angle + turn)}) {
      add(Number(-2 * sqrt(q) * cos(Number(phase / 3))), 0);
    }
  } else if (r2 > q3) {
    const Number magnitude = cbrt(Number(abs(r) + sqrt(Number(r2 - q3))));
    const Number w = r > 0 ? Number(-magnitude) : magnitude;
    add(Number(w + q / w), 0);
  } else if (q == 0) {
    add(Number(0), 3);
  } else {
    const Number w = r / q;  // the cube root of r, since r^2 = q^3
    add(Number(-2 * w), 1);
    add(w, 2);
  }
  return roots;
}

/// Returns cardano_roots, polished: each by up to kPolishSteps Newton steps on p, while they lower
/// |p|. A simple root is then off by little more than Horner's rule makes of it; one that the
/// closed form invents, drops or merges stays so.
template <RoundedNumber Number>
RealRoots<Number> cardano_polished_roots(const Polynomial<Number>& p) {
  return polished(p, cardano_roots(p));
}

namespace detail {

// The root on the side of the inflection where it is alone; the inflection if that is a root.
// Newton's steps from beyond the root are monotone: they stop where rounding turns one back.
template <RoundedNumber Number>
Number outer_cubic_root(const Polynomial<Number>& p) {
  const Number inflection = -(p.c[2] / p.c[3]) / 3;
  ValueAndSlope<Number> at = value_and_slope(p, inflection);
  if (at.value == 0) {
    return inflection;
  }
  // Kahan starts 1.3247... max(|height|^(1/3), (-slope)^(1/2)) away. A power of two is up to four
  // times as far, some steps more, but needs no cube root, which number types round differently.
  const std::array<Number, 4> depressed{at.value / p.c[3], at.slope / p.c[3], Number(0), Number(1)};
  const Number reach = root_bound(Polynomial<Number>(std::span<const Number>(depressed)));
  const Number offset = depressed[0] > 0 ? Number(-reach) : reach;
  Number t = inflection + offset;
  // Kahan's divisor: steps a trifle short, lest rounding carries a long one over the root.
  const Number divisor = 1 + 8 * number::unit_roundoff<Number>();
  // A step removes at least a third of the distance, and the square of it where the root is
  // simple: the limit is never met but where rounding errors creep.
  const int most_steps = 64 + 2 * number::number_traits<Number>::kSignificandBits;
  for (int step = 0; step < most_steps; ++step) {
    at = value_and_slope(p, t);
    if (at.slope == 0) {
      break;
    }
    Number next = t - at.value / at.slope / divisor;
    if (offset > 0 ? next < inflection : next > inflection) {
      next = inflection;
    }
    if (!(offset > 0 ? next < t : next > t)) {
      break;
    }
    t = next;
  }
  return t;
}

}  // namespace detail

/// Returns the real roots of a cubic: one by Newton's method, started beyond it and kept from
/// passing the inflection, the others from the quotient, divided from the end that keeps it
/// accurate, with Kahan's discriminant.
///
/// Multiplicity: 2 where the discriminant of the quotient is exactly zero; else not known. A
///         triple root stands as one and a double one.
/// Error:  each is a root of a cubic whose coefficients differ by some units of roundoff: few
///         units of roundoff where roots are separated, whatever their ratios; close ones move by
///         the root of that, and a pair may be invented or dropped.
/// Source: W. Kahan, "To Solve a Real Cubic Equation", 1986.
template <RoundedNumber Number>
RealRoots<Number> kahan_cubic_roots(const Polynomial<Number>& p) {
  using std::abs;
  const ScaledPolynomial<Number> scaled = safely_scaled(p);
  const std::array<Number, kMostDegree + 1>& c = scaled.p.c;
  const Number root = c[0] == 0 ? Number(0) : detail::outer_cubic_root(scaled.p);
  // The quotient from its leading end, or from the other one if the root is large: so its errors
  // are small against the coefficients.
  Number linear = c[3] * root + c[2];
  Number constant = linear * root + c[1];
  if (abs(c[3] * root * root * root) > abs(c[0])) {
    constant = -c[0] / root;
    linear = (constant - c[1]) / root;
  }
  RealRoots<Number> roots;
  const auto add = [&](const Number& u, int multiplicity) {
    roots.add(scaled.unscaled(u), multiplicity);
  };
  add(root, 0);
  add_quadratic_roots(c[3], linear, constant, add);
  return roots;
}

}  // namespace lamina::poly
