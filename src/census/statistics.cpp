#include "census/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

#include "base/contract.hpp"

namespace lamina::census {

Interval clopper_pearson(std::uint64_t count, std::uint64_t n) {
  LAMINA_REQUIRE(count <= n, "no more events than trials");
  if (n == 0) {
    return {};
  }
  using Binomial = boost::math::binomial_distribution<double>;
  constexpr double kEachSide = 0.025;
  const auto trials = static_cast<double>(n);
  const auto events = static_cast<double>(count);
  return {Binomial::find_lower_bound_on_p(trials, events, kEachSide),
          Binomial::find_upper_bound_on_p(trials, events, kEachSide)};
}

double mcnemar(std::uint64_t only_first, std::uint64_t only_second) {
  const std::uint64_t differing = only_first + only_second;
  if (differing == 0) {
    return 1;
  }
  const boost::math::binomial_distribution<double> fair(static_cast<double>(differing), 0.5);
  const auto fewer = static_cast<double>(std::min(only_first, only_second));
  return std::min(1.0, 2 * boost::math::cdf(fair, fewer));
}

}  // namespace lamina::census
