#include "poly/quadratic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"
#include "support/number_types.hpp"
#include "support/reference_surd.hpp"

namespace lamina::poly {
namespace {

using number::Rational;
using reference::Surd;

// Careful: the discriminant is within 3/2 ulp, so within 3 units of roundoff u of itself; its
// root within 3/2 u + u; the sum q of two numbers of one sign within 5/2 u + u; the quotient
// within 7/2 u + u. The rest is for what is of second order.
constexpr int kCarefulBound = 5;

template <typename Number>
class QuadraticTest : public ::testing::Test {
 protected:
  using Traits = number::number_traits<Number>;
  static constexpr int kBits = Traits::kSignificandBits;

  static Rational roundoff() {
    return Rational(1) / Rational(number::Integer(1) << static_cast<unsigned>(kBits));
  }

  // b^2 - ac is 0, or as small as the coefficients can make it, or anything.
  struct Case {
    Number a, b, c;
    std::string kind;
  };
  static Case random_case(base::SeededStream& stream) {
    const auto draw = [&stream] {
      Rational value = Rational(stream.integer(1, 1 << 20)) / (1 << 10);
      return stream.chance(0.5) ? value : Rational(-value);
    };
    Case in;
    in.a = Traits::from_exact(draw());
    in.b = Traits::from_exact(draw());
    if (stream.chance(0.3)) {
      in.c = Traits::from_exact(draw());
      in.kind = "generic";
      return in;
    }
    const Rational b = Traits::to_exact(in.b);
    const Rational near = b * b / Traits::to_exact(in.a);
    in.c = Traits::from_exact(near * (1 + stream.integer(-4, 4) * 2 * roundoff()));
    const Rational d = b * b - Traits::to_exact(in.a) * Traits::to_exact(in.c);
    in.kind = d == 0 ? "touching" : d > 0 ? "nearly touching" : "nearly missing";
    return in;
  }

  // p -+ sqrt(d) / a of the coefficients as they are, ascending.
  static std::vector<Surd> exact_roots(const Case& in) {
    const Rational a = Traits::to_exact(in.a);
    const Rational b = Traits::to_exact(in.b);
    const Rational d = b * b - a * Traits::to_exact(in.c);
    if (d <= 0) {
      return {};
    }
    const Rational q = 1 / Rational(abs(a));
    return {Surd(-b / a, -q, d), Surd(-b / a, q, d)};
  }

  // |t - root| <= bound * u * |root|?
  static bool within(const Number& t, const Surd& root, const Rational& bound) {
    const Rational value = Traits::to_exact(t);
    Rational low = value / (1 + bound * roundoff());
    Rational high = value / (1 - bound * roundoff());
    if (value < 0) {
      std::swap(low, high);
    }
    return compare(Surd(low, 0, 0), root) <= 0 && compare(root, Surd(high, 0, 0)) <= 0;
  }
};
TYPED_TEST_SUITE(QuadraticTest, support::RoundedNumberTypes, support::NumberNames);

TYPED_TEST(QuadraticTest, CarefulRootsKeepTheirBoundNearCancellation) {
  constexpr std::uint64_t kCases = 2000;
  support::ClassTally reached{"generic", "nearly touching", "nearly missing"};
  std::uint64_t plain_wrong = 0;
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("poly/quadratic", 1, case_id);
    const auto in = this->random_case(stream);
    if (in.kind != "touching") {
      reached.add(in.kind);
    }
    const auto truth = this->exact_roots(in);
    const auto roots = quadratic_crossings(in.a, in.b, in.c, Solver::Kahan);
    ASSERT_EQ(roots.count, truth.size()) << in.kind << ", case " << case_id;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      EXPECT_TRUE(this->within(roots.t[i], truth[i], kCarefulBound))
          << in.kind << ", case " << case_id << ", root " << i << ": " << roots.t[i];
    }
    const auto plain = quadratic_crossings(in.a, in.b, in.c, Solver::Textbook);
    bool wrong = plain.count != static_cast<int>(truth.size());
    for (std::size_t i = 0; !wrong && i < truth.size(); ++i) {
      wrong = !this->within(plain.t[i], truth[i], 2 * kCarefulBound);
    }
    plain_wrong += wrong ? 1 : 0;
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 20)) << reached;
  // The textbook's way loses digits or whole pairs here.
  EXPECT_GE(plain_wrong, kCases / 20);
}

// t^2 - 2 B t + 1 with B = 3 * 2^k, k a third of the bits P: the smaller root is 1 / (2B) or so,
// and B - sqrt(B^2 - 1) keeps P - 2k bits of it.
TYPED_TEST(QuadraticTest, PlainLosesTheSmallerRoot) {
  using std::ldexp;
  typename TestFixture::Case in{TypeParam(1), TypeParam(0), TypeParam(1), ""};
  in.b = -ldexp(TypeParam(3), this->kBits / 3);
  const auto truth = this->exact_roots(in);
  const auto careful = quadratic_crossings(in.a, in.b, in.c, Solver::Kahan);
  ASSERT_EQ(careful.count, 2);
  EXPECT_TRUE(this->within(careful.t[0], truth[0], kCarefulBound));
  EXPECT_TRUE(this->within(careful.t[1], truth[1], kCarefulBound));
  const auto plain = quadratic_crossings(in.a, in.b, in.c, Solver::Textbook);
  // At least a quarter of the bits are gone.
  const Rational quarter(number::Integer(1) << static_cast<unsigned>(this->kBits / 4));
  EXPECT_TRUE(plain.count != 2 || !this->within(plain.t[0], truth[0], quarter));
}

// (t + 1/2)(t - 3), and the same with the opposite sign: roots ascend all the same.
TYPED_TEST(QuadraticTest, RootsAscendWhateverTheSigns) {
  using Number = TypeParam;
  for (const auto solver : {Solver::Textbook, Solver::Kahan}) {
    for (const int sign : {1, -1}) {
      const auto roots =
          quadratic_crossings(Number(4 * sign), Number(-5 * sign), Number(-6 * sign), solver);
      ASSERT_EQ(roots.count, 2);
      EXPECT_EQ(roots.t[0], Number(-0.5));
      EXPECT_EQ(roots.t[1], Number(3));
    }
  }
}

TYPED_TEST(QuadraticTest, TouchesAndMissesAreNoCrossings) {
  using Number = TypeParam;
  for (const auto solver : {Solver::Textbook, Solver::Kahan}) {
    EXPECT_EQ(quadratic_crossings(Number(4), Number(-6), Number(9), solver).count, 0);
    EXPECT_EQ(quadratic_crossings(Number(1), Number(0), Number(0), solver).count, 0);
    EXPECT_EQ(quadratic_crossings(Number(1), Number(0), Number(1), solver).count, 0);
  }
}

TYPED_TEST(QuadraticTest, ARootAtZeroIsExact) {
  using Number = TypeParam;
  for (const auto solver : {Solver::Textbook, Solver::Kahan}) {
    for (const int b : {3, -3}) {
      const auto roots = quadratic_crossings(Number(2), Number(b), Number(0), solver);
      ASSERT_EQ(roots.count, 2);
      EXPECT_EQ(roots.t[b > 0 ? 1 : 0], 0);
      EXPECT_EQ(roots.t[b > 0 ? 0 : 1], Number(-b));
    }
  }
}

TYPED_TEST(QuadraticTest, WithoutASquareItIsALineAndWithoutThatNothing) {
  using Number = TypeParam;
  for (const auto solver : {Solver::Textbook, Solver::Kahan}) {
    const auto line = quadratic_crossings(Number(0), Number(2), Number(-12), solver);
    ASSERT_EQ(line.count, 1);
    EXPECT_EQ(line.t[0], Number(3));
    EXPECT_EQ(quadratic_crossings(Number(0), Number(0), Number(5), solver).count, 0);
    EXPECT_EQ(quadratic_crossings(Number(0), Number(0), Number(0), solver).count, 0);
  }
}

TEST(RootFaultTest, LosesOrDoublesOneRootAsOftenAsItSays) {
  constexpr int kTimes = 4000;
  const auto spoiled = [](RootFault::Kind kind, double rate, int i) {
    LineRoots<double> roots;
    for (const double t : {1.0, 2.0, 3.5}) {
      roots.cross(t + i);
    }
    spoil(roots, {kind, rate}, 5);
    return roots;
  };
  for (const auto kind : {RootFault::Kind::None, RootFault::Kind::Drop, RootFault::Kind::Double}) {
    int changed = 0;
    for (int i = 0; i < kTimes; ++i) {
      const LineRoots<double> roots = spoiled(kind, 0.25, i);
      EXPECT_EQ(roots.count, spoiled(kind, 0.25, i).count);
      EXPECT_TRUE(std::is_sorted(roots.t.begin(), roots.t.begin() + roots.count));
      const int off = roots.count - 3;
      EXPECT_TRUE(off == 0 || off == (kind == RootFault::Kind::Drop ? -1 : 1));
      changed += off != 0 ? 1 : 0;
    }
    // Five standard deviations around a quarter.
    const double expected = kind == RootFault::Kind::None ? 0 : 0.25 * kTimes;
    EXPECT_NEAR(changed, expected, kind == RootFault::Kind::None ? 0 : 137);
  }
}

}  // namespace
}  // namespace lamina::poly
