#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// From a random point of the ball, in a random direction.
Aim inside_aim() {
  return {"inside",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            constexpr double kMostRadius = 0.95;
            const double radius = kMostRadius * std::cbrt(stream.unit());
            const auto origin = member.place(radius * scene::random_direction(stream));
            return scene::ray_from(origin, origin + scene::random_direction(stream),
                                   scene::Held::Float);
          }};
}

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> kinds{"plain", "doubled"};
  const std::vector<std::string> policies{"none", "leaf-state", "divide-out"};
  const std::vector<std::uint64_t> bounces{1, 4, 16, 64};
  const std::uint64_t rays = settings.rays / (kinds.size() * policies.size() * bounces.size());
  std::vector<Series> all;
  for (const std::string& kind : kinds) {
    for (const std::string& policy : policies) {
      for (const std::uint64_t count : bounces) {
        const std::vector<trace::Spawn> path(count, {.policy = trace::parse_spawn(policy)});
        all.push_back(spawned_series({kind, policy, count}, "bubble:" + kind, inside_aim(), path,
                                     rays, settings, 10));
      }
    }
  }
  return all;
}

}  // namespace

Experiment bubble() {
  return {
      .name = "bubble",
      .question = "How long does a ray stay right that bounces inside a mirror sphere?",
      .source = "Wyvill and Trotman 1990, section 3.4, Figure 8",
      .labels =
          {{"bubble", "bubble",
            "plain: a block less a ball; doubled: the block added to itself, less the ball twice."},
           {"spawn", "spawn", "See `lamina list spawns`."},
           {"bounces", "bounces",
            "Reflections in turn; the last ray is judged, if those before it hit what "
            "is there."}},
      .default_rays = 960,
      .default_methods =
          "regularized,wyvill-trotman,wyvill-trotman:parity,"
          "wyvill-trotman:secondary:cluster",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series,
      .tables = spawned_tables};
}

}  // namespace lamina::experiments
