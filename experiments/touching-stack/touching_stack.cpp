#include <fmt/format.h>

#include <algorithm>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

constexpr std::uint64_t kMostForInsideTests = 100;

// Along the stack, through all cubes.
DrawRay along_the_stack(double cubes) {
  return
      [cubes](const scene::FamilyMember& member, const scene::Scene&, base::SeededStream& stream) {
        constexpr double kMargin = 0.2;
        constexpr double kOutside = 5;
        const auto inner = [&stream] { return stream.uniform(kMargin, 1 - kMargin); };
        const double x = inner();
        const double y = inner();
        const auto origin = member.place({x, y, -kOutside});
        const double to_x = inner();
        return scene::ray_from(origin, member.place({to_x, inner(), cubes}), scene::Held::Float);
      };
}

std::vector<Series> series(const Settings& settings) {
  std::vector<Series> all;
  for (const std::uint64_t cubes : {2, 5, 10, 30, 100, 300, 1000}) {
    // A ray costs as the number of cubes, so the high stacks get fewer.
    const std::uint64_t share = settings.rays / 4;
    const std::uint64_t rays = cubes <= 10 ? share : std::max(share * 10 / cubes, share / 12);
    Series one = family_series({cubes}, fmt::format("touching-stack:{}", cubes),
                               {"stack", along_the_stack(static_cast<double>(cubes))}, rays,
                               settings, cubes <= 10 ? 20 : 5);
    one.plan.random_orders = 4;
    if (cubes > kMostForInsideTests) {
      std::erase_if(one.plan.methods, [](const method::Method& method) {
        return method.status == method::Status::Geometric;
      });
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

Experiment touching_stack() {
  return {.name = "touching-stack",
          .question = "How do errors grow along a stack of touching cubes?",
          .source = "Wyvill and Trotman 1990, section 1: touching solids",
          .labels = {{"cubes", "cubes", "In the stack; every ray goes through all of them."}},
          .default_rays = 2'000,
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
