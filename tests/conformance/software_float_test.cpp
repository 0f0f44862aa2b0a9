// `bin<24>` is `float` and `bin<53>` is `double`, bit for bit, through crossings, grouping and
// the census: number types differ in precision and not in the operations done.
#include <gtest/gtest.h>

#include "census/census.hpp"
#include "method/ray_events.hpp"
#include "number/all_numbers.hpp"
#include "scene/families.hpp"
#include "scene/rays.hpp"
#include "support/class_tally.hpp"
#include "trace/number_choice.hpp"

namespace lamina {
namespace {

using poly::Solver;

constexpr std::uint64_t kSeed = 20;
constexpr std::uint64_t kScenes = 60;
constexpr std::uint64_t kRaysPerScene = 20;

struct Sample {
  scene::Scene scene;
  std::vector<geometry::ExactRay> rays;
};

Sample sample(std::uint64_t case_id) {
  Sample result;
  result.scene = scene::parse_scene(scene::coincident_faces(kSeed, case_id).text,
                                    scene::family_spelling("coincident-faces", kSeed, case_id));
  base::SeededStream stream("conformance/software_float", kSeed, case_id);
  result.rays = scene::uniform_rays(*result.scene.bounds, kRaysPerScene, stream);
  return result;
}

template <typename Pair>
class SoftwareFloatTest : public ::testing::Test {};
using Pairs =
    ::testing::Types<std::pair<float, number::bin<24>>, std::pair<double, number::bin<53>>>;
TYPED_TEST_SUITE(SoftwareFloatTest, Pairs);

TYPED_TEST(SoftwareFloatTest, FindsTheSameCrossings) {
  using Hardware = typename TypeParam::first_type;
  using Software = typename TypeParam::second_type;
  support::ClassTally reached({"quartic", "equal_t", "crossing"});
  // All but those that use cosines and powers, which differ in their last bits.
  for (const auto& [quadratic, quartic] :
       {std::pair(Solver::Textbook, Solver::Monotone), std::pair(Solver::Stable, Solver::Sturm),
        std::pair(Solver::Kahan, Solver::Bernstein), std::pair(Solver::Sturm, Solver::Certified),
        std::pair(Solver::Bernstein, Solver::Laguerre)}) {
    const poly::Solvers solvers{quadratic, quartic};
    for (std::uint64_t case_id = 0; case_id < kScenes; ++case_id) {
      const Sample s = sample(case_id);
      method::RayEvents<Hardware> hardware(s.scene, solvers);
      method::RayEvents<Software> software(s.scene, solvers);
      for (const geometry::ExactRay& ray : s.rays) {
        hardware.find(ray);
        software.find(ray);
        ASSERT_EQ(hardware.crossings().size(), software.crossings().size()) << s.scene.name;
        for (std::size_t i = 0; i < hardware.crossings().size(); ++i) {
          const auto& h = hardware.crossings()[i];
          const auto& b = software.crossings()[i];
          ASSERT_EQ(number::number_traits<Hardware>::to_exact(h.t),
                    number::number_traits<Software>::to_exact(b.t))
              << s.scene.name << " leaf " << h.leaf << " solvers "
              << poly::solver_info(quadratic).name << ", " << poly::solver_info(quartic).name;
          ASSERT_EQ(h.leaf, b.leaf) << s.scene.name;
          ASSERT_EQ(h.index, b.index);
          ASSERT_EQ(h.enters_by_parity, b.enters_by_parity);
          ASSERT_EQ(h.enters_by_normal, b.enters_by_normal);
          for (csg::LeafIndex leaf = 0; leaf < s.scene.leaves.size(); ++leaf) {
            ASSERT_EQ(hardware.inside_at(leaf, h.t), software.inside_at(leaf, b.t));
          }
          reached.add("crossing");
          reached.add("quartic", s.scene.leaves[h.leaf].surface.kind == surface::Kind::Torus);
          reached.add("equal_t", i > 0 && hardware.crossings()[i - 1].t == h.t);
        }
      }
    }
  }
  EXPECT_TRUE(reached.each_at_least(500)) << reached;
}

// Everything that the census counts, in one line a cell.
template <typename Number>
std::vector<std::uint64_t> census_counts() {
  census::Plan plan;
  for (const char* name : {"roth", "wyvill-sharp", "epsilon:1e-4", "epsilon:1e-5:relative",
                           "regularized", "wyvill-trotman"}) {
    plan.methods.push_back(method::parse_method(name));
  }
  plan.numbers = {trace::number_choice<Number>()};
  const census::Census census = census::run_census(
      plan, kScenes,
      [](std::size_t case_id) {
        Sample s = sample(case_id);
        return census::Task{std::move(s.scene), std::move(s.rays)};
      },
      [](auto, auto) { return true; });
  std::vector<std::uint64_t> counts;
  for (const census::Cell& cell : census.cells) {
    counts.insert(counts.end(), cell.with.begin(), cell.with.end());
    counts.insert(counts.end(),
                  {cell.rays, cell.persistence, cell.lamina_fronts_seen, cell.lamina_backs_seen});
    counts.push_back(static_cast<std::uint64_t>(cell.wrong_length * 0x1p20));
    counts.push_back(static_cast<std::uint64_t>(cell.largest.t_ulps * 0x1p10));
  }
  return counts;
}

TYPED_TEST(SoftwareFloatTest, HasTheSameCensus) {
  EXPECT_EQ(census_counts<typename TypeParam::first_type>(),
            census_counts<typename TypeParam::second_type>());
}

}  // namespace
}  // namespace lamina
