#include "census/path_truth.hpp"

#include <gtest/gtest.h>

#include "census/spawned_census.hpp"
#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {
namespace {

using geometry::ExactPoint;
using geometry::ExactRay;
using number::Rational;

// Glass below z = 0, a wall above z = 6.
constexpr const char* kScene =
    "material(\"wall\") halfspace([0, 0, -1], -6);\n"
    "material(\"glass\") halfspace([0, 0, 1], 0);";

class PathTruthTest : public ::testing::Test {
 protected:
  void spawn(const std::string& text, const ExactRay& ray, const ExactPoint& direction) {
    scene_ = support::scene_of(text);
    truth_.emplace(scene_);
    truth_->start(ray);
    ASSERT_NE(truth_->first(), nullptr);
    decided_ = truth_->spawn(direction);
  }

  [[nodiscard]] std::string name(csg::Medium medium) const { return scene_.materials[medium].name; }

  scene::Scene scene_;
  std::optional<PathTruth> truth_;
  bool decided_ = false;
};

TEST_F(PathTruthTest, TheStartIsNoCrossing) {
  spawn(kScene, {{0, 0, 5}, {0, 0, -1}}, {0, 0, 1});
  ASSERT_TRUE(decided_);
  EXPECT_EQ(name(truth_->start_medium()), "");
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_EQ(truth_->classes()[0].s, 6);
  EXPECT_EQ(name(truth_->classes()[0].effect.transition.to), "wall");
  EXPECT_FALSE(truth_->starts_on(0));
  EXPECT_TRUE(truth_->starts_on(1));

  spawn(kScene, {{0, 0, 5}, {0, 0, -1}}, {1, 0, -1});
  ASSERT_TRUE(decided_);
  EXPECT_EQ(name(truth_->start_medium()), "glass");
  EXPECT_TRUE(truth_->classes().empty());
}

// The chord from (0, 0, 1) in direction (1, 0, -2) of the unit sphere ends at s = 4/5; the other
// sphere, with its equation times 3, has the same points, and so the same class.
TEST_F(PathTruthTest, FindsTheFarSideOfTheSurfaceItStartsOn) {
  spawn("sphere(1); quadric([[3, 0, 0, 0], [0, 3, 0, 0], [0, 0, 3, 0], [0, 0, 0, -3]]);",
        {{0, 0, 5}, {0, 0, -1}}, {1, 0, -2});
  ASSERT_TRUE(decided_);
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_DOUBLE_EQ(truth_->classes()[0].s, 0.8);
  EXPECT_EQ(truth_->classes()[0].events, 2u);
}

// Two planes of different equations meet where the ray arrives: no precision tells their order.
TEST_F(PathTruthTest, AnEdgeOfOtherSurfacesIsUndecided) {
  const std::string edge =
      "halfspace([0, 0, 1], 0); halfspace([1, 0, -1], -5); "
      "halfspace([2, 1, -2], -10);";
  spawn(edge, {{0, 0, 5}, {0, 0, -1}}, {0, 0, 1});
  EXPECT_FALSE(decided_);
  spawn(edge, {{0, 0, 5}, {0, 0, -1}}, {0, Rational(1, 7), 1});
  EXPECT_TRUE(decided_);
}

TEST_F(PathTruthTest, GoesOnFromASpawnedHit) {
  spawn(kScene, {{0, 0, 5}, {0, 0, -1}}, {1, 0, 2});
  ASSERT_TRUE(decided_);
  ASSERT_EQ(truth_->classes().size(), 1u);
  ASSERT_TRUE(truth_->spawn({0, 0, -3}));
  EXPECT_EQ(name(truth_->start_medium()), "");
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_EQ(truth_->classes()[0].s, 2);
  EXPECT_EQ(name(truth_->first()->effect.transition.to), "glass");
  truth_->back();
  EXPECT_EQ(name(truth_->first()->effect.transition.to), "wall");
  // Spawned anew from the same hit, in the same direction and in another one.
  ASSERT_TRUE(truth_->spawn({0, 0, -3}));
  EXPECT_EQ(truth_->classes()[0].s, 2);
  truth_->back();
  ASSERT_TRUE(truth_->spawn({0, 0, -1}));
  EXPECT_EQ(truth_->classes()[0].s, 6);
}

// A turned rectangle is a cylinder of radius 2: reflected by its wall to another place of the wall,
// and from there to its bottom.
TEST_F(PathTruthTest, DecidesWhatASweptContourReflects) {
  spawn("rotational_sweep() contour([[0, 0], [2, 0], [2, 5], [0, 5]], kind=\"line\");",
        {{0, 0, 6}, {1, 0, -2}}, {1, 0, -2});
  ASSERT_TRUE(decided_);  // inside, from the top at (1/2, 0, 5)
  EXPECT_EQ(name(truth_->start_medium()), "default");
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_EQ(truth_->classes()[0].s, 1.5);
  ASSERT_TRUE(truth_->spawn({-1, 1, 0}));  // at (2, 0, 2)
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_EQ(truth_->classes()[0].s, 2);
  EXPECT_TRUE(truth_->starts_on(0));
  ASSERT_TRUE(truth_->spawn({0, -Rational(1, 2), -1}));  // at (0, 2, 2)
  ASSERT_EQ(truth_->classes().size(), 1u);
  EXPECT_EQ(truth_->classes()[0].s, 2);
}

// Counts of one ray whose reflection starts off by what a policy adds.
Cell judge(const std::string& text, const std::string& method, const ExactRay& ray,
           const std::vector<trace::Spawn>& spawns) {
  const Plan plan{{method::parse_method(method)}, {trace::number_choice<double>()}, {}, 1};
  return run_spawned(plan, {support::scene_of(text), {ray}, spawns}).cells.at(0);
}

constexpr auto kDown = [] { return ExactRay{{0, 0, 5}, {0, 0, -1}}; };

TEST(SpawnedCensusTest, ARightRayHasNoArtifact) {
  const Cell cell = judge(kScene, "regularized", kDown(), {{}});
  EXPECT_EQ(cell.rays, 1u);
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    EXPECT_EQ(cell.with[a], 0u) << artifact_texts()[a].name;
  }
}

// Started 7 beyond the hit, the reflected ray is in the wall, and misses it.
TEST(SpawnedCensusTest, AnOffsetJumpsOverAnInterface) {
  const Cell cell =
      judge(kScene, "regularized", kDown(), {{.policy = trace::parse_spawn("offset:7")}});
  EXPECT_EQ(cell[Artifact::FirstWrong], 1u);
  EXPECT_EQ(cell[Artifact::MissedRange], 1u);
  EXPECT_EQ(cell[Artifact::GhostMaterial], 1u);
}

// z = 1/3 in double, reached from 1/10: the point is off the plane, on either side.
TEST(SpawnedCensusTest, FindsSelfIntersections) {
  int wrong = 0;
  for (int i = 1; i <= 64; ++i) {
    const ExactRay ray{{Rational(i, 8), 0, 1},
                       {Rational(1, 16), Rational(i, 64), Rational(-37, 64)}};
    const Cell cell =
        judge("translate([0, 0, 1/3]) halfspace([1/7, 0, 1], 0);", "regularized", ray, {{}});
    EXPECT_EQ(cell.rays, 1u);
    EXPECT_EQ(cell[Artifact::SelfIntersection], cell[Artifact::FirstWrong]);
    wrong += static_cast<int>(cell[Artifact::SelfIntersection]);
    EXPECT_EQ(judge("translate([0, 0, 1/3]) halfspace([1/7, 0, 1], 0);", "wyvill-trotman", ray,
                    {{}})[Artifact::FirstWrong],
              0u);
  }
  EXPECT_GT(wrong, 5);
  EXPECT_LT(wrong, 59);
}

TEST(SpawnedCensusTest, ShadowRaysSeeNothingBehindTheLight) {
  const auto shadow = [](const Rational& height) {
    return trace::Spawn{.branch = trace::Branch::Shadow, .light = {0, 1, height}};
  };
  for (const auto& [height, blocked] : {std::pair{Rational(5), false}, {Rational(7), true}}) {
    const Cell cell = judge(kScene, "wyvill-trotman", kDown(), {shadow(height)});
    EXPECT_EQ(cell[Artifact::FirstWrong], 0u);
    // Started beyond the wall's face, a ray does not see it: wrong only if the light is behind.
    trace::Spawn jumped = shadow(height);
    jumped.policy = trace::parse_spawn("offset:13/2");
    EXPECT_EQ(judge(kScene, "wyvill-trotman", kDown(), {jumped})[Artifact::FirstWrong],
              blocked ? 1u : 0u);
  }
}

TEST(SpawnedCensusTest, APathThatHitsNothingIsNotSpawned) {
  const Cell miss = judge(kScene, "regularized", {{0, 0, 5}, {1, 0, 0}}, {{}});
  EXPECT_EQ(miss.not_spawned, 1u);
  EXPECT_EQ(miss.rays, 0u);
  const Cell second = judge("sphere(1);", "regularized", kDown(), {{}, {}});
  EXPECT_EQ(second.not_spawned, 1u);
}

// Up and down between glass and wall: the fourth ray is as right as the first.
TEST(SpawnedCensusTest, FollowsAPathOfReflections) {
  for (const char* method : {"regularized", "wyvill-trotman", "wyvill-trotman:secondary:cluster"}) {
    const Cell cell = judge(kScene, method, kDown(), {{}, {}, {}, {}});
    EXPECT_EQ(cell.rays, 1u) << method;
    EXPECT_EQ(cell[Artifact::FirstWrong], 0u) << method;
  }
}

}  // namespace
}  // namespace lamina::census
