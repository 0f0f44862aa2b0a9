#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/surface_aim.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const auto policies = trace::parse_spawns("none,ulp-offset,error-bound,leaf-state,divide-out");
  const std::vector<std::pair<std::string, trace::Branch>> branches{
      {"transmission", trace::Branch::Transmission}, {"reflection", trace::Branch::Reflection}};
  const std::vector<int> powers{0, 3, 5};
  const std::vector<int> angles{3, 5, 7, 9};
  const std::uint64_t rays =
      settings.rays / (policies.size() * branches.size() * powers.size() * angles.size());
  constexpr double kDistance = 10;
  std::vector<Series> all;
  for (const auto& [branch, kind] : branches) {
    for (const int power : powers) {
      for (const int angle : angles) {
        for (const trace::SpawnPolicy& policy : policies) {
          all.push_back(spawned_series(
              {branch, power == 0 ? "0" : fmt::format("1e{}", power), fmt::format("1e-{}", angle),
               policy.name},
              fmt::format("distant-ball:{}", power),
              surface_aim("ball", std::pow(10.0, -angle), kDistance, scene::Held::Double),
              {{.branch = kind, .policy = policy}}, rays, settings));
        }
      }
    }
  }
  return all;
}

}  // namespace

Experiment grazing_spawn() {
  return {
      .name = "grazing-spawn",
      .question = "Do rays that are spawned at a grazing hit leave, and stay away?",
      .source = "Wyvill and Trotman 1990, sections 3.4 and 3.5",
      .labels =
          {{"branch", "branch", ""},
           {"centre", "centre", "Coordinates of the unit ball's centre, about."},
           {"angle", "angle",
            "At which the ray is aimed at the surface, in radians; its numbers are rounded then."},
           {"spawn", "spawn", "See `lamina list spawns`."}},
      .default_rays = 48'000,
      .default_methods =
          "regularized,wyvill-trotman,wyvill-trotman:parity,wyvill-trotman:secondary:cluster",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series,
      .tables = spawned_tables};
}

}  // namespace lamina::experiments
