// Real roots in a range by Descartes' rule of signs in the Bernstein basis.
#pragma once

#include "poly/real_roots.hpp"

namespace lamina::poly {

/// Returns the real roots in the range. In the Bernstein basis of an interval a polynomial has at
/// most as many roots as its coefficients have sign changes, and at least one if they have an odd
/// number (Lane and Riesenfeld 1981): intervals without are dropped, most of them before any
/// arithmetic is done on their inside; those with one are searched by Halley's steps on the power
/// basis, from where the control polygon crosses zero; others are halved (de Casteljau). The
/// "rectangle test and subdivision" of van Wijk 1984, section 7, is this in one dimension.
///
/// Error:  each simple root to the last bit of the value by Horner's rule, 2 n u sum |c_i t^i|,
///         whatever power of two the coefficients are multiplied by. Where the value on an
///         interval is nowhere above the rounding error of its coefficients, one root of even or
///         odd multiplicity (2 or 3) is given for all that may be there: two roots so close are
///         not told from none.
template <RoundedNumber Number>
RealRoots<Number> bernstein_roots(const Polynomial<Number>& p, const Range<Number>& range);

}  // namespace lamina::poly
