// Positive roots of polynomials whose coefficients are only enclosed: certified or undecided.
#pragma once

#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "number/interval.hpp"

namespace lamina::poly {

/// A simple root s > 0, alone in an interval of u = s / (1 + s) with rational ends, at which
/// the polynomial has opposite signs for certain.
class IsolatedRoot {
 public:
  /// Bounds of u, in 0 .. 1. The order of u is that of s.
  [[nodiscard]] const number::Enclosure& bounds() const { return bounds_; }

  /// Makes the interval narrower: by a step of the interval Newton method where that takes it to
  /// a quarter or less, else by cutting it in about half. Returns false, and leaves it, if the
  /// coefficients are not enclosed narrowly enough to tell on which side the root is, or if it is
  /// narrower than 2^-b for coefficients of b bits.
  bool refine();

 private:
  friend std::optional<std::vector<IsolatedRoot>> positive_roots(
      std::vector<number::Interval> ascending);
  struct Isolation;

  IsolatedRoot(std::vector<number::Interval> bernstein, number::Enclosure bounds)
      : bernstein_(std::move(bernstein)), bounds_(std::move(bounds)) {}

  bool newton_step();
  bool bisection_step();

  std::vector<number::Interval> bernstein_;  // on the interval
  number::Enclosure bounds_;
};

/// Returns the positive roots of c_0 + c_1 s + ... + c_n s^n, ascending: certified for every
/// polynomial whose coefficients lie in the intervals. None if that cannot be certified: a
/// multiple root, or intervals that are too wide for close ones, for one near zero or beyond
/// all bounds.
///
/// Descartes' rule of signs in the Bernstein basis, with bisection (Collins and Akritas 1976);
/// the roots are refined by the interval Newton method (Moore 1966).
std::optional<std::vector<IsolatedRoot>> positive_roots(std::vector<number::Interval> ascending);

/// Returns the order of two roots of different polynomials, refining both until they are
/// apart; none if their intervals can no longer be cut.
std::optional<std::strong_ordering> compare(IsolatedRoot& a, IsolatedRoot& b);

/// Sorts items by their roots, ascending, which root_of returns a reference to. Returns false if
/// two of them cannot be compared.
template <typename Item, typename RootOf>
bool sort_by_root(std::vector<Item>& items, const RootOf& root_of) {
  // Insertion sort: comparing may fail.
  for (std::size_t i = 1; i < items.size(); ++i) {
    for (std::size_t j = i; j > 0; --j) {
      const auto order = compare(root_of(items[j - 1]), root_of(items[j]));
      if (!order) {
        return false;
      }
      if (*order < 0) {
        break;
      }
      std::swap(items[j - 1], items[j]);
    }
  }
  return true;
}

/// Returns bounds of s itself with upper - lower <= 2^-bits * max(1, lower); none if the
/// coefficients are not enclosed narrowly enough.
std::optional<number::Enclosure> enclosure(IsolatedRoot root, int bits);

}  // namespace lamina::poly
