#include "number/interval.hpp"

#include <gtest/gtest.h>

#include "base/contract.hpp"

namespace lamina::number {
namespace {

constexpr int kBits = 64;

bool contains(const Interval& interval, const Rational& value) {
  return interval.lower() <= value && value <= interval.upper();
}

TEST(IntervalTest, HoldsWhatItsBitsHoldExactly) {
  const Interval value(Rational(-3, 8), kBits);
  EXPECT_EQ(value.lower(), Rational(-3, 8));
  EXPECT_EQ(value.upper(), Rational(-3, 8));
  EXPECT_EQ(value.bits(), kBits);
}

TEST(IntervalTest, IsZeroByDefault) { EXPECT_EQ(Interval().sign(), 0); }

TEST(IntervalTest, EnclosesOperationsNarrowly) {
  const Rational a(1, 3);
  const Rational b(-22, 7);
  const Interval x(a, kBits);
  const Interval y(b, kBits);
  const Rational widest = Rational(1) / (Integer(1) << 58);
  const auto check = [&](const Interval& got, const Rational& exact) {
    EXPECT_TRUE(contains(got, exact)) << exact;
    EXPECT_GT(got.upper(), got.lower());
    EXPECT_LT(got.upper() - got.lower(), widest);
  };
  check(x, a);
  check(x + y, a + b);
  check(x - y, a - b);
  check(x * y, a * b);
  check(Integer(-5) * x, -5 * a);
  check(y / Integer(7), b / 7);
  check(x / y, a / b);
  Interval sum = x;
  sum += y;
  check(sum, a + b);
}

TEST(IntervalTest, DoesNotDivideByWhatMayBeZero) {
  const Interval one(Rational(1), kBits);
  EXPECT_THROW(one / Interval(Enclosure{-1, 1}, kBits), base::ContractError);
  EXPECT_THROW(one / Interval(), base::ContractError);
}

TEST(IntervalTest, TheHullContainsBothAndNoMore) {
  const Interval both = hull(Interval(Rational(-3), kBits), Interval(Enclosure{1, 2}, kBits));
  EXPECT_EQ(both.lower(), -3);
  EXPECT_EQ(both.upper(), 2);
}

TEST(IntervalTest, RoundsToTheMoreBitsOfTwo) {
  EXPECT_EQ((Interval(Rational(1, 3), 20) + Interval(Rational(1, 3), 90)).bits(), 90);
}

TEST(IntervalTest, KnowsASignOnlyIfAllItsNumbersHaveIt) {
  EXPECT_EQ(Interval(Rational(1, 3), kBits).sign(), 1);
  EXPECT_EQ(Interval(Rational(-1, 3), kBits).sign(), -1);
  EXPECT_EQ(Interval(Rational(0), kBits).sign(), 0);
  EXPECT_EQ(Interval(Enclosure{-1, 1}, kBits).sign(), std::nullopt);
  EXPECT_EQ(Interval(Enclosure{0, 1}, kBits).sign(), std::nullopt);
  const Interval third(Rational(1, 3), kBits);
  EXPECT_EQ((third - third).sign(), std::nullopt);
}

TEST(IntervalTest, IsAValue) {
  Interval a(Rational(1, 3), kBits);
  const Interval b = a;
  a = Interval(Rational(2), 10);
  EXPECT_EQ(a.lower(), 2);
  EXPECT_TRUE(contains(b, Rational(1, 3)));
  const Interval moved = std::move(a);
  EXPECT_EQ(moved.upper(), 2);
}

}  // namespace
}  // namespace lamina::number
