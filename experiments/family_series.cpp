#include "experiments/family_series.hpp"

#include <algorithm>

namespace lamina::experiments {

Aim uniform_aim() {
  return {"uniform",
          [](const scene::FamilyMember&, const scene::Scene& scene, base::SeededStream& stream) {
            return scene::ray_through(scene::point_in(*scene.bounds, stream),
                                      scene::distance_outside(*scene.bounds), stream);
          }};
}

Aim coincident_aim() {
  return {
      "coincident",
      [](const scene::FamilyMember& member, const scene::Scene& scene, base::SeededStream& stream) {
        constexpr double kOutside = 20;  // of the members without bounds
        const double distance = scene.bounds ? scene::distance_outside(*scene.bounds) : kOutside;
        const auto& patch = member.patches[stream.below(member.patches.size())];
        const double u = stream.unit();
        return scene::ray_through(patch.corner + u * patch.side1 + stream.unit() * patch.side2,
                                  distance, stream);
      }};
}

report::Column aim_column() {
  return {"aim", "aim",
          "Where rays go: uniform, at a random point of the bounding box; coincident, at a face "
          "that leaves share."};
}

Series family_series(std::vector<census::Label> labels, const std::string& family, const Aim& aim,
                     std::uint64_t rays, const Settings& settings, std::uint64_t rays_per_scene) {
  const auto task = [family, aim, rays, rays_per_scene, seed = settings.seed](std::size_t index) {
    const scene::FamilyMember member = scene::family_member(family, seed, index);
    census::Task result;
    result.scene = scene::parse_scene(member.text, scene::family_spelling(family, seed, index));
    base::SeededStream stream("rays/" + aim.name, seed, index);
    const std::uint64_t count = std::min(rays_per_scene, rays - index * rays_per_scene);
    for (std::uint64_t i = 0; i < count; ++i) {
      result.rays.push_back(aim.draw(member, result.scene, stream));
    }
    return result;
  };
  return {std::move(labels), settings.plan,
          static_cast<std::size_t>((rays + rays_per_scene - 1) / rays_per_scene), task};
}

Series spawned_series(std::vector<census::Label> labels, const std::string& family, const Aim& aim,
                      const std::vector<trace::Spawn>& spawns, std::uint64_t rays,
                      const Settings& settings, std::uint64_t rays_per_scene) {
  Series series = family_series(std::move(labels), family, aim, rays, settings, rays_per_scene);
  std::erase_if(series.plan.numbers, [](const trace::NumberChoice& n) { return !n.make_path; });
  series.task = [make = std::move(series.task), spawns](std::size_t index) {
    census::Task task = make(index);
    task.spawns = spawns;
    return task;
  };
  return series;
}

std::vector<report::Table> spawned_tables(const Experiment& experiment,
                                          const std::vector<report::LabelledCensus>& counted) {
  return {report::spawned_table(counted, experiment.labels, experiment.name)};
}

Aim above_patch_aim() {
  return {"above",
          [](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
            constexpr double kDistance = 10;
            const auto& patch = member.patches[stream.below(member.patches.size())];
            const double u = stream.unit();
            const double v = stream.unit();
            const auto target = patch.corner + u * patch.side1 + v * patch.side2;
            auto towards = scene::random_direction(stream);
            if (dot(towards, cross(patch.side1, patch.side2)) < 0) {
              towards = -1.0 * towards;
            }
            return scene::ray_from(target + kDistance * towards, target, scene::Held::Float);
          }};
}

std::vector<Series> series_of(const std::vector<Subject>& subjects, const Settings& settings) {
  std::vector<Series> all;
  for (const Subject& subject : subjects) {
    all.push_back(family_series({subject.label}, subject.family, subject.aim,
                                settings.rays / subjects.size(), settings));
  }
  return all;
}

std::vector<method::Method> with_epsilon(const std::vector<method::Method>& methods,
                                         const std::string& tolerance) {
  std::vector<method::Method> result;
  bool any = false;
  for (const method::Method& method : methods) {
    const bool epsilon = method.grouping == method::Grouping::WithinEpsilon;
    if (!epsilon || !any) {
      result.push_back(epsilon ? method::parse_method("epsilon:" + tolerance) : method);
    }
    any = any || epsilon;
  }
  return result;
}

}  // namespace lamina::experiments
