// Real roots in a range by Sturm's theorem.
#pragma once

#include "poly/real_roots.hpp"

namespace lamina::poly {

/// Returns the distinct real roots in the range of a polynomial of degree 1 or more. The sign
/// changes of Sturm's sequence count the roots of an interval; halving leaves one in each; where
/// the polynomial has different signs at the ends, regula falsi (Illinois) finds it to
/// neighbouring numbers, and where it has not, a root of even multiplicity, halving goes on to
/// these. Van Wijk 1984, section 7, prefers this to finding all complex roots.
///
/// Error:  a root found by signs has that of the value by Horner's rule, 2 n u sum |c_i t^i|,
///         divided by the slope. The counts have no bound: the sequence comes from a Euclidean
///         division that cancels where roots are close, the complex ones too, and a sign gone
///         wrong in it loses roots or makes some where there are none.
/// Source: Sturm 1829; Hanrahan 1983 for rays.
template <RoundedNumber Number>
RealRoots<Number> sturm_roots(const Polynomial<Number>& p, const Range<Number>& range);

}  // namespace lamina::poly
