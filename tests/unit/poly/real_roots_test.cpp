#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/contract.hpp"
#include "number/all_numbers.hpp"
#include "poly/solver.hpp"
#include "support/number_types.hpp"

namespace lamina::poly {
namespace {

template <typename Number>
class RealRootsTest : public ::testing::Test {
 protected:
  using Roots = RealRoots<Number>;

  static Roots solve(const std::vector<Number>& ascending, Solver solver,
                     const Range<Number>& range = {}) {
    return real_roots(std::span<const Number>(ascending), range, solver);
  }

  // Every solver that takes this degree, by name in failures.
  template <typename Check>
  static void for_each(int degree, const Check& check) {
    for (const SolverInfo& info : all_solvers()) {
      if (fits(info.solver, degree)) {
        SCOPED_TRACE(std::string(info.name));
        check(info.solver);
      }
    }
  }
};
TYPED_TEST_SUITE(RealRootsTest, support::RoundedNumberTypes, support::NumberNames);

TYPED_TEST(RealRootsTest, DefinesWhatHasNoRoots) {
  using Number = TypeParam;
  const Number infinity = std::numeric_limits<Number>::infinity();
  const Number nan = std::numeric_limits<Number>::quiet_NaN();
  for (const int degree : {2, 3, 4, 10}) {
    this->for_each(degree, [&](Solver solver) {
      std::vector<Number> c(degree + 1, Number(0));
      EXPECT_EQ(this->solve(c, solver).outcome, Outcome::Everywhere);
      EXPECT_EQ(this->solve(c, solver).count, 0);
      c[0] = 3;
      EXPECT_EQ(this->solve(c, solver).outcome, Outcome::Found);
      EXPECT_EQ(this->solve(c, solver).count, 0);
      for (const Number& bad : {infinity, Number(-infinity), nan}) {
        c[1] = bad;
        EXPECT_EQ(this->solve(c, solver).outcome, Outcome::NotFinite);
        EXPECT_EQ(this->solve(c, solver).count, 0);
      }
    });
  }
}

TYPED_TEST(RealRootsTest, LeadingZerosLowerTheDegree) {
  using Number = TypeParam;
  for (const int degree : {2, 3, 4, 10}) {
    this->for_each(degree, [&](Solver solver) {
      std::vector<Number> line(degree + 1, Number(0));
      line[0] = -6;
      line[1] = 2;
      const auto root = this->solve(line, solver);
      ASSERT_EQ(root.count, 1);
      EXPECT_EQ(root.t[0], 3);
      EXPECT_EQ(root.multiplicity[0], 1);
      if (degree > 2) {  // (t - 1)(t - 2)
        std::vector<Number> quadratic(degree + 1, Number(0));
        quadratic[0] = 2;
        quadratic[1] = -3;
        quadratic[2] = 1;
        const auto roots = this->solve(quadratic, solver, {Number(0), Number(4)});
        ASSERT_EQ(roots.count, 2);
        using std::abs;
        EXPECT_LE(abs(Number(roots.t[0] - 1)), 16 * number::unit_roundoff<Number>());
        EXPECT_LE(abs(Number(roots.t[1] - 2)), 32 * number::unit_roundoff<Number>());
      }
    });
  }
}

// (t + 2)(t - 1)(t - 3)(t - 5) has one root in [0, 2], none in [6, 9], and three in [0, infinity].
TYPED_TEST(RealRootsTest, KeepsToTheRange) {
  using Number = TypeParam;
  const std::vector<Number> c{-30, 31, 5, -7, 1};
  const Number infinity = std::numeric_limits<Number>::infinity();
  this->for_each(4, [&](Solver solver) {
    const auto one = this->solve(c, solver, {Number(0), Number(2)});
    ASSERT_EQ(one.count, 1);
    EXPECT_TRUE(2 * one.t[0] < 3);
    EXPECT_TRUE(2 * one.t[0] > 1);
    EXPECT_EQ(this->solve(c, solver, {Number(6), Number(9)}).count, 0);
    EXPECT_EQ(this->solve(c, solver, {Number(9), Number(6)}).count, 0);
    EXPECT_EQ(this->solve(c, solver, {Number(0), infinity}).count, 3);
    EXPECT_EQ(this->solve(c, solver, {-infinity, Number(0)}).count, 1);
    EXPECT_EQ(this->solve(c, solver).count, 4);
  });
}

// A certified solver may say that it cannot tell; the others find what they find. No coefficient
// that there is makes a NaN, a root outside the range, or another order.
TYPED_TEST(RealRootsTest, NeverBreaksItsPromises) {
  using Number = TypeParam;
  using Limits = std::numeric_limits<Number>;
  using std::ldexp;
  // The exponents of software floats go to 2^31, which no exact number should have.
  const int exponent = static_cast<int>(std::min<long>(Limits::max_exponent - 1, 1022));
  const Number huge = ldexp(Number(2 - Limits::epsilon()), exponent);
  const Number tiny = ldexp(Number(1), -exponent);
  const std::vector<Number> values{0,     1,    -1,    Number(3) / 7,    huge,
                                   -huge, tiny, -tiny, Limits::epsilon()};
  const std::vector<Range<Number>> ranges{
      {}, {Number(0), Number(1)}, {Number(-1), huge}, {Number(1), Number(1)}};
  std::uint64_t solved = 0;
  for (std::size_t first = 0; first < values.size(); ++first) {
    for (std::size_t step = 0; step < values.size(); ++step) {
      for (const int degree : {2, 3, 4, 6}) {
        std::vector<Number> c;
        for (int i = 0; i <= degree; ++i) {
          c.push_back(values[(first + i * step + i * i) % values.size()]);
        }
        const Range<Number>& range = ranges[(first + step) % ranges.size()];
        this->for_each(degree, [&](Solver solver) {
          const bool slow =
              solver == Solver::Exact ||
              (solver == Solver::Certified && number::number_traits<Number>::kSignificandBits > 53);
          if (slow && (first + step) % 8 != 0) {
            return;  // they would take most of the time, and have tests of their own
          }
          const auto roots = this->solve(c, solver, range);
          ASSERT_LE(roots.count, degree);
          for (int i = 0; i < roots.count; ++i) {
            EXPECT_TRUE(range.contains(roots.t[i]));
            EXPECT_TRUE(roots.t[i] - roots.t[i] == 0);
            EXPECT_TRUE(i == 0 || roots.t[i - 1] <= roots.t[i]);
          }
          ++solved;
        });
      }
    }
  }
  EXPECT_GT(solved, 2000U);
}

TEST(SolverTest, HasANameAndARangeOfDegreesForEach) {
  int place = 0;
  for (const SolverInfo& info : all_solvers()) {
    EXPECT_EQ(static_cast<int>(info.solver), place++);
    EXPECT_EQ(parse_solver(info.name), info.solver);
    EXPECT_EQ(&solver_info(info.solver), &info);
    EXPECT_FALSE(fits(info.solver, kMostDegree + 1));
  }
  for (int degree = 2; degree <= kMostDegree; ++degree) {
    EXPECT_TRUE(fits(default_solver(degree), degree));
  }
  EXPECT_THROW((void)parse_solver("newton"), base::InputError);
}

// The errors that the header states, as far as a closed form shows them: roots 1 and 2^k of
// t^2 - (1 + 2^k) t + 2^k. The textbook's smaller root has lost the digits that b and the square
// root share.
TYPED_TEST(RealRootsTest, StableFormulasKeepTheSmallRoot) {
  using Number = TypeParam;
  const int k = number::number_traits<Number>::kSignificandBits - 2;
  using std::ldexp;
  const Number large = ldexp(Number(1), k);
  const std::vector<Number> c{large, -(1 + large), 1};
  for (const Solver solver : {Solver::Stable, Solver::Kahan}) {
    const auto roots = this->solve(c, solver);
    ASSERT_EQ(roots.count, 2);
    using std::abs;
    EXPECT_LE(abs(Number(roots.t[0] - 1)), 5 * number::unit_roundoff<Number>());
  }
  const auto textbook = this->solve(c, Solver::Textbook);
  ASSERT_EQ(textbook.count, 2);
  EXPECT_EQ(textbook.t[1], large);
}

}  // namespace
}  // namespace lamina::poly
