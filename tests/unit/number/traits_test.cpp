#include "number/traits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/seeded_stream.hpp"
#include "number/fused.hpp"
#include "support/number_types.hpp"

namespace lamina::number {
namespace {

template <typename Number>
class TraitsTest : public ::testing::Test {};
TYPED_TEST_SUITE(TraitsTest, support::RoundedNumberTypes, support::NumberNames);

// An independent rounding: the nearest multiple of the last place, ties to even.
Rational rounded_by_hand(const Rational& q, int bits) {
  if (q.is_zero()) {
    return q;
  }
  Rational unit = 1;
  const Rational least = Rational(Integer(1) << static_cast<unsigned>(bits - 1));
  while (abs(q) / unit >= 2 * least) {
    unit *= 2;
  }
  while (abs(q) / unit < least) {
    unit /= 2;
  }
  const Rational scaled = q / unit;
  Integer below = numerator(scaled) / denominator(scaled);
  if (Rational(below) > scaled) {
    --below;
  }
  const int half = Rational(scaled - below).compare(Rational(1, 2));
  if (half > 0 || (half == 0 && below % 2 != 0)) {
    ++below;
  }
  return below * unit;
}

Rational random_rational(base::SeededStream& stream) {
  // Within 2^-60 .. 2^60, so that products stay in float's range.
  const Rational magnitude(Integer(stream.bits() >> 24U), Integer((stream.bits() >> 24U) | 1U));
  const Rational shift(Integer(1) << static_cast<unsigned>(stream.below(20)));
  const Rational value =
      stream.chance(0.5) ? Rational(magnitude * shift) : Rational(magnitude / shift);
  return stream.chance(0.5) ? value : Rational(-value);
}

TYPED_TEST(TraitsTest, RoundsToNearestAndReadsBack) {
  using Traits = number_traits<TypeParam>;
  constexpr int kBits = Traits::kSignificandBits;
  for (std::uint64_t case_id = 0; case_id < 500; ++case_id) {
    base::SeededStream stream("number/rounding", 1, case_id);
    const Rational q = random_rational(stream);
    const Rational nearest = rounded_by_hand(q, kBits);
    EXPECT_EQ(Traits::to_exact(Traits::from_exact(q)), nearest) << "case " << case_id;
    // A tie between two neighbours, and one just off it.
    const Rational above =
        nearest * (1 + Rational(1, Integer(1) << static_cast<unsigned>(kBits - 1)));
    const Rational next = rounded_by_hand(above, kBits);
    const Rational tie = (nearest + next) / 2;
    EXPECT_EQ(Traits::to_exact(Traits::from_exact(tie)), rounded_by_hand(tie, kBits));
    const Rational off = tie * (1 + Rational(1, Integer(1) << 400U));
    EXPECT_EQ(Traits::to_exact(Traits::from_exact(off)), rounded_by_hand(off, kBits));
  }
}

TYPED_TEST(TraitsTest, ArithmeticRoundsOnce) {
  using Traits = number_traits<TypeParam>;
  using std::sqrt;
  constexpr int kBits = Traits::kSignificandBits;
  const auto nearest = [](const Rational& q) { return rounded_by_hand(q, kBits); };
  std::uint64_t fused_differs = 0;
  for (std::uint64_t case_id = 0; case_id < 2000; ++case_id) {
    base::SeededStream stream("number/arithmetic", 1, case_id);
    const TypeParam a = Traits::from_exact(random_rational(stream));
    const TypeParam b = Traits::from_exact(random_rational(stream));
    // Half of the time -a*b, rounded: the sum then is the product's rounding error.
    const TypeParam c =
        stream.chance(0.5) ? TypeParam(-(a * b)) : Traits::from_exact(random_rational(stream));
    const Rational x = Traits::to_exact(a);
    const Rational y = Traits::to_exact(b);
    const Rational z = Traits::to_exact(c);
    EXPECT_EQ(Traits::to_exact(TypeParam(a + b)), nearest(x + y));
    EXPECT_EQ(Traits::to_exact(TypeParam(a - b)), nearest(x - y));
    EXPECT_EQ(Traits::to_exact(TypeParam(a * b)), nearest(x * y));
    EXPECT_EQ(Traits::to_exact(TypeParam(a / b)), nearest(x / y));
    // Two roundings, in one expression: no contraction.
    EXPECT_EQ(Traits::to_exact(TypeParam(a * b + c)), nearest(nearest(x * y) + z));
    EXPECT_EQ(Traits::to_exact(fused_multiply_add(a, b, c)), nearest(x * y + z))
        << "case " << case_id;
    fused_differs += fused_multiply_add(a, b, c) != TypeParam(a * b + c) ? 1 : 0;
    // r is the nearest to the square root iff x is between the squares of its half-way points.
    const TypeParam r = sqrt(TypeParam(a < 0 ? TypeParam(-a) : a));
    const Rational root = Traits::to_exact(r);
    const Rational half = root / Rational(Integer(1) << static_cast<unsigned>(kBits));
    EXPECT_LE((root - half) * (root - half), Rational(abs(x)));
    EXPECT_GE((root + half) * (root + half), Rational(abs(x)));
  }
  EXPECT_GE(fused_differs, 500U);
}

// Ties of the fused sum that only a part far below the last place decides.
TYPED_TEST(TraitsTest, FusedMultiplyAddBreaksTiesByWhatIsFarBelow) {
  using Traits = number_traits<TypeParam>;
  constexpr int kBits = Traits::kSignificandBits;
  if (kBits > 53) {
    return;  // the exponents below must fit every hardware type
  }
  using std::ldexp;
  // (2^h + 1) (2^h + 1) = 2^2h + 2^(h+1) + 1 with 2h = bits: one bit too many, a tie; odd bit
  // counts use h and h + 1.
  const int h = kBits / 2;
  const TypeParam a = ldexp(TypeParam(1), h) + 1;
  const TypeParam b = ldexp(TypeParam(1), kBits - h) + 1;
  const Rational product = Traits::to_exact(a) * Traits::to_exact(b);
  for (const int sign : {-1, 1}) {
    const TypeParam tiny = ldexp(TypeParam(sign), -60);
    const Rational truth = rounded_by_hand(product + Traits::to_exact(tiny), kBits);
    EXPECT_EQ(Traits::to_exact(fused_multiply_add(a, b, tiny)), truth);
  }
}

TYPED_TEST(TraitsTest, StatesItsBits) {
  using Traits = number_traits<TypeParam>;
  const TypeParam one(1);
  const TypeParam u = unit_roundoff<TypeParam>();
  EXPECT_EQ(one + u, one);  // a tie, to even
  EXPECT_GT(one + 2 * u, one);
  EXPECT_EQ(
      Traits::to_exact(u) * Rational(Integer(1) << static_cast<unsigned>(Traits::kSignificandBits)),
      1);
}

TEST(HardwareRoundingTest, HandlesTheEndsOfTheRange) {
  const Rational tiny = Rational(std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number_traits<double>::from_exact(tiny / 2), 0.0);  // tie, to even
  EXPECT_EQ(number_traits<double>::from_exact(tiny * 3 / 4),
            std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number_traits<double>::from_exact(tiny * Rational(7, 2)), 4 * 4.9406564584124654e-324);
  const Rational largest(std::numeric_limits<double>::max());
  EXPECT_EQ(number_traits<double>::from_exact(largest * 2),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(
      number_traits<float>::from_exact(Rational(std::numeric_limits<float>::denorm_min()) * 5 / 4),
      std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(number_traits<float>::from_exact(-largest), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(number_traits<long double>::from_exact(largest * 4),
            4 * static_cast<long double>(std::numeric_limits<double>::max()));
}

}  // namespace
}  // namespace lamina::number
