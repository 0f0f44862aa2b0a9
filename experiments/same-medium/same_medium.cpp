#include <fmt/format.h>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> shapes{"left", "right", "flat"};
  const std::vector<std::uint64_t> counts{3, 5};
  std::vector<Series> all;
  for (const std::uint64_t count : counts) {
    for (const std::string& shape : shapes) {
      all.push_back(family_series({count, shape}, fmt::format("same-medium:{}:{}", shape, count),
                                  above_patch_aim(),
                                  settings.rays / (shapes.size() * counts.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment same_medium() {
  return {.name = "same-medium",
          .question = "What do coincident surfaces of one material do, and the shape of the tree?",
          .source = "Wyvill and Trotman 1990, sections 3.2 and 3.4",
          .labels = {{"slabs", "slabs",
                      "Whose tops lie in one plane, of two materials in turn, added up."},
                     {"shape", "shape",
                      "Of the tree: a left-deep or right-deep chain of additions, or one addition "
                      "of all."}},
          .default_rays = 12'000,
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237,exact",
          .series = series};
}

}  // namespace lamina::experiments
