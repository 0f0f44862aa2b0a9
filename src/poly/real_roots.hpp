// What every root finder returns: the real roots of a polynomial in a range.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "poly/polynomial.hpp"

namespace lamina::poly {

/// low <= t <= high; the ends may be infinite.
template <RoundedNumber Number>
struct Range {
  Number low = -std::numeric_limits<Number>::infinity();
  Number high = std::numeric_limits<Number>::infinity();

  [[nodiscard]] bool contains(const Number& t) const { return low <= t && t <= high; }
};

enum class Outcome : std::uint8_t {
  Found,       ///< the roots are what the solver finds
  Everywhere,  ///< the zero polynomial: every t is a root, none is listed
  NotFinite,   ///< a coefficient is an infinity or NaN
  Undecided,   ///< certified solvers only: these bits cannot tell; no roots are listed
};

/// Roots in ascending order, without NaN. Two that are equal stand twice, unless the solver knows
/// the multiplicity.
template <RoundedNumber Number>
struct RealRoots {
  std::array<Number, kMostDegree> t;
  std::array<std::uint8_t, kMostDegree> multiplicity;  ///< 0 where the solver cannot know it
  int count = 0;
  Outcome outcome = Outcome::Found;

  /// Inserts in order; leaves out NaN, and what there is no room for.
  void add(const Number& root, int its_multiplicity = 0) {
    if (!(root == root) || count == kMostDegree) {
      return;
    }
    int place = count++;
    for (; place > 0 && root < t[place - 1]; --place) {
      t[place] = t[place - 1];
      multiplicity[place] = multiplicity[place - 1];
    }
    t[place] = root;
    multiplicity[place] = static_cast<std::uint8_t>(its_multiplicity);
  }
};

}  // namespace lamina::poly
