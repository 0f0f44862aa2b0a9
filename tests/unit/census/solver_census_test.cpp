#include "census/solver_census.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lamina::census {
namespace {

using number::Integer;
using number::Rational;

TEST(ErrorCountsTest, QuantilesAreWithinAQuarterOfABit) {
  ErrorCounts counts;
  EXPECT_TRUE(std::isnan(counts.quantile(0.5)));
  for (int i = 1; i <= 1000; ++i) {
    counts.add(i);
  }
  EXPECT_EQ(counts.size(), 1000U);
  EXPECT_EQ(counts.largest(), 1000);
  EXPECT_EQ(counts.quantile(1), 1000);
  const double quarter = std::exp2(0.25);
  EXPECT_GE(counts.quantile(0.5), 500);
  EXPECT_LE(counts.quantile(0.5), 500 * quarter);
}

TEST(ErrorCountsTest, KeepsNothingAndInfinityThroughJson) {
  ErrorCounts counts;
  counts.add(0);
  counts.add(3);
  counts.add(std::numeric_limits<double>::infinity());
  const auto copy = nlohmann::json::parse(nlohmann::json(counts).dump()).get<ErrorCounts>();
  EXPECT_EQ(copy.size(), 3U);
  EXPECT_EQ(copy.quantile(0.3), 0);
  EXPECT_EQ(copy.quantile(1), std::numeric_limits<double>::infinity());
  ErrorCounts sum = copy;
  sum.merge(counts);
  EXPECT_EQ(sum.size(), 6U);
}

poly::KnownRoot at(const Rational& t, unsigned multiplicity = 1) { return {t, -52, multiplicity}; }

poly::Solution found(const std::vector<poly::Solution::Root>& roots) {
  return {roots, poly::Outcome::Found};
}

TEST(JudgeTest, CountsRootsAsOftenAsTheyAreMultiple) {
  RootCounts counts;
  judge(found({{1, 2}}), {at(1, 2)}, counts);
  EXPECT_EQ(counts.wrong_count, 0U);
  judge(found({{1, 0}, {1, 0}}), {at(1, 2)}, counts);  // one by one
  EXPECT_EQ(counts.wrong_count, 0U);
  judge(found({{1, 1}}), {at(1, 2)}, counts);
  EXPECT_EQ(counts.wrong_count, 1U);
  EXPECT_EQ(counts.wrong_parity, 1U);
  EXPECT_EQ(counts.missed, 1U);
  judge(found({}), {at(1, 2)}, counts);
  EXPECT_EQ(counts.wrong_count, 2U);
  EXPECT_EQ(counts.wrong_parity, 1U);
  EXPECT_EQ(counts.missed, 3U);
  EXPECT_EQ(counts.polynomials, 4U);
}

// Of three found one is too many: the one that is nearest to no exact root.
TEST(JudgeTest, PairsWithTheLeastSumOfDistances) {
  const Rational unit(Integer(1), Integer(1) << 52);
  RootCounts counts;
  const auto pairs =
      judge(found({{1 + unit, 0}, {Rational(3, 2), 0}, {2 - 3 * unit, 0}}), {at(1), at(2)}, counts);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].found, 0U);
  EXPECT_EQ(pairs[1].found, 2U);
  EXPECT_EQ(pairs[0].ulps, 1);
  EXPECT_EQ(pairs[1].ulps, 3);
  EXPECT_EQ(counts.spurious, 1U);
  EXPECT_EQ(counts.missed, 0U);

  const auto lost = judge(found({{2, 0}}), {at(1), at(2), at(3)}, counts);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].exact, 1U);
  EXPECT_EQ(counts.missed, 2U);
}

TEST(JudgeTest, TheUndecidedAreCountedApart) {
  RootCounts counts;
  poly::Solution none;
  none.outcome = poly::Outcome::Undecided;
  EXPECT_TRUE(judge(none, {at(1)}, counts).empty());
  EXPECT_EQ(counts.undecided, 1U);
  EXPECT_EQ(counts.wrong_count, 0U);
  EXPECT_EQ(counts.missed, 0U);
  const auto copy = nlohmann::json::parse(nlohmann::json(counts).dump()).get<RootCounts>();
  EXPECT_EQ(copy.undecided, 1U);
  EXPECT_EQ(copy.polynomials, 1U);
}

}  // namespace
}  // namespace lamina::census
