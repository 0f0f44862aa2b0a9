#include "census/solver_census.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina::census {
namespace {

constexpr int kSizesPerBit = 4;
// Errors of nothing, and those without end, have sizes of their own.
constexpr int kNothing = std::numeric_limits<int>::min();
constexpr int kInfinite = std::numeric_limits<int>::max();

int size_of(double error) {
  if (error == 0) {
    return kNothing;
  }
  return std::isfinite(error) ? static_cast<int>(std::ceil(kSizesPerBit * std::log2(error)))
                              : kInfinite;
}

double upper_end(int size) {
  if (size == kNothing) {
    return 0;
  }
  return size == kInfinite ? std::numeric_limits<double>::infinity()
                           : std::exp2(static_cast<double>(size) / kSizesPerBit);
}

// For each of the shorter list's members one of the longer's, both in order, with the least sum of
// distances: a row of the table is a member of the shorter list, an entry the best sum so far.
std::vector<std::size_t> matched(const std::vector<double>& shorter,
                                 const std::vector<double>& longer) {
  const std::size_t n = shorter.size();
  const std::size_t m = longer.size();
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> best(n + 1, std::vector<double>(m + 1, kNever));
  std::fill(best[0].begin(), best[0].end(), 0);
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t j = i; j <= m; ++j) {
      best[i][j] =
          std::min(best[i][j - 1], best[i - 1][j - 1] + std::abs(shorter[i - 1] - longer[j - 1]));
    }
  }
  std::vector<std::size_t> partners(n);
  for (std::size_t i = n, j = m; i > 0; --j) {
    if (j == i || best[i][j] < best[i][j - 1]) {
      partners[--i] = j - 1;
    }
  }
  return partners;
}

}  // namespace

void ErrorCounts::add(double error) {
  ++count_;
  largest_ = std::max(largest_, error);
  ++by_size_[size_of(error)];
}

void ErrorCounts::merge(const ErrorCounts& other) {
  count_ += other.count_;
  largest_ = std::max(largest_, other.largest_);
  for (const auto& [size, count] : other.by_size_) {
    by_size_[size] += count;
  }
}

double ErrorCounts::quantile(double part) const {
  if (count_ == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double wanted = part * static_cast<double>(count_);
  std::uint64_t below = 0;
  for (const auto& [size, count] : by_size_) {
    below += count;
    if (static_cast<double>(below) >= wanted) {
      return std::min(upper_end(size), largest_);
    }
  }
  return largest_;
}

void to_json(nlohmann::json& json, const ErrorCounts& counts) {
  // JSON has no infinity.
  const bool finite = std::isfinite(counts.largest_);
  json = {{"largest", finite ? nlohmann::json(counts.largest_) : nlohmann::json(nullptr)},
          {"by_size", counts.by_size_}};
}

void from_json(const nlohmann::json& json, ErrorCounts& counts) {
  counts.largest_ = json.at("largest").is_null() ? std::numeric_limits<double>::infinity()
                                                 : json.at("largest").get<double>();
  counts.by_size_ = json.at("by_size").get<std::map<int, std::uint64_t>>();
  counts.count_ = 0;
  for (const auto& [size, count] : counts.by_size_) {
    counts.count_ += count;
  }
}

void RootCounts::merge(const RootCounts& other) {
  polynomials += other.polynomials;
  wrong_count += other.wrong_count;
  wrong_parity += other.wrong_parity;
  missed += other.missed;
  spurious += other.spurious;
  undecided += other.undecided;
  ulps.merge(other.ulps);
}

void to_json(nlohmann::json& json, const RootCounts& counts) {
  json = {{"polynomials", counts.polynomials},
          {"wrong_count", counts.wrong_count},
          {"wrong_parity", counts.wrong_parity},
          {"missed", counts.missed},
          {"spurious", counts.spurious},
          {"undecided", counts.undecided},
          {"ulps", counts.ulps}};
}

void from_json(const nlohmann::json& json, RootCounts& counts) {
  json.at("polynomials").get_to(counts.polynomials);
  json.at("wrong_count").get_to(counts.wrong_count);
  json.at("wrong_parity").get_to(counts.wrong_parity);
  json.at("missed").get_to(counts.missed);
  json.at("spurious").get_to(counts.spurious);
  json.at("undecided").get_to(counts.undecided);
  json.at("ulps").get_to(counts.ulps);
}

std::vector<RootPair> judge(const poly::Solution& solution,
                            const std::vector<poly::KnownRoot>& exact, RootCounts& counts) {
  ++counts.polynomials;
  if (solution.outcome == poly::Outcome::Undecided) {
    ++counts.undecided;
    return {};
  }
  // Once for each multiplicity.
  std::vector<std::size_t> found;
  std::vector<double> found_at;
  for (std::size_t i = 0; i < solution.roots.size(); ++i) {
    const auto times = static_cast<std::size_t>(std::max(1, solution.roots[i].multiplicity));
    found.insert(found.end(), times, i);
    found_at.insert(found_at.end(), times, number::nearest_double(solution.roots[i].t));
  }
  std::vector<std::size_t> there;
  std::vector<double> there_at;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    there.insert(there.end(), exact[i].multiplicity, i);
    there_at.insert(there_at.end(), exact[i].multiplicity, number::nearest_double(exact[i].t));
  }
  counts.wrong_count += found.size() == there.size() ? 0 : 1;
  counts.wrong_parity += found.size() % 2 == there.size() % 2 ? 0 : 1;
  const bool more_found = found.size() > there.size();
  (more_found ? counts.spurious : counts.missed) +=
      more_found ? found.size() - there.size() : there.size() - found.size();
  const std::vector<std::size_t> partners =
      more_found ? matched(there_at, found_at) : matched(found_at, there_at);
  std::vector<RootPair> pairs;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const std::size_t f = found[more_found ? partners[i] : i];
    const std::size_t e = there[more_found ? i : partners[i]];
    pairs.push_back({f, e, poly::error_ulps(solution.roots[f].t, exact[e])});
    counts.ulps.add(pairs.back().ulps);
  }
  return pairs;
}

}  // namespace lamina::census
