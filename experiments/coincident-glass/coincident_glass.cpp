#include <fmt/format.h>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  constexpr std::uint64_t kFewest = 2;
  constexpr std::uint64_t kMost = 5;
  std::vector<Series> all;
  for (std::uint64_t count = kFewest; count <= kMost; ++count) {
    all.push_back(spawned_series({count}, fmt::format("glass-stack:{}", count), above_patch_aim(),
                                 {{.branch = trace::Branch::Transmission}},
                                 settings.rays / (kMost - kFewest + 1), settings));
  }
  return all;
}

}  // namespace

Experiment coincident_glass() {
  return {.name = "coincident-glass",
          .question = "Which medium is a ray in that goes through coincident transparent surfaces?",
          .source = "Wyvill and Trotman 1990, section 3.6, Figure 13",
          .labels = {{"surfaces", "surfaces", "That coincide, each of another transparent solid."}},
          .default_rays = 16'000,
          // 1e-6 is well above the error of a hit 10 away in double, 1e-15, and well below the
          // least depth of a slab, 2 * 2 / (7 sqrt(14)) = 0.15.
          .default_methods =
              "regularized,epsilon:1e-6,wyvill-trotman:no-look-ahead,"
              "wyvill-trotman,wyvill-trotman:look-ahead-all,"
              "wyvill-trotman:secondary:cluster,wyvill-trotman:look-ahead-class:secondary:cluster",
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
          .series = series,
          .tables = spawned_tables};
}

}  // namespace lamina::experiments
