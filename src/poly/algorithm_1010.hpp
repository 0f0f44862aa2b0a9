// ACM's algorithm 1010 for quartic equations, in rounded arithmetic.
#pragma once

#include "poly/real_roots.hpp"

namespace lamina::poly {

/// Returns the real roots of a quartic, from its factorisation in two real quadratics: closed
/// forms for the factors, of several the one that reproduces the quartic best, then Newton's
/// method on their coefficients, and Kahan's discriminant. None where the quadratics are complex.
///
/// Multiplicity: 2 where the discriminant of a factor is exactly zero; both factors being equal
///         doubles it (a simple root of both has 2); else not known.
/// Error:  each root is one of a quartic whose coefficients differ by some units of roundoff, so
///         off by as many where roots are separated, whatever their ratios; close ones move by
///         the root of that, and a pair may be invented or dropped. More only where the ratio of
///         roots underflows.
/// Source: A. Orellana and C. De Michele, "Algorithm 1010: Boosting Efficiency in Solving Quartic
///         Equations with No Compromise in Accuracy", ACM TOMS 46(2), 2020. What differs: the
///         quartic is always scaled; the root of the resolvent cubic comes from Newton's monotone
///         steps, so that + - * / and sqrt are all that is used; coefficients that are small by
///         cancellation weigh less in the errors compared; and Newton's steps are followed by the
///         same mending as the first factors, with one formula more for the constant terms.
template <RoundedNumber Number>
RealRoots<Number> algorithm_1010_roots(const Polynomial<Number>& p);

}  // namespace lamina::poly
