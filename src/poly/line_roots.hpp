// What every root finder returns: the sign changes of a polynomial along a line.
#pragma once

#include <array>
#include <utility>

#include "number/traits.hpp"

namespace lamina::poly {

using number::RoundedNumber;

/// Up to four roots of odd multiplicity, ascending. Roots of even multiplicity are touches,
/// no crossings: a solver that sees two equal roots leaves both out. A root may be an
/// infinity where it overflows; NaN never appears.
template <RoundedNumber Number>
struct LineRoots {
  std::array<Number, 4> t{};
  int count = 0;

  /// Inserts in ascending order; a root equal to one that is there removes it (a touch).
  void cross(const Number& root) {
    if (!(root == root)) {
      return;
    }
    int place = count;
    while (place > 0 && root < t[place - 1]) {
      --place;
    }
    if (place > 0 && t[place - 1] == root) {
      for (int i = place; i < count; ++i) {
        t[i - 1] = t[i];
      }
      --count;
      return;
    }
    for (int i = count; i > place; --i) {
      t[i] = t[i - 1];
    }
    t[place] = root;
    ++count;
  }
};

enum class QuadraticSolver : std::uint8_t { Plain, Careful };
enum class QuarticSolver : std::uint8_t { Ferrari, Monotone };

/// Which solver finds the roots of which degree.
struct Solvers {
  QuadraticSolver quadratic = QuadraticSolver::Careful;
  QuarticSolver quartic = QuarticSolver::Monotone;
};

}  // namespace lamina::poly
