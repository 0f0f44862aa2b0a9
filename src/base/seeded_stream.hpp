// Random numbers that are the same on every machine, compiler and thread.
#pragma once

#include <cstdint>
#include <string_view>

namespace lamina::base {

/// A stream of random values fixed by (name, seed, case): any case replays alone,
/// and no case depends on how many were drawn before it. Counter-based (Philox
/// 4x32-10 of Random123: Salmon et al., SC 2011), so a stream costs nothing to make.
class SeededStream {
 public:
  /// `name` keeps the streams of different users of one seed apart.
  SeededStream(std::string_view name, std::uint64_t seed, std::uint64_t case_id);

  std::uint64_t bits();

  /// Uniform in 0 .. bound-1 (bound >= 1), without bias (rejection).
  std::uint64_t below(std::uint64_t bound);

  /// Uniform integer in low .. high, both included.
  std::int64_t integer(std::int64_t low, std::int64_t high);

  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit();

  /// Uniform in [low, high), computed in double.
  double uniform(double low, double high);

  bool chance(double probability);

 private:
  std::uint64_t key_;
  std::uint64_t case_id_;
  std::uint64_t counter_ = 0;
  std::uint64_t spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace lamina::base
