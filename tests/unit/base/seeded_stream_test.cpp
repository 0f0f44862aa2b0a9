#include "base/seeded_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/contract.hpp"

namespace lamina::base {
namespace {

using Block = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

// Philox 4x32-10, written again from Salmon et al., SC 2011, section 3.3.
Block philox(Block counter, Key key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32U) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32U) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};
  }
  return counter;
}

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // what a seed is multiplied by

// The stream's definition: key = FNV-1a(name) xor seed * kGolden, counter = (block, case).
std::uint64_t defined_bits(std::uint64_t name_hash, std::uint64_t seed, std::uint64_t case_id,
                           std::uint64_t draw) {
  const std::uint64_t key = name_hash ^ (seed * kGolden);
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32U); };
  const Block block =
      philox({low(draw / 2), high(draw / 2), low(case_id), high(case_id)}, {low(key), high(key)});
  const std::size_t half = draw % 2 * 2;
  return std::uint64_t{block[half + 1]} << 32U | block[half];
}

// FNV-1a hashes from the test vectors of its authors (Fowler, Noll, Vo).
struct NamedHash {
  std::string_view name;
  std::uint64_t hash;
};
constexpr std::array<NamedHash, 3> kFnv1a{
    {{"", 0xcbf29ce484222325}, {"a", 0xaf63dc4c8601ec8c}, {"foobar", 0x85944171f73967e8}}};

TEST(SeededStreamTest, ReferencePhiloxGivesThePublishedAnswers) {
  // The known-answer vectors that Random123 is distributed with (kat_vectors, philox4x32 10).
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(SeededStreamTest, FirstDrawsOfTheZeroKeyAreThePublishedBlock) {
  // kGolden is odd, so some seed makes the key zero: hash / kGolden modulo 2^64. Newton's
  // iteration doubles the right bits of an inverse, from 3 (any odd x inverts itself mod 8).
  std::uint64_t inverse = kGolden;
  for (int step = 0; step < 5; ++step) {
    inverse *= 2 - kGolden * inverse;
  }
  SeededStream stream("", 0xcbf29ce484222325 * inverse, 0);
  EXPECT_EQ(stream.bits(), 0xe169c58d6627e8d5);
  EXPECT_EQ(stream.bits(), 0x9b00dbd8bc57ac4c);
}

TEST(SeededStreamTest, FollowsItsDefinitionForEveryNameSeedAndCase) {
  for (const auto& [name, hash] : kFnv1a) {
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, UINT64_MAX}) {
      for (const std::uint64_t case_id : {std::uint64_t{0}, std::uint64_t{1} << 33U, UINT64_MAX}) {
        SeededStream stream(name, seed, case_id);
        for (std::uint64_t draw = 0; draw < 9; ++draw) {
          ASSERT_EQ(stream.bits(), defined_bits(hash, seed, case_id, draw))
              << '"' << name << "\", seed " << seed << ", case " << case_id << ", draw " << draw;
        }
      }
    }
  }
}

TEST(SeededStreamTest, StreamsOfDifferentNamesSeedsAndCasesShareNothing) {
  constexpr std::uint64_t kSide = 40;
  std::vector<std::uint64_t> first_draws;
  for (std::uint64_t name = 0; name < kSide; ++name) {
    for (std::uint64_t seed = 0; seed < kSide; ++seed) {
      for (std::uint64_t case_id = 0; case_id < kSide; ++case_id) {
        first_draws.push_back(SeededStream("stream " + std::to_string(name), seed, case_id).bits());
      }
    }
  }
  // Neighbours in the order above differ in case, seed or name: half of the bits differ,
  // 32 each on average with standard deviation 4.
  double differing = 0;
  for (std::size_t i = 1; i < first_draws.size(); ++i) {
    differing += std::popcount(first_draws[i] ^ first_draws[i - 1]);
  }
  const auto pairs = static_cast<double>(first_draws.size() - 1);
  EXPECT_NEAR(differing / pairs, 32.0, 6 * 4 / std::sqrt(pairs));
  std::sort(first_draws.begin(), first_draws.end());
  EXPECT_EQ(std::adjacent_find(first_draws.begin(), first_draws.end()), first_draws.end());
}

TEST(SeededStreamTest, BelowIsUniformOverSmallRanges) {
  constexpr std::uint64_t kDrawsPerValue = 10'000;
  for (const std::uint64_t bound : {1U, 2U, 3U, 7U, 10U, 64U, 100U}) {
    SeededStream stream("seeded_stream_test/below", 1, bound);
    std::vector<std::uint64_t> count(bound, 0);
    for (std::uint64_t draw = 0; draw < bound * kDrawsPerValue; ++draw) {
      const std::uint64_t value = stream.below(bound);
      ASSERT_LT(value, bound);
      ++count[value];
    }
    // Six standard deviations of a binomial count: false once in 5e8 values.
    const double six_sigma = 6 * std::sqrt(static_cast<double>(kDrawsPerValue));
    for (std::uint64_t value = 0; value < bound; ++value) {
      EXPECT_NEAR(static_cast<double>(count[value]), static_cast<double>(kDrawsPerValue), six_sigma)
          << value << " below " << bound;
    }
  }
}

TEST(SeededStreamTest, BelowRejectsWhatWouldBiasALargeRange) {
  // With bound = 3 * 2^62, a plain remainder of 64 bits would give the lowest third of the
  // values half of the draws.
  constexpr std::uint64_t kBound = std::uint64_t{3} << 62U;
  constexpr int kDraws = 100'000;
  SeededStream stream("seeded_stream_test/rejection", 1, 0);
  std::array<int, 3> thirds{};
  for (int draw = 0; draw < kDraws; ++draw) {
    const std::uint64_t value = stream.below(kBound);
    ASSERT_LT(value, kBound);
    ++thirds[value >> 62U];
  }
  const double six_sigma = 6 * std::sqrt(kDraws * (1.0 / 3) * (2.0 / 3));
  for (const int count : thirds) {
    EXPECT_NEAR(count, kDraws / 3.0, six_sigma);
  }
}

TEST(SeededStreamTest, IntegerReachesBothEndsAndNothingOutside) {
  SeededStream stream("seeded_stream_test/integer", 1, 0);
  std::array<int, 5> count{};
  for (int draw = 0; draw < 5000; ++draw) {
    const std::int64_t value = stream.integer(-3, 1);
    ASSERT_GE(value, -3);
    ASSERT_LE(value, 1);
    ++count[static_cast<std::size_t>(value + 3)];
  }
  for (const int each : count) {
    EXPECT_NEAR(each, 1000, 6 * std::sqrt(5000 * 0.2 * 0.8));
  }
  EXPECT_EQ(stream.integer(42, 42), 42);
}

TEST(SeededStreamTest, UnitHas53BitsAndTheRightMean) {
  constexpr int kDraws = 100'000;
  SeededStream stream("seeded_stream_test/unit", 1, 0);
  double sum = 0;
  std::uint64_t bits_seen = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const double value = stream.unit();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    const double scaled = value * 0x1p53;
    ASSERT_EQ(scaled, std::floor(scaled));
    bits_seen |= static_cast<std::uint64_t>(scaled);
    sum += value;
  }
  EXPECT_EQ(bits_seen, (std::uint64_t{1} << 53U) - 1);
  EXPECT_NEAR(sum / kDraws, 0.5, 6 * std::sqrt(1.0 / 12 / kDraws));
}

TEST(SeededStreamTest, ChanceHappensAsOftenAsItSays) {
  constexpr int kDraws = 100'000;
  SeededStream stream("seeded_stream_test/chance", 1, 0);
  int happened = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    ASSERT_FALSE(stream.chance(0));
    ASSERT_TRUE(stream.chance(1));
    happened += stream.chance(0.1) ? 1 : 0;
  }
  EXPECT_NEAR(happened, kDraws * 0.1, 6 * std::sqrt(kDraws * 0.1 * 0.9));
}

// Golden values: a change here changes every published table that was drawn from a seed.
TEST(SeededStreamTest, DrawsNeverChange) {
  SeededStream stream("golden", 1, 2);
  EXPECT_EQ(stream.bits(), 0x747bb760af967502);
  EXPECT_EQ(stream.below(1000), 877U);
  EXPECT_EQ(stream.integer(-1000, 1000), -235);
  EXPECT_EQ(stream.unit(), 0x1.6c86b74125473p-1);
  EXPECT_EQ(stream.uniform(-2, 6), -0x1.bb926d06527e8p+0);
  EXPECT_EQ(stream.chance(0.5), true);
}

TEST(SeededStreamTest, RefusesEmptyRanges) {
  SeededStream stream("seeded_stream_test/contract", 1, 0);
  EXPECT_THROW(stream.below(0), ContractError);
  EXPECT_THROW(stream.integer(1, 0), ContractError);
}

}  // namespace
}  // namespace lamina::base
