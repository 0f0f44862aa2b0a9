#include <fmt/format.h>

#include <optional>

#include "experiments/all_experiments.hpp"
#include "experiments/surface_aim.hpp"

namespace lamina::experiments {
namespace {

using trace::Branch;

struct Case {
  std::string branch;
  std::string solid = "ball";
  int power = 0;  // of ten, the scale
  std::optional<double> angle{};
};

// Each factor is varied around reflection on a ball of radius 1 at any angle.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* branch : {"reflection", "transmission", "shadow"}) {
    for (const char* solid : {"box", "cylinder", "cone", "ball", "ring"}) {
      all.push_back({branch, solid});
    }
  }
  for (const int power : {-3, 3, 6}) {
    all.push_back({"reflection", "ball", power});
  }
  for (const double angle : {1e-1, 1e-2, 1e-3}) {
    all.push_back({"reflection", "ball", 0, angle});
  }
  return all;
}

trace::Spawn spawn_of(const Case& one, const trace::SpawnPolicy& policy) {
  trace::Spawn spawn;
  spawn.policy = policy;
  spawn.branch = one.branch == "reflection"     ? Branch::Reflection
                 : one.branch == "transmission" ? Branch::Transmission
                                                : Branch::Shadow;
  const auto far = number::parse_rational(fmt::format("1e{}", one.power + 2));
  spawn.light = {far, far, far};
  return spawn;
}

// 1e-6 is well above the error of a hit 10 away in double, 10 * 2^-53 = 1e-15, well below the least
// radius, 1/4, and about as large as the error in float, 6e-7; relative, it goes with the scale.
constexpr const char* kPolicies =
    "none,offset:1e-6,offset:1e-6:relative,normal-offset:1e-6:relative,ulp-offset,error-bound,"
    "leaf-state,divide-out";

std::vector<Series> series(const Settings& settings) {
  const auto policies = trace::parse_spawns(kPolicies);
  const auto all_cases = cases();
  const std::uint64_t rays = settings.rays / (policies.size() * all_cases.size());
  constexpr double kDistance = 10;
  std::vector<Series> all;
  for (const trace::SpawnPolicy& policy : policies) {
    for (const Case& one : all_cases) {
      all.push_back(
          spawned_series({policy.name, one.branch, one.solid, fmt::format("1e{}", one.power),
                          one.angle ? fmt::format("{:g}", *one.angle) : "any"},
                         fmt::format("single:{}:{}", one.solid, one.power),
                         surface_aim(one.solid, one.angle, kDistance, scene::Held::Float),
                         {spawn_of(one, policy)}, rays, settings));
    }
  }
  return all;
}

}  // namespace

Experiment self_intersection() {
  return {
      .name = "self-intersection",
      .question = "Does a spawned ray hit the surface that it starts on?",
      .source = "Wyvill and Trotman 1990, sections 2 and 3.5",
      .labels =
          {{"spawn", "spawn", "See `lamina list spawns`."},
           {"branch", "branch",
            "Shadow rays go to a far light; where it is behind the surface, none does."},
           {"solid", "solid", "Of half-width 1; ring: a torus of radii 1 and 1/4."},
           {"scale", "scale", "The solid and all distances are multiplied by it."},
           {"angle", "angle",
            "At which the ray is aimed at the surface, in radians; its numbers are rounded then."}},
      .default_rays = 33'600,
      .default_methods = "regularized,wyvill-trotman,wyvill-trotman:secondary:cluster",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series,
      .tables = spawned_tables};
}

}  // namespace lamina::experiments
