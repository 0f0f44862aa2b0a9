#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  struct Kind {
    std::string sweep;
    std::string pair;
    std::string family;
    Aim aim;
  };
  std::vector<Kind> kinds;
  for (const std::string sweep : {"translational", "conic", "rotational"}) {
    for (const std::string second : {"same", "mirrored", "scaled"}) {
      for (const std::string pair : {"sum", "difference"}) {
        kinds.push_back({sweep, pair + ", " + second, "sweep-" + pair + ":" + sweep + ":" + second,
                         uniform_aim()});
      }
    }
    kinds.push_back({sweep, "halves", "sweep-halves:" + sweep, coincident_aim()});
  }
  kinds.push_back({"conic spline", "joints", "jointed-glass", coincident_aim()});
  std::vector<Series> all;
  for (const Kind& kind : kinds) {
    all.push_back(family_series({kind.sweep, kind.pair}, kind.family, kind.aim,
                                settings.rays / kinds.size(), settings, 10));
  }
  return all;
}

}  // namespace

Experiment sweep_coincidence() {
  return {.name = "sweep-coincidence",
          .question = "What does each method see where swept surfaces coincide?",
          .source = "van Wijk 1984, sections 3 to 6; Hashimoto and Suenaga, sections 2 and 3",
          .labels = {{"sweep", "sweep",
                      "Of a random closed spline; conic spline: the wine glass of quadrics and a "
                      "torus, its slabs in pairs of equal planes."},
                     {"pair", "pair",
                      "sum, difference: with the same again, with the mirror image of its mirror "
                      "image, or from numbers three times as large; rays go uniformly at the box. "
                      "halves, joints: rays through the planes that divide the solid."}},
          .default_rays = 2'200,
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
