// Polynomials through a root finder in some number type, exact numbers in and out.
#pragma once

#include <optional>
#include <vector>

#include "number/algebraic.hpp"
#include "poly/solver.hpp"

namespace lamina::poly {

/// A closed interval of the line; no end where none is given.
struct ExactRange {
  std::optional<number::Rational> low;
  std::optional<number::Rational> high;
};

/// Returns the distinct real roots in the range, ascending. Exact. Contract: not all coefficients
/// are zero.
std::vector<number::Root> exact_roots(const std::vector<number::Rational>& ascending,
                                      const ExactRange& range);

/// Bounds that lie apart from those of the neighbouring roots, if only just so many bits.
std::vector<number::Enclosure> isolating_intervals(const std::vector<number::Root>& ascending);

/// An exact root, written down so closely that errors of numbers with so many bits can be told.
struct KnownRoot {
  number::Rational t;  ///< within 2^-42 units in the last place
  int unit = 0;        ///< such a unit is 2^unit; of no meaning where t is zero
  unsigned multiplicity = 1;
};
std::vector<KnownRoot> known(const std::vector<number::Root>& roots, int significand_bits);

/// Returns |t - root| in units in the last place of the root, to 2^-40 units; infinity where the
/// root is zero and t is not.
double error_ulps(const number::Rational& t, const KnownRoot& root);

struct Solution {
  struct Root {
    number::Rational t;
    int multiplicity = 0;  ///< 0 where the solver cannot know it
  };
  std::vector<Root> roots;  ///< ascending; equal ones stand twice
  Outcome outcome = Outcome::Found;
};

/// Rounds the coefficients and the ends of the range to the number type, and solves what they
/// are then. Contract: as real_roots has it.
template <RoundedNumber Number>
Solution solve(const std::vector<number::Rational>& ascending, const ExactRange& range,
               Solver solver);

/// Returns the seconds that one pass over polynomials takes, without rounding their coefficients.
/// The ranges are as many.
template <RoundedNumber Number>
double seconds_to_solve(const std::vector<std::vector<number::Rational>>& polynomials,
                        const std::vector<ExactRange>& ranges, Solver solver);

}  // namespace lamina::poly
