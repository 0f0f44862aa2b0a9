#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"
#include "trace/number_choice.hpp"

namespace lamina::experiments {
namespace {

// Through a random point of the bounding box, from `distance` away or, if that is 0, from
// twice the box's diagonal.
Aim through_the_box(const std::string& name, double distance, scene::Held held) {
  return {name, [distance, held](const scene::FamilyMember&, const scene::Scene& scene,
                                 base::SeededStream& stream) {
            const auto target = scene::point_in(*scene.bounds, stream);
            const double away = distance == 0 ? scene::distance_outside(*scene.bounds) : distance;
            return scene::ray_from(target - away * scene::random_direction(stream), target, held);
          }};
}

struct Kind {
  std::string how;
  int power;
  std::string family;
  double distance;
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const int k : {0, 2, 4, 6, 8, 10, 12, 14}) {
    all.push_back({"translated", k, fmt::format("far-origin:translated:{}", k), 0});
  }
  for (const int k : {2, 4, 6, 8, 10, 12, 14}) {
    all.push_back({"seen from", k, "coincident-faces", std::pow(10.0, k)});
  }
  for (const int k : {-12, -9, -6, -3, 0, 3, 6, 9, 12}) {
    all.push_back({"scaled", k, fmt::format("far-origin:scaled:{}", k), 0});
  }
  return all;
}

std::vector<Series> series(const Settings& settings) {
  constexpr int kFloatUpTo = 6;  // farther away float does not hold a ray that meets the scene
  std::vector<Series> all;
  for (const Kind& kind : kinds()) {
    const bool in_float = kind.how == "scaled" || kind.power <= kFloatUpTo;
    Series one = family_series(
        {kind.how, fmt::format("{}", kind.power)}, kind.family,
        through_the_box(fmt::format("far-origin/{}/{}", kind.how, kind.power), kind.distance,
                        in_float ? scene::Held::Float : scene::Held::Double),
        settings.rays / kinds().size(), settings);
    if (!in_float) {
      std::erase_if(one.plan.numbers, [](const trace::NumberChoice& number) {
        return number.significand_bits > 0 &&
               number.significand_bits < std::numeric_limits<double>::digits;
      });
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

Experiment far_origin() {
  return {.name = "far-origin",
          .question = "What do distance from the origin, distance from the eye, and scale break?",
          .source = "Wyvill and Trotman 1990, section 2: error limits depend on scale",
          .labels = {{"how", "how",
                      "translated by 10^k along each axis; seen from 10^k away; scaled by 10^k: "
                      "members of coincident-faces, uniform rays."},
                     {"k", "k", "Power of ten."}},
          .default_rays = 15'000,
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
