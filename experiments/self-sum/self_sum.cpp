#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> solids{"box", "cylinder", "cone", "sphere", "torus"};
  std::vector<Series> all;
  for (const std::string& solid : solids) {
    for (const std::string second : {"same", "scaled"}) {
      all.push_back(family_series({solid, second}, "self-sum:" + solid + ":" + second,
                                  uniform_aim(), settings.rays / (2 * solids.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment self_sum() {
  return {.name = "self-sum",
          .question = "What does each method see of a solid that is added to itself?",
          .source = "Wyvill and Trotman 1990, section 4, Figure 14",
          .labels = {{"solid", "solid", "Added to itself; rays go uniformly at its box."},
                     {"second", "second",
                      "The same once more, or three times as large and then scaled by 1/3."}},
          .default_rays = 10'000,
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
