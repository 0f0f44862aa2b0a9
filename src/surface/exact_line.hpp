// Lines through a solid that cross its surface at roots of known polynomials only: exactly, by
// sample points between these.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "number/algebraic.hpp"
#include "surface/polynomials.hpp"

namespace lamina::surface {

/// Ascending; leading zeros are allowed.
using RationalPolynomial = std::vector<number::Rational>;

RationalPolynomial derivative(const RationalPolynomial& p);
/// Of a polynomial that is not zero, for s just above 0: its first coefficient's that is not.
int sign_after_zero(const RationalPolynomial& p);

/// Rationals around a root: its doubles, or others where these do not reach as far.
number::Enclosure bounds_of(const number::Root& root);
/// A rational between two different roots, a < b.
number::Rational between(const number::Root& a, const number::Root& b);

/// How a line begins, for t towards -infinity.
struct LineStart {
  bool inside = false;
  bool in_boundary = false;  ///< it runs along the surface somewhere
};

/// Goes along a line, given all t at which it can cross the surface.
///
/// Arguments: ascending  each with its root `t`; several may be equal.
///            side_at    of a rational t: -1 inside, 0 on the surface, 1 outside.
///            cross      is called with each span of equal candidates where the side changes;
///                       in vain if the line is found to run along the surface behind it.
template <typename Candidate, typename SideAt, typename Cross>
LineStart walk(std::span<const Candidate> ascending, const SideAt& side_at, const Cross& cross) {
  int before =
      side_at(ascending.empty() ? number::Rational(0)
                                : number::Rational(bounds_of(ascending.front().t).lower - 1));
  LineStart start{before < 0, before == 0};
  for (auto first = ascending.begin(); first != ascending.end() && !start.in_boundary;) {
    const auto end = std::find_if(first, ascending.end(), [first](const Candidate& later) {
      return compare(first->t, later.t) < 0;
    });
    const int after =
        side_at(end == ascending.end() ? number::Rational(bounds_of(std::prev(end)->t).upper + 1)
                                       : between(std::prev(end)->t, end->t));
    start.in_boundary = after == 0;
    if (after == -before) {
      cross(std::span<const Candidate>(first, end));
    }
    before = after;
    first = end;
  }
  return start;
}

}  // namespace lamina::surface
