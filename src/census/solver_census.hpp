// A root finder against the exact roots: counts, errors, and what they depend on.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "poly/solution.hpp"

namespace lamina::census {

/// How many errors of which size: in quarters of bits, so that a quantile is right to 19 %.
class ErrorCounts {
 public:
  void add(double error);
  void merge(const ErrorCounts& other);
  [[nodiscard]] std::uint64_t size() const { return count_; }
  /// The least size that at least this part of the errors does not exceed; NaN without errors.
  [[nodiscard]] double quantile(double part) const;
  [[nodiscard]] double largest() const { return largest_; }

  friend void to_json(nlohmann::json& json, const ErrorCounts& counts);
  friend void from_json(const nlohmann::json& json, ErrorCounts& counts);

 private:
  std::uint64_t count_ = 0;
  double largest_ = 0;
  std::map<int, std::uint64_t> by_size_;
};

/// What a solver makes of polynomials against exact roots. Roots count as often as they are
/// multiple; those of unknown multiplicity once.
struct RootCounts {
  std::uint64_t polynomials = 0;
  std::uint64_t wrong_count = 0;
  std::uint64_t wrong_parity = 0;
  std::uint64_t missed = 0;     ///< roots
  std::uint64_t spurious = 0;   ///< roots
  std::uint64_t undecided = 0;  ///< polynomials; counted nowhere else
  ErrorCounts ulps;             ///< of the roots that have one to be compared with

  void merge(const RootCounts& other);
};
void to_json(nlohmann::json& json, const RootCounts& counts);
void from_json(const nlohmann::json& json, RootCounts& counts);

/// A root found and the exact one that it stands for.
struct RootPair {
  std::size_t found = 0;
  std::size_t exact = 0;
  double ulps = 0;
};

/// Adds a solution to the counts. Found and exact roots are paired in order; where there are more
/// of the one kind, so that the sum of the distances is least.
///
/// Returns the pairs.
std::vector<RootPair> judge(const poly::Solution& solution,
                            const std::vector<poly::KnownRoot>& exact, RootCounts& counts);

}  // namespace lamina::census
