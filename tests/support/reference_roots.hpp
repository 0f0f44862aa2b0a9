// An oracle for real roots: FLINT's square-free factors, and the complex roots that Arb certifies.
//
// It shares no code with number::real_roots: from the project it takes GMP's numbers as bare types.
#pragma once

#include <vector>

#include "number/rational.hpp"

namespace lamina::reference {

/// A real root between dyadic bounds, both included.
struct RealRoot {
  number::Rational lower;
  number::Rational upper;
  unsigned multiplicity = 1;
};

/// Returns the distinct real roots, ascending.
///
/// Arguments: ascending   coefficients of 1, t, t^2 ..; leading zeros are allowed.
///            bits        of the bounds, positive.
/// Returns:   certified bounds with upper - lower <= 2^-bits * |root|; those of different roots
///            are disjoint.
/// Throws:    std::invalid_argument for the zero polynomial.
std::vector<RealRoot> real_roots(const std::vector<number::Integer>& ascending, int bits);

}  // namespace lamina::reference
