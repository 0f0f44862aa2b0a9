// Eigenvalues of companion matrices, by Eigen.
#pragma once

#include <span>

#include "number/concepts.hpp"

namespace lamina::number {

template <RoundedNumber Number>
struct Eigenvalue {
  Number re;
  Number im;  ///< exactly zero for a real one
};

/// Computes the eigenvalues of the companion matrix of c[0] + ... + c[n-1] t^(n-1) + t^n, in no
/// order, conjugate pairs side by side: the matrix is balanced by powers of two (Osborne 1960), and
/// Eigen does the QR iteration with double shifts (Francis 1961). Returns false, and sets nothing,
/// if that does not converge. Does the same operations for each number type, but that Eigen takes
/// as zero what has a square below the type's least number. Allocates nothing.
///
/// Contract: finite, 1 <= n <= 16, room for n eigenvalues.
template <RoundedNumber Number>
bool companion_eigenvalues(std::span<const Number> c, std::span<Eigenvalue<Number>> eigenvalues);

}  // namespace lamina::number
