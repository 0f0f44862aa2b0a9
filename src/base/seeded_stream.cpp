#include "base/seeded_stream.hpp"

#include <Random123/philox.h>

#include "base/contract.hpp"

namespace lamina::base {
namespace {

// FNV-1a, 64 bit: a fixed hash of the name (std::hash differs between libraries).
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325U;
  for (const char c : text) {
    value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return value;
}

}  // namespace

SeededStream::SeededStream(std::string_view name, std::uint64_t seed, std::uint64_t case_id)
    : key_(hash(name) ^ (seed * 0x9e3779b97f4a7c15U)), case_id_(case_id) {}

std::uint64_t SeededStream::bits() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
  const auto high = [](std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32U); };
  const r123::Philox4x32::ctr_type counter{
      {low(counter_), high(counter_), low(case_id_), high(case_id_)}};
  const r123::Philox4x32::key_type key{{low(key_), high(key_)}};
  const auto block = r123::Philox4x32{}(counter, key);
  ++counter_;
  spare_ = (std::uint64_t{block[3]} << 32U) | block[2];
  has_spare_ = true;
  return (std::uint64_t{block[1]} << 32U) | block[0];
}

std::uint64_t SeededStream::below(std::uint64_t bound) {
  LAMINA_REQUIRE(bound >= 1, "an empty range has no members");
  const std::uint64_t excess = (UINT64_MAX % bound + 1) % bound;  // 2^64 mod bound
  std::uint64_t value = bits();
  while (value > UINT64_MAX - excess) {
    value = bits();
  }
  return value % bound;
}

std::int64_t SeededStream::integer(std::int64_t low, std::int64_t high) {
  LAMINA_REQUIRE(low <= high, "an empty range has no members");
  return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
}

double SeededStream::unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

double SeededStream::uniform(double low, double high) { return low + (high - low) * unit(); }

bool SeededStream::chance(double probability) { return unit() < probability; }

}  // namespace lamina::base
