// Real roots by Laguerre's method and synthetic division.
#pragma once

#include "poly/real_roots.hpp"

namespace lamina::poly {

/// Returns the real roots of a polynomial of degree 1 or more: Laguerre's method finds a root,
/// real or complex, from zero on; synthetic division takes it out, a complex one with its
/// conjugate; the quadratic that is left is solved in closed form. Small roots are mostly found
/// first, which is the stable order for this division (Wilkinson 1963).
///
/// A root counts as real if at its real part the polynomial divided so far is below the rounding
/// error of its own evaluation; van Wijk gives no criterion. Of a conjugate pair so near to the
/// axis, mostly both are taken as real, as are the two halves of a double root.
///
/// Error:  none is guaranteed. The roots are those of the divided polynomials, and each division
///         adds its rounding errors: "very sensitive to round-off error" (van Wijk 1984, section
///         7). Roots whose ratio is out of the number type's range may be lost.
/// Source: van Wijk 1984, section 5, after Ralston and Rabinowitz 1978, pp. 380-383.
template <RoundedNumber Number>
RealRoots<Number> laguerre_roots(const Polynomial<Number>& p);

/// The same, with Newton's steps on the undivided polynomial for each real root, while each is at
/// most half of the one before and the root stays on its side of the middle to the next.
///
/// Error:  of a simple root that division has left where Newton's method converges, that of the
///         value by Horner's rule, 2 n u sum |c_i t^i|, divided by the slope. How many roots
///         there are is still what division says.
template <RoundedNumber Number>
RealRoots<Number> laguerre_polished_roots(const Polynomial<Number>& p);

}  // namespace lamina::poly
