#pragma once

// Vectors would add in another order than the software floats do.
#define EIGEN_DONT_VECTORIZE
#include <cmath>
#include <eigen3/Eigen/Eigenvalues>

#include "number/eigenvalues.hpp"
#include "number/traits.hpp"

namespace lamina::number {
namespace detail {

// Makes rows and columns about equally long, the diagonal left out, by a similarity.
template <typename Matrix>
void balance(Matrix& m) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  using Number = typename Matrix::Scalar;
  constexpr int kMostSweeps = 100;  // a few are enough
  bool changed = true;
  for (int sweep = 0; changed && sweep < kMostSweeps; ++sweep) {
    changed = false;
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      Number row = 0;
      Number column = 0;
      for (Eigen::Index j = 0; j < m.rows(); ++j) {
        if (j != i) {
          row += abs(m(i, j));
          column += abs(m(j, i));
        }
      }
      int row_exponent = 0;
      int column_exponent = 0;
      (void)frexp(row, &row_exponent);
      (void)frexp(column, &column_exponent);
      const int shift = (row_exponent - column_exponent) / 2;
      if (row == 0 || column == 0 || shift == 0) {
        continue;
      }
      changed = true;
      for (Eigen::Index j = 0; j < m.rows(); ++j) {
        if (j != i) {
          m(i, j) = ldexp(m(i, j), -shift);
          m(j, i) = ldexp(m(j, i), shift);
        }
      }
    }
  }
}

}  // namespace detail

template <RoundedNumber Number>
bool companion_eigenvalues(std::span<const Number> c, std::span<Eigenvalue<Number>> eigenvalues) {
  using std::abs;
  using std::sqrt;
  constexpr int kMost = 16;
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
  const auto n = static_cast<Eigen::Index>(c.size());
  Matrix companion = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    companion(i, n - 1) = -c[i];
    if (i > 0) {
      companion(i, i - 1) = 1;
    }
  }
  detail::balance(companion);
  // A Hessenberg matrix already: the iteration can start.
  Eigen::RealSchur<Matrix> schur(n);
  schur.computeFromHessenberg(companion, companion, false);
  if (schur.info() != Eigen::Success) {
    return false;
  }
  const Matrix& t = schur.matrixT();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i + 1 == n || t(i + 1, i) == 0) {
      eigenvalues[i] = {t(i, i), Number(0)};
      continue;
    }
    const Number half = (t(i, i) - t(i + 1, i + 1)) / 2;
    const Number re = t(i + 1, i + 1) + half;
    const Number im = sqrt(Number(abs(Number(half * half + t(i + 1, i) * t(i, i + 1)))));
    eigenvalues[i] = {re, im};
    eigenvalues[i + 1] = {re, Number(-im)};
    ++i;
  }
  return true;
}

}  // namespace lamina::number
