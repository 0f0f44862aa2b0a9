#include "poly/certified_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/seeded_stream.hpp"

namespace lamina::poly {
namespace {

using number::Enclosure;
using number::Integer;
using number::Interval;
using number::Rational;

constexpr int kBits = 128;

// Coefficients of c * (s - r_0) (s - r_1) ...
std::vector<Rational> product_of(const std::vector<Rational>& roots, const Rational& c) {
  std::vector<Rational> coefficients{c};
  for (const Rational& root : roots) {
    std::vector<Rational> next(coefficients.size() + 1, Rational(0));
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      next[i + 1] += coefficients[i];
      next[i] -= root * coefficients[i];
    }
    coefficients = next;
  }
  return coefficients;
}

std::vector<Interval> enclosed(const std::vector<Rational>& coefficients, int bits = kBits) {
  std::vector<Interval> result;
  for (const Rational& c : coefficients) {
    result.emplace_back(c, bits);
  }
  return result;
}

TEST(CertifiedRootsTest, FindsThePositiveOnesInOrder) {
  const std::vector<Rational> all{Rational(7, 3), Rational(-2), Rational(1, 1000), Rational(10000)};
  const auto roots = positive_roots(enclosed(product_of(all, Rational(-3, 7))));
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->size(), 3u);
  const std::vector<Rational> right{Rational(1, 1000), Rational(7, 3), Rational(10000)};
  for (std::size_t i = 0; i < right.size(); ++i) {
    const auto bounds = enclosure((*roots)[i], 50);
    ASSERT_TRUE(bounds);
    EXPECT_LE(bounds->lower, right[i]);
    EXPECT_GE(bounds->upper, right[i]);
    EXPECT_LE((bounds->upper - bounds->lower) * (Integer(1) << 50),
              std::max(Rational(1), right[i]));
  }
}

// The cut that is tried first, u = 1/2, is the root s = 1 itself.
TEST(CertifiedRootsTest, FindsARootAtACut) {
  for (const Rational& root : {Rational(1), Rational(1, 3), Rational(3)}) {
    auto roots = positive_roots(enclosed(product_of({root}, 2)));
    ASSERT_TRUE(roots);
    ASSERT_EQ(roots->size(), 1u);
    const auto bounds = enclosure((*roots)[0], 60);
    ASSERT_TRUE(bounds);
    EXPECT_LE(bounds->lower, root);
    EXPECT_GE(bounds->upper, root);
  }
}

TEST(CertifiedRootsTest, FindsNoneWhereThereIsNone) {
  for (const auto& c : {std::vector<Rational>{1, 0, 1}, {1, 1, 1, 1}, {-2}, {5, -1, 1}}) {
    const auto roots = positive_roots(enclosed(c));
    ASSERT_TRUE(roots);
    EXPECT_TRUE(roots->empty());
  }
}

TEST(CertifiedRootsTest, DoesNotDecideWhatIntervalsLeaveOpen) {
  // A double root; roots that the bits do not separate; a zero constant; no coefficient.
  const Rational close = Rational(2) + Rational(1) / (Integer(1) << 40);
  EXPECT_FALSE(positive_roots(enclosed(product_of({2, 2}, 1))));
  EXPECT_FALSE(positive_roots(enclosed(product_of({2, close}, Rational(1, 3)), 32)));
  EXPECT_TRUE(positive_roots(enclosed(product_of({2, close}, Rational(1, 3)), 256)));
  EXPECT_FALSE(positive_roots(enclosed({0, 1})));
  EXPECT_FALSE(positive_roots({}));
  std::vector<Interval> wide = enclosed({-1, 1});
  wide[1] = Interval(Enclosure{-1, 1}, kBits);
  EXPECT_FALSE(positive_roots(wide));
}

TEST(CertifiedRootsTest, OrdersRootsOfDifferentPolynomials) {
  const auto root = [](const Rational& value, int bits) {
    return positive_roots(enclosed(product_of({value, -1}, Rational(1, 3)), bits))->front();
  };
  const Rational near = Rational(2) + Rational(1) / (Integer(1) << 60);
  IsolatedRoot a = root(2, 256);
  IsolatedRoot b = root(near, 256);
  EXPECT_EQ(compare(a, b), std::strong_ordering::less);
  EXPECT_EQ(compare(b, a), std::strong_ordering::greater);
  IsolatedRoot again = root(2, 256);
  EXPECT_EQ(compare(a, again), std::nullopt);
  IsolatedRoot rough = root(2, 40);
  IsolatedRoot rough_near = root(near, 40);
  EXPECT_EQ(compare(rough, rough_near), std::nullopt);
}

TEST(CertifiedRootsTest, FindsWhatRandomPolynomialsAreMadeOf) {
  int found = 0;
  for (std::uint64_t id = 0; id < 2000; ++id) {
    base::SeededStream stream("certified-roots", 1, id);
    std::vector<Rational> all;
    const std::int64_t degree = stream.integer(1, 4);
    while (all.size() < static_cast<std::size_t>(degree)) {
      const Rational root(stream.integer(-30, 60), stream.integer(1, 9));
      if (!root.is_zero() && std::find(all.begin(), all.end(), root) == all.end()) {
        all.push_back(root);
      }
    }
    const auto roots =
        positive_roots(enclosed(product_of(all, Rational(stream.integer(1, 5), -7))));
    std::erase_if(all, [](const Rational& root) { return root < 0; });
    std::sort(all.begin(), all.end());
    ASSERT_TRUE(roots) << "case " << id;
    ASSERT_EQ(roots->size(), all.size()) << "case " << id;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto bounds = enclosure((*roots)[i], 40);
      ASSERT_TRUE(bounds) << "case " << id;
      EXPECT_TRUE(bounds->lower <= all[i] && all[i] <= bounds->upper) << "case " << id;
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
}

// A thousand bits in a dozen steps or so: bisection alone would take a thousand.
TEST(CertifiedRootsTest, StepsAreMostlyNewtons) {
  auto roots =
      positive_roots(enclosed(product_of({Rational(1, 3), Rational(2), Rational(7)}, 3), 1100));
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->size(), 3U);
  IsolatedRoot& root = (*roots)[1];
  const Rational narrow = Rational(1) / (Integer(1) << 1000);
  int steps = 0;
  while (root.bounds().upper - root.bounds().lower > narrow) {
    ASSERT_TRUE(root.refine());
    ++steps;
  }
  EXPECT_LT(steps, 30);
  // u = s / (1 + s) of s = 2.
  EXPECT_LE(root.bounds().lower, Rational(2, 3));
  EXPECT_GE(root.bounds().upper, Rational(2, 3));
}

// Of coefficients that are known to 2^-40 only: no step loses the root of any polynomial that they
// enclose, and refining ends where they do not tell more.
TEST(CertifiedRootsTest, StepsOnWideCoefficientsKeepTheRoot) {
  const Rational off = Rational(1) / (Integer(1) << 40);
  for (int k = 1; k <= 20; ++k) {
    const Rational root(k, 7);
    const std::vector<Rational> exact =
        product_of({root, Rational(-2), Rational(100)}, k % 2 == 0 ? 1 : -3);
    std::vector<Interval> wide;
    for (const Rational& c : exact) {
      wide.emplace_back(Enclosure{c - off, c + off}, kBits);
    }
    auto roots = positive_roots(wide);
    ASSERT_TRUE(roots) << k;
    ASSERT_EQ(roots->size(), 2U) << k;
    IsolatedRoot& first = roots->front();
    const Rational u = root / (1 + root);
    int steps = 0;
    do {
      EXPECT_LE(first.bounds().lower, u) << k;
      EXPECT_GE(first.bounds().upper, u) << k;
      ASSERT_LT(++steps, 200) << k;
    } while (first.refine());
    const Rational width = first.bounds().upper - first.bounds().lower;
    EXPECT_LT(width, Rational(1) / (Integer(1) << 30)) << k;
  }
}

}  // namespace
}  // namespace lamina::poly
