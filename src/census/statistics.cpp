#include "census/statistics.hpp"

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

}  // namespace lamina::census
