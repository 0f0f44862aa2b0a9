#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// Down the well, with so much slant that rays go from wall to wall more than 64 times.
Aim well_aim() {
  return {"well",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            constexpr double kHalfWidth = 0.45;
            constexpr double kTop = 39.5;
            const geometry::Vector3<double> local{stream.uniform(-kHalfWidth, kHalfWidth),
                                                  stream.uniform(-kHalfWidth, kHalfWidth), kTop};
            const double angle = stream.uniform(0, 2 * M_PI);
            const geometry::Vector3<double> down{std::cos(angle), std::sin(angle),
                                                 -stream.uniform(0.1, 0.4)};
            return scene::ray_from(member.place(local), member.place(local + down),
                                   scene::Held::Float);
          }};
}

// Into the corner: after three reflections a ray goes back the way it came.
Aim corner_aim() {
  return {"corner",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            const geometry::Vector3<double> eye{stream.uniform(2, 4), stream.uniform(2, 4),
                                                stream.uniform(2, 4)};
            const geometry::Vector3<double> target{stream.uniform(0, 1), stream.uniform(0, 1),
                                                   stream.uniform(0, 1)};
            return scene::ray_from(member.place(eye), member.place(0.5 * target),
                                   scene::Held::Float);
          }};
}

struct Scene {
  std::string name;
  Aim aim;
  std::vector<std::uint64_t> depths;
};

std::vector<Series> series(const Settings& settings) {
  const std::vector<Scene> scenes{{"well", well_aim(), {1, 4, 16, 64}},
                                  {"cube-corner", corner_aim(), {1, 2, 3}}};
  const std::vector<std::string> kinds{"plain", "doubled"};
  constexpr std::uint64_t kSeries = 2 * (4 + 3);
  std::vector<Series> all;
  for (const Scene& scene : scenes) {
    for (const std::string& kind : kinds) {
      for (const std::uint64_t depth : scene.depths) {
        const std::vector<trace::Spawn> path(depth, trace::Spawn{});
        all.push_back(spawned_series({scene.name, kind, depth}, scene.name + ":" + kind, scene.aim,
                                     path, settings.rays / kSeries, settings, 10));
      }
    }
  }
  return all;
}

}  // namespace

Experiment ray_tree_depth() {
  return {
      .name = "ray-tree-depth",
      .question = "How many paths are still right after so many reflections?",
      .source = "Wyvill and Trotman 1990, sections 3.3 to 3.5",
      .labels = {{"scene", "scene",
                  "well: four walls, 1 apart and 40 deep; cube-corner: three faces that meet."},
                 {"kind", "kind", "doubled: added to itself, and what opens it taken away twice."},
                 {"depth", "depth",
                  "Reflections in turn; the last ray is judged, if those before it hit what "
                  "is there."}},
      .default_rays = 560,
      .default_methods =
          "regularized,wyvill-trotman,wyvill-trotman:secondary:parity,"
          "wyvill-trotman:secondary:hybrid,wyvill-trotman:keeps-hit-leaf,"
          "wyvill-trotman:secondary:cluster",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series,
      .tables = spawned_tables};
}

}  // namespace lamina::experiments
