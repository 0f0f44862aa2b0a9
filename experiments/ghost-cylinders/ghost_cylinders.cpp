#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const Aim aim = coincident_aim();
  return {family_series({aim.name}, "ghost-cylinders", aim, settings.rays, settings)};
}

}  // namespace

Experiment ghost_cylinders() {
  return {.name = "ghost-cylinders",
          .question = "Which methods report the cap plane of one cylinder as the top of another?",
          .source = "Wyvill and Trotman 1990, section 2, Figure 4",
          .labels = {aim_column()},
          .default_rays = 10'000,
          .series = series};
}

}  // namespace lamina::experiments
