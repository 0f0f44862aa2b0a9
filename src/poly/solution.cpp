#include "poly/solution.hpp"

#include <chrono>
#include <cstdlib>
#include <limits>

#include "number/all_numbers.hpp"

namespace lamina::poly {
namespace {

using number::Enclosure;
using number::Integer;
using number::Rational;

Integer floor(const Rational& x) {
  const Integer quotient = numerator(x) / denominator(x);
  return quotient * denominator(x) > numerator(x) ? Integer(quotient - 1) : quotient;
}

// The narrowest bounds around these that are multiples of 2^-bits.
Enclosure outwards(const Enclosure& bounds, int bits) {
  const Integer scale = Integer(1) << static_cast<unsigned>(bits);
  return {Rational(floor(bounds.lower * scale), scale),
          Rational(-floor(-bounds.upper * scale), scale)};
}

Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

// Of the highest bit: 2^exponent <= |x| < 2^(exponent + 1). Contract: x is not zero.
int exponent(const Rational& x) {
  const Rational size = abs(x);
  const int near =
      static_cast<int>(msb(numerator(size))) - static_cast<int>(msb(denominator(size)));
  return size < power_of_two(near) ? near - 1 : near;
}

}  // namespace

std::vector<number::Root> exact_roots(const std::vector<Rational>& ascending,
                                      const ExactRange& range) {
  std::vector<number::Root> roots =
      number::real_roots(number::with_cleared_denominators(ascending));
  std::erase_if(roots, [&range](const number::Root& root) {
    return (range.low && compare(root, *range.low) < 0) ||
           (range.high && compare(root, *range.high) > 0);
  });
  return roots;
}

std::vector<Enclosure> isolating_intervals(const std::vector<number::Root>& ascending) {
  constexpr int kFirstBits = 4;
  for (int bits = kFirstBits;; bits += kFirstBits) {
    std::vector<Enclosure> intervals;
    bool apart = true;
    for (const number::Root& root : ascending) {
      intervals.push_back(outwards(enclosure(root, bits), bits));
      const std::size_t last = intervals.size() - 1;
      apart = apart && (last == 0 || intervals[last - 1].upper < intervals[last].lower);
    }
    if (apart) {
      return intervals;
    }
  }
}

std::vector<KnownRoot> known(const std::vector<number::Root>& roots, int significand_bits) {
  constexpr int kMoreBits = 42;
  std::vector<KnownRoot> all;
  for (const number::Root& root : roots) {
    if (compare(root, Rational(0)) == 0) {
      all.push_back({Rational(0), 0, root.multiplicity()});
      continue;
    }
    // The bits of an enclosure are relative to roots above 2^-bits: more for those below.
    Rational t = 0;
    for (int bits = significand_bits + kMoreBits;; bits *= 2) {
      const Enclosure bounds = enclosure(root, bits);
      t = bounds.lower;
      if (abs(t) > power_of_two(1 - bits)) {
        break;
      }
    }
    all.push_back({t, exponent(t) - significand_bits + 1, root.multiplicity()});
  }
  return all;
}

double error_ulps(const Rational& t, const KnownRoot& root) {
  if (root.t == 0) {
    return t == 0 ? 0 : std::numeric_limits<double>::infinity();
  }
  return number::nearest_double(abs(t - root.t) / power_of_two(root.unit));
}

namespace {

template <RoundedNumber Number>
struct RoundedProblem {
  std::vector<Number> ascending;
  Range<Number> range;

  RoundedProblem(const std::vector<Rational>& exact, const ExactRange& ends) {
    using Traits = number::number_traits<Number>;
    ascending.reserve(exact.size());
    for (const Rational& c : exact) {
      ascending.push_back(Traits::from_exact(c));
    }
    range.low = ends.low ? Traits::from_exact(*ends.low) : range.low;
    range.high = ends.high ? Traits::from_exact(*ends.high) : range.high;
  }

  [[nodiscard]] RealRoots<Number> solve(Solver solver) const {
    return real_roots(std::span<const Number>(ascending), range, solver);
  }
};

}  // namespace

template <RoundedNumber Number>
Solution solve(const std::vector<Rational>& ascending, const ExactRange& range, Solver solver) {
  const RealRoots<Number> found = RoundedProblem<Number>(ascending, range).solve(solver);
  Solution solution;
  solution.outcome = found.outcome;
  for (int i = 0; i < found.count; ++i) {
    solution.roots.push_back(
        {number::number_traits<Number>::to_exact(found.t[i]), found.multiplicity[i]});
  }
  return solution;
}

template <RoundedNumber Number>
double seconds_to_solve(const std::vector<std::vector<Rational>>& polynomials,
                        const std::vector<ExactRange>& ranges, Solver solver) {
  std::vector<RoundedProblem<Number>> problems;
  for (std::size_t i = 0; i < polynomials.size(); ++i) {
    problems.emplace_back(polynomials[i], ranges[i]);
  }
  const auto start = std::chrono::steady_clock::now();
  // What is found must be used, or the compiler may leave it out.
  [[maybe_unused]] volatile int found = 0;
  for (const RoundedProblem<Number>& problem : problems) {
    found = problem.solve(solver).count;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

#define LAMINA_INSTANTIATE(Number)                                                          \
  template Solution solve<Number>(const std::vector<Rational>&, const ExactRange&, Solver); \
  template double seconds_to_solve<Number>(const std::vector<std::vector<Rational>>&,       \
                                           const std::vector<ExactRange>&, Solver);
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::poly
