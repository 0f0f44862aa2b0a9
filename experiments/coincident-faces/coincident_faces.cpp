#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  std::vector<Series> all;
  for (const Aim& aim : {coincident_aim(), uniform_aim()}) {
    all.push_back(family_series({aim.name}, "coincident-faces", aim, settings.rays / 2, settings));
  }
  return all;
}

}  // namespace

Experiment coincident_faces() {
  return {.name = "coincident-faces",
          .question = "What does each method see where two or three solids share faces?",
          .source = "Wyvill and Trotman 1990, sections 1 to 3",
          .labels = {aim_column()},
          .default_rays = 8'000,
          .series = series};
}

}  // namespace lamina::experiments
