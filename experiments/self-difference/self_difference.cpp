#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// The solids are made of half-spaces alone, so that their scenes have no bounds.
geometry::ExactRay at_the_solid(const scene::FamilyMember& member, const scene::Scene&,
                                base::SeededStream& stream) {
  constexpr double kHalf = 1.5;
  constexpr double kDistance = 20;
  const double x = stream.uniform(-kHalf, kHalf);
  const double y = stream.uniform(-kHalf, kHalf);
  const double z = stream.uniform(-kHalf, kHalf);
  return scene::ray_through(member.place({x, y, z}), kDistance, stream);
}

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> solids{"box", "cylinder", "cone", "sphere"};
  std::vector<Series> all;
  for (const std::string& solid : solids) {
    for (const std::string equation : {"same", "scaled"}) {
      all.push_back(family_series({solid, equation}, "self-difference:" + solid + ":" + equation,
                                  {"self-difference", at_the_solid},
                                  settings.rays / (2 * solids.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment self_difference() {
  return {.name = "self-difference",
          .question = "What is left of a solid less itself?",
          .source = "Wyvill and Trotman 1990, section 4, Figure 15",
          .labels = {{"solid", "solid", "Less itself; rays go through a cube around its middle."},
                     {"equation", "equation",
                      "Of the second solid: the same, or the same scaled by 3."}},
          .default_rays = 9'600,
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237,exact",
          .series = series};
}

}  // namespace lamina::experiments
