#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// Steeply down at the patch, so that the ray goes through all that is below it.
Aim steep_aim() {
  return {"steep",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            const auto& patch = member.patches.front();
            const double u = stream.unit();
            const double v = stream.unit();
            const auto target = patch.corner + u * patch.side1 + v * patch.side2;
            const auto normal = cross(patch.side1, patch.side2);
            const auto up = geometry::normalised(normal);
            return scene::ray_from(target + 10.0 * up + 5.0 * scene::random_direction(stream),
                                   target, scene::Held::Float);
          }};
}

// At a random point of the innermost ball's inner half, from outside.
Aim core_aim() {
  return {"core", [](const scene::FamilyMember& member, const scene::Scene& scene,
                     base::SeededStream& stream) {
            const auto target =
                member.place(std::cbrt(stream.unit()) * 0.5 * scene::random_direction(stream));
            return scene::ray_through(target, scene::distance_outside(*scene.bounds), stream);
          }};
}

std::vector<Series> series(const Settings& settings) {
  constexpr std::uint64_t kLayers = 6;
  const std::vector<std::uint64_t> depths{1, 2, 4, 6};
  const std::uint64_t rays = settings.rays / (2 * depths.size());
  std::vector<Series> all;
  for (const auto& [name, aim] : {std::pair{"plates", steep_aim()}, {"onion", core_aim()}}) {
    for (const std::uint64_t passed : depths) {
      const std::vector<trace::Spawn> path(passed, {.branch = trace::Branch::Transmission});
      all.push_back(spawned_series({name, passed}, fmt::format("{}:{}", name, kLayers), aim, path,
                                   rays, settings, 20));
    }
  }
  return all;
}

}  // namespace

Experiment media() {
  return {
      .name = "media",
      .question = "Are the media right at every interface of layered and nested glasses?",
      .source = "Wyvill and Trotman 1990, sections 3.1 and 3.6",
      .labels = {{"scene", "scene",
                  "plates: six plates of different glasses, one on the other, with shared "
                  "faces; onion: six balls around one centre, the smaller added to the larger."},
                 {"passed", "passed",
                  "Interfaces that the ray is refracted at before the one that is judged."}},
      .default_rays = 4'800,
      .default_methods =
          "regularized,wyvill-trotman:no-look-ahead,wyvill-trotman,"
          "wyvill-trotman:secondary:cluster,wyvill-trotman:look-ahead-class:secondary:cluster",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series,
      .tables = spawned_tables};
}

}  // namespace lamina::experiments
