#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> solids{"box", "cylinder", "cone", "sphere", "torus"};
  std::vector<Series> all;
  for (const std::string& solid : solids) {
    all.push_back(family_series({solid}, "self-sum:" + solid, uniform_aim(),
                                settings.rays / solids.size(), settings));
  }
  return all;
}

}  // namespace

Experiment self_sum() {
  return {.name = "self-sum",
          .question = "What does each method see of a solid that is added to itself?",
          .source = "Wyvill and Trotman 1990, section 4, Figure 14",
          .labels = {{"solid", "solid", "Added to itself; rays go uniformly at its box."}},
          .default_rays = 6'000,
          .series = series};
}

}  // namespace lamina::experiments
