#include "experiments/family_census.hpp"

#include <algorithm>

#include "scene/rays.hpp"

namespace lamina::experiments {
namespace {

using Point = geometry::Vector3<double>;

Point point_of_patch(const std::vector<scene::FamilyMember::Patch>& patches,
                     base::SeededStream& stream) {
  const auto& patch = patches[stream.below(patches.size())];
  const double u = stream.unit();
  return patch.corner + u * patch.side1 + stream.unit() * patch.side2;
}

}  // namespace

std::string aim_name(Aim aim) { return aim == Aim::Uniform ? "uniform" : "coincident"; }

report::Column aim_column() {
  return {"aim", "aim",
          "Where rays go: uniform, at a random point of the bounding box; coincident, at a face "
          "that leaves share."};
}

census::Census family_census(const Family& family, Aim aim, std::uint64_t rays,
                             const Settings& settings) {
  constexpr std::uint64_t kRaysPerScene = 20;
  const std::size_t scenes = (rays + kRaysPerScene - 1) / kRaysPerScene;
  const auto task = [&](std::size_t index) {
    const scene::FamilyMember member = family.member(settings.seed, index);
    census::Task result;
    result.scene =
        scene::parse_scene(member.text, scene::family_spelling(family.name, settings.seed, index));
    base::SeededStream stream("rays/" + aim_name(aim), settings.seed, index);
    const std::uint64_t count = std::min(kRaysPerScene, rays - index * kRaysPerScene);
    if (aim == Aim::Uniform) {
      result.rays = scene::uniform_rays(*result.scene.bounds, count, stream);
    } else {
      constexpr double kDistance = 20;  // outside of every member
      for (std::uint64_t i = 0; i < count; ++i) {
        result.rays.push_back(
            scene::ray_through(point_of_patch(member.patches, stream), kDistance, stream));
      }
    }
    return result;
  };
  return census::run_census(settings.plan, scenes, task, settings.progress);
}

}  // namespace lamina::experiments
