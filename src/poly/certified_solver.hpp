// Real roots with a certificate: each for certain alone in an interval, or no answer.
#pragma once

#include <array>
#include <span>

#include "poly/real_roots.hpp"

namespace lamina::poly {

/// Returns the real roots in the range, all of them simple for certain; Outcome::Undecided and
/// none where the bits of the number type cannot tell: a multiple root, an end of the range at a
/// root, roots too close for the rounding errors.
///
/// Sign changes in the Bernstein basis as in bernstein.hpp, but of interval coefficients, and the
/// roots enclosed by the interval Newton method (Moore 1966). Intervals of doubles (CGAL) for
/// significands up to 53 bits, which do not allocate; wider types take intervals of as many bits
/// as they have (MPFI, see certified_roots.hpp), which do.
///
/// Error:  each root is the middle of an enclosure that no step makes narrower; the count is
///         never wrong.
template <RoundedNumber Number>
RealRoots<Number> certified_real_roots(const Polynomial<Number>& p, const Range<Number>& range);

/// Some number from low to high.
struct Bounds {
  double low = 0;
  double high = 0;
};

/// Simple roots for certain, ascending, each alone between its bounds.
struct CertifiedRoots {
  std::array<Bounds, kMostDegree> t;
  int count = 0;
  Outcome outcome = Outcome::Found;  ///< or Undecided; none are listed then
};

/// Returns the roots in 0 < t <= high of c_0 + c_1 t + ..., whichever numbers between their bounds
/// the coefficients are: by the same search, which gives up where these bounds cannot tell.
///
/// Contract: 2 to kMostDegree + 1 coefficients; high is positive and finite.
CertifiedRoots certified_roots(std::span<const Bounds> ascending, double high);

}  // namespace lamina::poly
