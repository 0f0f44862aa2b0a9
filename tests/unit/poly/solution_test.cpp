#include "poly/solution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lamina::poly {
namespace {

using number::Integer;
using number::Rational;

// (t - 1)^2 (t^2 - 2) and a range that ends at its roots.
TEST(SolutionTest, ExactRootsKeepToTheRangeAndItsEnds) {
  const std::vector<Rational> c{-2, 4, -1, -2, 1};
  const auto all = exact_roots(c, {});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].multiplicity(), 2U);
  const auto some = exact_roots(c, {Rational(1), Rational(7, 5)});
  ASSERT_EQ(some.size(), 1U);
  EXPECT_EQ(some[0].multiplicity(), 2U);
}

// (t - a)(t - b)(t - c) with roots that double cannot tell apart.
TEST(SolutionTest, IsolatingIntervalsAreApartAndHoldTheirRoots) {
  const Rational tiny(Integer(1), Integer(1) << 100);
  const std::vector<Rational> roots{Rational(1, 3), Rational(1, 3) + tiny, 2};
  std::vector<Rational> c{1};
  for (const Rational& root : roots) {
    c.insert(c.begin(), Rational(0));
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
      c[i] -= root * c[i + 1];
    }
  }
  const auto intervals = isolating_intervals(exact_roots(c, {}));
  ASSERT_EQ(intervals.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(intervals[i].lower, roots[i]);
    EXPECT_LE(roots[i], intervals[i].upper);
    EXPECT_TRUE(i == 0 || intervals[i - 1].upper < intervals[i].lower);
  }
}

// The units in the last place of 3/2 and of the square root of two are 2^-52, of 3 2^-51.
TEST(SolutionTest, ErrorsAreInUnitsOfTheRoot) {
  const Rational unit(Integer(1), Integer(1) << 52);
  const auto three_halves = known(exact_roots({Rational(-3, 2), 1}, {}), 53);
  ASSERT_EQ(three_halves.size(), 1U);
  EXPECT_EQ(error_ulps(Rational(3, 2), three_halves[0]), 0);
  EXPECT_EQ(error_ulps(Rational(3, 2) + 5 * unit, three_halves[0]), 5);
  const auto three = known(exact_roots({-3, 1}, {}), 53);
  EXPECT_EQ(error_ulps(3 - 4 * unit, three[0]), 2);
  const auto surd = known(exact_roots({-2, 0, 1}, {Rational(0), {}}), 53);
  ASSERT_EQ(surd.size(), 1U);
  const double nearest = std::sqrt(2.0);  // correctly rounded: off by 0.4 units or so
  EXPECT_LE(error_ulps(Rational(nearest), surd[0]), 0.5);
  EXPECT_NEAR(error_ulps(Rational(std::nextafter(nearest, 2)), surd[0]) +
                  error_ulps(Rational(std::nextafter(nearest, 1)), surd[0]),
              2, 1e-9);
  const auto zero = known(exact_roots({0, 1}, {}), 53);
  EXPECT_EQ(error_ulps(Rational(0), zero[0]), 0);
  EXPECT_EQ(error_ulps(unit, zero[0]), std::numeric_limits<double>::infinity());
}

TEST(SolutionTest, SolvesWhatTheNumberTypeHolds) {
  // 1/3 is no float: the root of t - 1/3 is the float nearest to it.
  const Solution solution = solve<float>({Rational(-1, 3), 1}, {}, Solver::Exact);
  ASSERT_EQ(solution.roots.size(), 1U);
  EXPECT_EQ(solution.roots[0].t, Rational(1.0F / 3.0F));
  EXPECT_EQ(solution.roots[0].multiplicity, 1);
  EXPECT_EQ(solve<float>({number::parse_rational("1e50"), 1}, {}, Solver::Exact).outcome,
            Outcome::NotFinite);
}

}  // namespace
}  // namespace lamina::poly
