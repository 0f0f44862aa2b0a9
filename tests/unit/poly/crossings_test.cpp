#include "poly/solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "number/algebraic.hpp"
#include "number/all_numbers.hpp"
#include "support/number_types.hpp"

namespace lamina::poly {
namespace {

using number::parse_rational;
using number::Rational;

template <typename Number>
class QuarticTest : public ::testing::Test {
 protected:
  static std::array<Number, 5> rounded(const std::array<Rational, 5>& exact) {
    std::array<Number, 5> c;
    for (std::size_t i = 0; i < 5; ++i) {
      c[i] = number::number_traits<Number>::from_exact(exact[i]);
    }
    return c;
  }

  // The exact roots of odd multiplicity of the polynomial as this number type holds it.
  static std::vector<number::Root> exact_crossings(const std::array<Number, 5>& c) {
    std::vector<Rational> coefficients;
    for (const Number& value : c) {
      coefficients.push_back(number::number_traits<Number>::to_exact(value));
    }
    auto roots = real_roots(number::with_cleared_denominators(coefficients));
    std::erase_if(roots, [](const number::Root& r) { return r.multiplicity() % 2 == 0; });
    return roots;
  }
};
TYPED_TEST_SUITE(QuarticTest, support::RoundedNumberTypes, support::NumberNames);

// (t-1)(t-2)(t-3)(t-4) and the like: every type holds the coefficients.
TYPED_TEST(QuarticTest, FindsSeparatedRoots) {
  const std::array<TypeParam, 5> c{24, -50, 35, -10, 1};
  for (const auto solver : {Solver::Ferrari, Solver::Monotone}) {
    const auto roots = crossings<TypeParam>(c, solver);
    ASSERT_EQ(roots.count, 4);
    // The roots' condition number is below 2^10 (at t = 3: sum |c_i t^i| / |p'(3) 3| = 840/6).
    const TypeParam bound = number::unit_roundoff<TypeParam>() * 1024;
    for (int i = 0; i < 4; ++i) {
      using std::abs;
      const auto root = static_cast<TypeParam>(i + 1);
      EXPECT_LE(abs(TypeParam(roots.t[i] - root)), TypeParam(bound * root)) << i;
    }
  }
}

TYPED_TEST(QuarticTest, FindsNothingWhereThereIsNothing) {
  const std::array<TypeParam, 5> c{5, 0, 2, 0, 1};
  for (const auto solver : {Solver::Ferrari, Solver::Monotone}) {
    EXPECT_EQ(crossings<TypeParam>(c, solver).count, 0);
  }
}

TYPED_TEST(QuarticTest, LowersTheDegreeOfLeadingZeros) {
  const std::array<TypeParam, 5> cubic{-6, 11, -6, 1, 0};
  const std::array<TypeParam, 5> line{-6, 2, 0, 0, 0};
  const std::array<TypeParam, 5> constant{3, 0, 0, 0, 0};
  const std::array<TypeParam, 5> zero{};
  for (const auto solver : {Solver::Ferrari, Solver::Monotone}) {
    EXPECT_EQ(crossings<TypeParam>(cubic, solver).count, 3);
    const auto root = crossings<TypeParam>(line, solver);
    ASSERT_EQ(root.count, 1);
    EXPECT_EQ(root.t[0], 3);
    EXPECT_EQ(crossings<TypeParam>(constant, solver).count, 0);
    EXPECT_EQ(crossings<TypeParam>(zero, solver).count, 0);
  }
}

// A published trap: float solvers by Sturm sequences find a root, and there is none.
TYPED_TEST(QuarticTest, RootlessTrapHasNoRoot) {
  const auto c = this->rounded({parse_rational("9627.17676"), parse_rational("-660.766052"),
                                parse_rational("0.00329589844"), 0, 1});
  // Its minimum is some thousands of units of 1, so that rounding the coefficients keeps it.
  ASSERT_TRUE(this->exact_crossings(c).empty());
  EXPECT_EQ(crossings<TypeParam>(c, Solver::Monotone).count, 0);
  EXPECT_EQ(crossings<TypeParam>(c, Solver::Ferrari).count, 0);
}

// Another: solvers in the field return none, and there are two, at 60 -+ 9.35. There the terms
// add up to 2e8 in magnitude and the slope is 7.5e4, so that an error of 8 units of roundoff in
// the value moves a root by 8 * 2e8 / 7.5e4 = 2e4 units. (Eleven bits hold other coefficients.)
TYPED_TEST(QuarticTest, TwoRootTrapHasTwoRoots) {
  const auto c = this->rounded({parse_rational("26471900.25"), -1325880, 25449, -240, 1});
  const auto truth = this->exact_crossings(c);
  if (number::number_traits<TypeParam>::kSignificandBits < 24) {
    for (const auto solver : {Solver::Monotone, Solver::Ferrari}) {
      EXPECT_EQ(crossings<TypeParam>(c, solver).count % 2, 0);  // pairs may be lost, parity not
    }
    return;
  }
  ASSERT_EQ(truth.size(), 2U);
  const double bound = std::ldexp(2e4, -number::number_traits<TypeParam>::kSignificandBits);
  for (const auto solver : {Solver::Monotone, Solver::Ferrari}) {
    const auto roots = crossings<TypeParam>(c, solver);
    ASSERT_EQ(roots.count, truth.size());
    // The closed form has no bound; the other one keeps the derived one.
    const double allowed = solver == Solver::Monotone ? bound : 100 * bound;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Rational t = number::number_traits<TypeParam>::to_exact(roots.t[i]);
      const auto exact = enclosure(truth[i], 300);
      EXPECT_LE(number::nearest_double(Rational(abs(t - exact.lower))), allowed) << i;
    }
  }
}

}  // namespace
}  // namespace lamina::poly
