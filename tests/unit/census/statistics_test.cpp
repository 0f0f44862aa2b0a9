#include "census/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "base/contract.hpp"

namespace lamina::census {
namespace {

constexpr double kEachSide = 0.025;

// The probabilities of 0 .. n events, each from the one before. Contract: 0 < p < 1.
std::vector<long double> binomial(std::uint64_t n, long double p) {
  std::vector<long double> all{std::pow(1 - p, static_cast<long double>(n))};
  for (std::uint64_t k = 1; k <= n; ++k) {
    all.push_back(all.back() * static_cast<long double>(n - k + 1) / static_cast<long double>(k) *
                  p / (1 - p));
  }
  return all;
}

double sum(const std::vector<long double>& terms, std::uint64_t first, std::uint64_t last) {
  long double total = 0;
  for (std::uint64_t k = first; k <= last; ++k) {
    total += terms[k];
  }
  return static_cast<double>(total);
}

// Each bound is the probability at which the tail from the count on is 2.5 %. A tail's slope in
// p is below n, so that a bound wrong by 2^-40 moves it by n 2^-40 at most.
TEST(ClopperPearsonTest, TailsAtTheBoundsAre2Point5Percent) {
  for (const std::uint64_t n : {1U, 2U, 7U, 30U, 100U, 1000U}) {
    const double tolerance = static_cast<double>(n) * 0x1p-40;
    for (std::uint64_t k = 0; k <= n; k += n > 100 ? 83 : 1) {
      const Interval interval = clopper_pearson(k, n);
      if (k > 0) {
        EXPECT_NEAR(sum(binomial(n, interval.lower), k, n), kEachSide, tolerance)
            << k << " of " << n;
      }
      if (k < n) {
        EXPECT_NEAR(sum(binomial(n, interval.upper), 0, k), kEachSide, tolerance)
            << k << " of " << n;
      }
    }
  }
}

// 1 - 0.025^(1/n) and its mirror image.
TEST(ClopperPearsonTest, NoneAndAllHaveClosedForms) {
  for (const std::uint64_t n : {1U, 10U, 100U, 1'000'000U}) {
    const double root = std::exp(std::log(0.025) / static_cast<double>(n));
    const Interval none = clopper_pearson(0, n);
    EXPECT_EQ(none.lower, 0);
    EXPECT_NEAR(none.upper, 1 - root, 1e-15);
    const Interval all = clopper_pearson(n, n);
    EXPECT_NEAR(all.lower, root, 1e-15);
    EXPECT_EQ(all.upper, 1);
  }
}

// As tables of exact limits print them.
TEST(ClopperPearsonTest, EqualsPrintedTables) {
  const std::vector<std::tuple<std::uint64_t, std::uint64_t, double, double>> printed{
      {0, 10, 0, 0.3085},
      {1, 10, 0.0025, 0.4450},
      {5, 10, 0.1871, 0.8129},
      {10, 100, 0.0490, 0.1762},
      {50, 100, 0.3983, 0.6017}};
  for (const auto& [count, n, lower, upper] : printed) {
    const Interval interval = clopper_pearson(count, n);
    EXPECT_NEAR(interval.lower, lower, 5e-5) << count << " of " << n;
    EXPECT_NEAR(interval.upper, upper, 5e-5) << count << " of " << n;
  }
}

TEST(ClopperPearsonTest, CoversAtLeast95PercentWhateverTheProbability) {
  for (const std::uint64_t n : {1U, 5U, 20U, 50U}) {
    for (int i = 1; i < 200; ++i) {
      const double p = i / 200.0;
      const auto probability = binomial(n, p);
      long double covered = 0;
      for (std::uint64_t k = 0; k <= n; ++k) {
        const Interval interval = clopper_pearson(k, n);
        covered += interval.lower <= p && p <= interval.upper ? probability[k] : 0;
      }
      EXPECT_GE(covered, 0.95L) << n << " trials at " << p;
    }
  }
}

TEST(ClopperPearsonTest, NoTrialsTellNothing) {
  const Interval interval = clopper_pearson(0, 0);
  EXPECT_EQ(interval.lower, 0);
  EXPECT_EQ(interval.upper, 1);
}

TEST(ClopperPearsonTest, MoreEventsThanTrialsBreakTheContract) {
  EXPECT_THROW(clopper_pearson(2, 1), base::ContractError);
}

// 2 (C(n, 0) + .. + C(n, fewer)) / 2^n, by hand.
TEST(McNemarTest, EqualsBinomialTails) {
  EXPECT_NEAR(mcnemar(0, 5), 0.0625, 1e-15);
  EXPECT_NEAR(mcnemar(0, 1), 1, 1e-15);
  EXPECT_NEAR(mcnemar(1, 7), 18.0 / 256, 1e-15);
  EXPECT_NEAR(mcnemar(2, 8), 112.0 / 1024, 1e-15);
  EXPECT_NEAR(mcnemar(0, 100), 0x1p-99, 0x1p-140);
  EXPECT_EQ(mcnemar(4, 4), 1);
  EXPECT_EQ(mcnemar(3, 4), 1);
  EXPECT_EQ(mcnemar(0, 0), 1);
}

TEST(McNemarTest, IsTheProbabilityOfASplitAtLeastAsUneven) {
  for (std::uint64_t n = 1; n <= 60; ++n) {
    const auto fair = binomial(n, 0.5L);
    for (std::uint64_t first = 0; first <= n; ++first) {
      const auto unevenness = [n](std::uint64_t k) { return k > n - k ? 2 * k - n : n - 2 * k; };
      long double expected = 0;
      for (std::uint64_t k = 0; k <= n; ++k) {
        expected += unevenness(k) >= unevenness(first) ? fair[k] : 0;
      }
      EXPECT_NEAR(mcnemar(first, n - first), static_cast<double>(expected), 1e-13);
      EXPECT_EQ(mcnemar(first, n - first), mcnemar(n - first, first));
    }
  }
}

// Splits of 20 with 5 or fewer on one side: 2 * 21700 of 2^20.
TEST(McNemarTest, RejectsWhatIsFairInAtMost5Percent) {
  const auto rejected = [](std::uint64_t n) {
    const auto fair = binomial(n, 0.5L);
    long double sum = 0;
    for (std::uint64_t k = 0; k <= n; ++k) {
      sum += mcnemar(k, n - k) <= 0.05 ? fair[k] : 0;
    }
    return static_cast<double>(sum);
  };
  EXPECT_NEAR(rejected(20), 43400.0 / 1048576, 1e-14);
  for (std::uint64_t n = 0; n <= 100; ++n) {
    EXPECT_LE(rejected(n), 0.05) << n;
  }
  EXPECT_GE(rejected(100), 0.03);
}

}  // namespace
}  // namespace lamina::census
