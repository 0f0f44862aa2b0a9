#include "number/algebraic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"

namespace lamina::number {
namespace {

using base::SeededStream;

IntegerPolynomial polynomial(std::vector<long> ascending) {
  return IntegerPolynomial(std::vector<Integer>(ascending.begin(), ascending.end()));
}

// The product of (q_i t - p_i) over rationals p_i/q_i.
IntegerPolynomial with_roots(const std::vector<Rational>& roots) {
  std::vector<Integer> product{1};
  for (const Rational& root : roots) {
    std::vector<Integer> next(product.size() + 1, Integer(0));
    for (std::size_t i = 0; i < product.size(); ++i) {
      next[i] -= numerator(root) * product[i];
      next[i + 1] += denominator(root) * product[i];
    }
    product = std::move(next);
  }
  return IntegerPolynomial(std::move(product));
}

IntegerPolynomial product_of(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> product(static_cast<std::size_t>(a.degree() + b.degree() + 1), Integer(0));
  for (std::size_t i = 0; i < a.coefficients().size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients().size(); ++j) {
      product[i + j] += a[i] * b[j];
    }
  }
  return IntegerPolynomial(std::move(product));
}

TEST(IntegerPolynomialTest, DropsLeadingZerosAndKnowsSigns) {
  const IntegerPolynomial p = polynomial({-2, 0, 1, 0, 0});
  EXPECT_EQ(p.degree(), 2);
  EXPECT_EQ(p.sign_at(Rational(1)), -1);
  EXPECT_EQ(p.sign_at(Rational(-2)), 1);
  EXPECT_EQ(p.sign_at(Rational(3, 2)), 1);
  EXPECT_EQ(p.sign_at_minus_infinity(), 1);
  EXPECT_EQ(polynomial({0, 0, 0, 1}).sign_at_minus_infinity(), -1);
  EXPECT_EQ(polynomial({0}).degree(), -1);
  EXPECT_EQ(polynomial({0}).sign_at_minus_infinity(), 0);
}

TEST(RealRootsTest, KnowsMultiplicitiesInEveryDegree) {
  const auto multiplicities = [](const IntegerPolynomial& p) {
    std::vector<unsigned> result;
    for (const Root& root : real_roots(p)) {
      result.push_back(root.multiplicity());
    }
    return result;
  };
  using Counts = std::vector<unsigned>;
  EXPECT_EQ(multiplicities(polynomial({3})), Counts{});
  EXPECT_EQ(multiplicities(polynomial({-1, 3})), Counts{1});
  EXPECT_EQ(multiplicities(polynomial({1, -2, 1})), Counts{2});
  EXPECT_EQ(multiplicities(polynomial({1, 0, 1})), Counts{});
  EXPECT_EQ(multiplicities(polynomial({0, 0, 0, 1})), Counts{3});
  EXPECT_EQ(multiplicities(with_roots({1, 1, 2, 3})), (Counts{2, 1, 1}));
  EXPECT_EQ(multiplicities(product_of(polynomial({-2, 0, 1}), polynomial({-2, 0, 1}))),
            (Counts{2, 2}));
  EXPECT_THROW(real_roots(polynomial({0})), std::logic_error);
}

// sqrt(2) as a root of degree 2, 4 and 6, and the rational next to it, in one order.
TEST(CompareTest, AgreesAcrossKindsOfRoots) {
  const IntegerPolynomial square = polynomial({-2, 0, 1});
  const Root by_degree_2 = real_roots(square).at(1);
  const Root by_degree_4 = real_roots(product_of(square, polynomial({-3, 0, 1}))).at(2);
  const Root by_degree_6 =
      real_roots(product_of(product_of(square, square), polynomial({1, 0, 1}))).at(1);
  EXPECT_TRUE(compare(by_degree_2, by_degree_4) == 0);
  EXPECT_TRUE(compare(by_degree_4, by_degree_6) == 0);
  EXPECT_TRUE(compare(by_degree_6, by_degree_2) == 0);
  const Rational below = parse_rational("1.41421356237309504880168872420969807856967187537694");
  const Rational above = parse_rational("1.41421356237309504880168872420969807856967187537695");
  for (const Root& root : {by_degree_2, by_degree_4, by_degree_6}) {
    EXPECT_TRUE(compare(root, below) > 0);
    EXPECT_TRUE(compare(root, above) < 0);
    EXPECT_TRUE(compare(Root(below), root) < 0);
    EXPECT_TRUE(compare(Root(above), root) > 0);
    EXPECT_EQ(nearest_double(root), std::sqrt(2.0));
    EXPECT_EQ(sign_at(square, root), 0);
    EXPECT_EQ(sign_at(polynomial({-2, 0, 0, 1}), root), 1);
    EXPECT_EQ(sign_at(polynomial({3, 0, -1}), root), 1);
    EXPECT_TRUE(compare(affine_image(root, 2, -1), Rational(2 * below - 1)) > 0);
    EXPECT_TRUE(compare(affine_image(root, 2, -1), Rational(2 * above - 1)) < 0);
  }
}

// Quadratics that share a root, that are 10^-k apart, or have nothing to do with each other.
// The truth is integer arithmetic on r + s sqrt(d): no code of the class.
TEST(CompareTest, OrdersQuadraticSurdsExactly) {
  // Sign of a + b sqrt(d), d > 0 not a square.
  const auto sign_of_surd = [](const Rational& a, const Rational& b, const Rational& d) {
    if (a.sign() * b.sign() >= 0) {
      return a.sign() != 0 ? a.sign() : b.sign();
    }
    const int larger = Rational(a * a).compare(Rational(b * b * d));
    return larger > 0 ? a.sign() : larger < 0 ? b.sign() : 0;
  };
  support::ClassTally reached({"equal", "close", "far"});
  for (std::uint64_t case_id = 0; case_id < 3000; ++case_id) {
    SeededStream stream("number/surds", 1, case_id);
    const Rational d(stream.integer(2, 50) * stream.integer(1, 7));
    if (mpz_perfect_square_p(Integer(numerator(d)).backend().data()) != 0) {
      continue;
    }
    const Rational a1(stream.integer(-50, 50), stream.integer(1, 9));
    const Rational b1(stream.integer(1, 9), stream.integer(1, 9));
    Rational a2 = a1;
    Rational b2 = b1;
    const std::uint64_t kind = stream.below(3);
    if (kind == 1) {
      a2 += Rational(1, Integer(boost::multiprecision::pow(
                            Integer(10), static_cast<unsigned>(stream.below(40)))));
    } else if (kind == 2) {
      a2 = Rational(stream.integer(-50, 50), 3);
      b2 = Rational(stream.integer(1, 9), 2);
    }
    // (t - a)^2 = b^2 d
    const auto root = [&](const Rational& a, const Rational& b, std::size_t index, bool scaled) {
      const Rational factor = scaled ? Rational(-3, 7) : Rational(1);
      return real_roots(with_cleared_denominators({Rational(factor * (a * a - b * b * d)),
                                                   Rational(factor * -2 * a), factor}))
          .at(index);
    };
    for (const std::size_t index : {0U, 1U}) {
      const Rational side = index == 0 ? -1 : 1;
      const int truth = sign_of_surd(a1 - a2, Rational(side * (b1 - b2)), d);
      const auto order = compare(root(a1, b1, index, false), root(a2, b2, index, true));
      EXPECT_EQ(order < 0 ? -1 : order > 0 ? 1 : 0, truth) << "case " << case_id;
    }
    reached.add(kind == 0 ? "equal" : kind == 1 ? "close" : "far");
  }
  EXPECT_TRUE(reached.each_at_least(500)) << reached;
}

// Roots with known rational values in products of degree 4: order, enclosures, doubles.
TEST(RealRootsTest, FindsKnownRationalRootsOfQuartics) {
  for (std::uint64_t case_id = 0; case_id < 300; ++case_id) {
    SeededStream stream("number/quartics", 1, case_id);
    std::vector<Rational> known;
    while (known.size() < 4) {
      Rational value(stream.integer(-1000, 1000), stream.integer(1, 1000));
      if (!known.empty() && stream.chance(0.3)) {
        value = known.back() + Rational(1, Integer(1) << static_cast<unsigned>(stream.below(90)));
      }
      known.push_back(value);
    }
    std::sort(known.begin(), known.end());
    std::vector<Rational> distinct = known;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    const std::vector<Root> roots = real_roots(with_roots(known));
    ASSERT_EQ(roots.size(), distinct.size()) << "case " << case_id;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      EXPECT_TRUE(compare(roots[i], distinct[i]) == 0);
      EXPECT_EQ(roots[i].multiplicity(), std::count(known.begin(), known.end(), distinct[i]));
      EXPECT_LE(Rational(roots[i].lower()), distinct[i]);
      EXPECT_GE(Rational(roots[i].upper()), distinct[i]);
      EXPECT_EQ(nearest_double(roots[i]), nearest_double(distinct[i]));
      const Enclosure narrow = enclosure(roots[i], 200);
      EXPECT_LE(narrow.lower, distinct[i]);
      EXPECT_GE(narrow.upper, distinct[i]);
      for (std::size_t j = 0; j < distinct.size(); ++j) {
        EXPECT_EQ(compare(roots[i], Root(distinct[j])) < 0, i < j);
      }
    }
  }
}

// Irrational quartic roots: t = sqrt(a + sqrt(b)) has t^4 - 2 a t^2 + a^2 - b = 0.
TEST(RealRootsTest, EnclosesNestedSquareRoots) {
  for (std::uint64_t case_id = 0; case_id < 200; ++case_id) {
    SeededStream stream("number/nested", 1, case_id);
    const long a = stream.integer(30, 1'000'000);
    const long b = stream.integer(2, 800);
    const std::vector<Root> roots = real_roots(polynomial({a * a - b, 0, -2 * a, 0, 1}));
    ASSERT_EQ(roots.size(), 4U);
    for (const Root& root : roots) {
      EXPECT_LE(root.upper() - root.lower(), 64 * std::abs(root.upper()) * 0x1p-52);
      const Enclosure narrow = enclosure(root, 150);
      EXPECT_LE((narrow.upper - narrow.lower) * Rational(Integer(1) << 150U),
                Rational(abs(narrow.upper)) * 2);
      // (t^2 - a)^2 - b changes sign between the bounds.
      const auto value = [&](const Rational& t) {
        return Rational((t * t - a) * (t * t - a) - b).sign();
      };
      EXPECT_LE(value(narrow.lower) * value(narrow.upper), 0);
      const double nearest = nearest_double(root);
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      const Rational low = (Rational(nearest) + Rational(std::nextafter(nearest, -kInfinity))) / 2;
      const Rational high = (Rational(nearest) + Rational(std::nextafter(nearest, kInfinity))) / 2;
      EXPECT_TRUE(compare(root, low) >= 0 && compare(root, high) <= 0);
    }
  }
}

TEST(EnclosureTest, IsNarrowBesideZero) {
  // Roots -+ 10^-30: far from 1 in size, and the two are 2e-30 apart.
  const Integer large = boost::multiprecision::pow(Integer(10), 60U) - 1;
  const std::vector<Root> roots =
      real_roots(IntegerPolynomial({Integer(-1), Integer(0), Integer(large)}));
  ASSERT_EQ(roots.size(), 2U);
  const Enclosure narrow = enclosure(roots[1], 100);
  EXPECT_GT(narrow.lower, 0);
  EXPECT_LE((narrow.upper - narrow.lower) * Rational(Integer(1) << 100U), narrow.upper);
  EXPECT_TRUE(compare(roots[0], roots[1]) < 0);
  EXPECT_TRUE(compare(roots[1], Rational(0)) > 0);
}

}  // namespace
}  // namespace lamina::number
