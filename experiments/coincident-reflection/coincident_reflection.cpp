#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  struct Kind {
    std::string label;
    std::string family;
    Aim aim;
  };
  const std::vector<Kind> kinds{
      {"cleared face", "cleared-face", above_patch_aim()},
      {"box + box", "self-sum:box:same", uniform_aim()},
      {"sphere + sphere", "self-sum:sphere:same", uniform_aim()},
      {"sphere + 3 sphere", "self-sum:sphere:scaled", uniform_aim()},
  };
  // Hits are about 10 away, so wrong by some 10 * 2^-53 = 1e-15 in double, and the least radius is
  // 1/4: 1e-6 lies well between. In float hits are wrong by 10 * 2^-24 = 6e-7, about as much.
  const std::vector<std::string> policies{"none", "offset:1e-6"};
  std::vector<Series> all;
  for (const Kind& kind : kinds) {
    for (const std::string& policy : policies) {
      all.push_back(spawned_series({kind.label, policy}, kind.family, kind.aim,
                                   {{.policy = trace::parse_spawn(policy)}},
                                   settings.rays / (kinds.size() * policies.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment coincident_reflection() {
  return {.name = "coincident-reflection",
          .question = "Is a ray right that is reflected where surfaces coincide?",
          .source = "Wyvill and Trotman 1990, sections 3.3 to 3.7",
          .labels = {{"scene", "scene", ""},
                     {"spawn", "spawn", "Where the reflected ray starts: `lamina list spawns`."}},
          .default_rays = 16'000,
          .default_methods =
              "regularized,epsilon:1e-6,wyvill-trotman:secondary:inherit,"
              "wyvill-trotman:keeps-hit-leaf,wyvill-trotman:secondary:parity,"
              "wyvill-trotman:secondary:hybrid,wyvill-trotman:secondary:cluster",
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
          .series = series,
          .tables = spawned_tables};
}

}  // namespace lamina::experiments
