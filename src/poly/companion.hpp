// Real roots as eigenvalues.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "number/eigenvalues.hpp"
#include "poly/real_roots.hpp"
#include "poly/scaling.hpp"

namespace lamina::poly {

/// Returns the real roots of a polynomial of degree 1 or more: the real eigenvalues of its
/// companion matrix, balanced, by Eigen's real Schur form. An eigenvalue is real if that form has
/// it in a block of its own, so that its imaginary part is exactly zero; rounding decides whether
/// a double root gives two real ones or a pair. Roots that are exactly zero are split off before.
/// None but these is returned where the QR iteration does not converge.
///
/// Error:  the eigenvalues are those of a matrix that is off by a small multiple of u times the
///         norm of the balanced one: small roots next to large ones lose digits, or become pairs
///         (Edelman and Murakami 1995).
template <RoundedNumber Number>
RealRoots<Number> companion_roots(const Polynomial<Number>& p) {
  RealRoots<Number> roots;
  // No root exceeds 1 in these units, and no coefficient the leading one.
  const std::int64_t exponent = exponent_of(root_bound(p));
  const Polynomial<Number> scaled = in_units_of_power_of_two(p, exponent);
  int zeros = 0;
  for (; scaled.c[zeros] == 0; ++zeros) {
    roots.add(Number(0));
  }
  const int n = p.degree - zeros;
  std::array<Number, kMostDegree> monic;
  for (int i = 0; i < n; ++i) {
    monic[i] = scaled.c[zeros + i] / scaled.c[p.degree];
  }
  std::array<number::Eigenvalue<Number>, kMostDegree> eigenvalues;
  const auto size = static_cast<std::size_t>(n);
  if (n == 0 || !number::companion_eigenvalues(std::span<const Number>(monic.data(), size),
                                               std::span(eigenvalues.data(), size))) {
    return roots;
  }
  for (int i = 0; i < n; ++i) {
    if (eigenvalues[i].im == 0) {
      roots.add(times_power_of_two(eigenvalues[i].re, exponent));
    }
  }
  return roots;
}

}  // namespace lamina::poly
