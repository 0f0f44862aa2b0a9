// Ferrari's closed form for quartic equations, in rounded arithmetic.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "poly/cubic.hpp"

namespace lamina::poly {

/// Returns the real roots of a quartic by the closed form: the depressed quartic is split in two
/// quadratics by the largest root of its resolvent cubic, from cardano_roots.
///
/// Multiplicity: 2 where the computed discriminant of a quadratic is exactly zero; else not known.
/// Error:  no bound: it loses digits where roots are close or far smaller than the largest one,
///         and may invent or drop pairs. Uses acos, cos and cbrt, which differ in the last bits
///         between number types.
/// Source: Ferrari, in Cardano 1545.
template <RoundedNumber Number>
RealRoots<Number> ferrari_roots(const Polynomial<Number>& polynomial) {
  using std::sqrt;
  const ScaledPolynomial<Number> scaled = safely_scaled(polynomial);
  const std::array<Number, kMostDegree + 1>& c = scaled.p.c;
  // Monic and depressed: u = v - shift, v^4 + p v^2 + q v + r.
  const Number a3 = c[3] / c[4];
  const Number a2 = c[2] / c[4];
  const Number a1 = c[1] / c[4];
  const Number a0 = c[0] / c[4];
  const Number shift = a3 / 4;
  const Number s2 = shift * shift;
  const Number p = a2 - 6 * s2;
  const Number q = a1 - 2 * a2 * shift + 8 * s2 * shift;
  const Number r = a0 - a1 * shift + a2 * s2 - 3 * s2 * s2;

  RealRoots<Number> roots;
  const auto add = [&](const Number& v, int multiplicity) {
    roots.add(scaled.unscaled(Number(v - shift)), multiplicity);
  };
  if (q == 0) {  // a quadratic in v^2
    add_quadratic_roots(Number(1), p, r, [&](const Number& square, int multiplicity) {
      if (square == 0) {
        add(Number(0), multiplicity == 0 ? 2 : 2 * multiplicity);
      } else if (square > 0) {
        const Number v = sqrt(square);
        add(v, multiplicity);
        add(Number(-v), multiplicity);
      }
    });
    return roots;
  }
  const std::array<Number, 4> resolvent{-q * q, p * p - 4 * r, 2 * p, Number(1)};
  const RealRoots<Number> y = cardano_roots(Polynomial<Number>(std::span<const Number>(resolvent)));
  if (y.count == 0 || !(y.t[y.count - 1] > 0)) {
    return roots;
  }
  const Number y_most = y.t[y.count - 1];
  const Number s = sqrt(y_most);  // (v^2 + s v + m)(v^2 - s v + n), m + n - y = p, s (n - m) = q
  add_quadratic_roots(Number(1), s, Number((p + y_most - q / s) / 2), add);
  add_quadratic_roots(Number(1), Number(-s), Number((p + y_most + q / s) / 2), add);
  return roots;
}

/// Returns ferrari_roots, polished: each by up to kPolishSteps Newton steps on p, while they lower
/// |p|. A simple root is then off by little more than Horner's rule makes of it; one that the
/// closed form invents, drops or merges stays so.
template <RoundedNumber Number>
RealRoots<Number> ferrari_polished_roots(const Polynomial<Number>& p) {
  return polished(p, ferrari_roots(p));
}

}  // namespace lamina::poly
