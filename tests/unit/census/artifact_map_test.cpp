#include "census/artifact_map.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace lamina::census {
namespace {

using geometry::ExactRay;

constexpr std::size_t kPrimary = 0;
constexpr std::size_t kReflected = 1 + static_cast<std::size_t>(trace::Branch::Reflection);
constexpr std::size_t kTransmitted = 1 + static_cast<std::size_t>(trace::Branch::Transmission);
constexpr std::size_t kShadow = 1 + static_cast<std::size_t>(trace::Branch::Shadow);

FaultCounts faults_of(const std::string& text, const std::string& method, const ExactRay& ray,
                      const std::string& spawn = "none") {
  const scene::Scene scene = support::scene_of(text);
  FaultFinder finder(scene);
  trace::Whitted whitted(scene, trace::make_ray_path<double>(scene, {}),
                         {method::parse_method(method), trace::parse_spawn(spawn), 3}, &finder);
  static_cast<void>(whitted.color(ray));
  return finder.counts();
}

std::uint64_t with(const FaultCounts& counts, std::size_t kind, Fault fault) {
  return counts.with[kind][static_cast<std::size_t>(fault)];
}

std::uint64_t sum(const FaultCounts& counts) {
  std::uint64_t all = 0;
  for (const auto& kind : counts.with) {
    for (const std::uint64_t count : kind) {
      all += count;
    }
  }
  return all;
}

const ExactRay kDown{{0, 0, 5}, {0, 0, -1}};

TEST(FaultFinderTest, ARightTreeHasNoFault) {
  const FaultCounts counts = faults_of(
      "light(position=[0, 0, 9]); material(\"glass\", color=[1, 1, 1, 1/2], mirror=1/2) sphere(1);",
      "wyvill-trotman", kDown);
  EXPECT_FALSE(counts.first);
  EXPECT_EQ(sum(counts), 0U);
  EXPECT_EQ(counts.rays[kPrimary], 1U);
  EXPECT_EQ(counts.rays[kShadow], 1U);
  // In, out, and back in the ball: (t(t)(r(t)(r)))(r).
  EXPECT_EQ(counts.rays[kTransmitted], 3U);
  EXPECT_EQ(counts.rays[kReflected], 3U);
  EXPECT_EQ(counts.unjudged, (std::array<std::uint64_t, kRayKindCount>{}));
}

// (A less nothing) - B of which A and B share a plane: as in the second counterexample to the
// inherited states, A's surface is a ghost where B ends.
constexpr const char* kCleared =
    "difference() { material(\"A\", mirror=1/2) halfspace([0, 0, 1], 0); intersection() { "
    "halfspace([0, 0, -1], 0); halfspace([0, 0, 1], 3); } }";

TEST(FaultFinderTest, NamesWhatIsWrongWithASpawnedRay) {
  const FaultCounts inherited = faults_of(kCleared, "wyvill-trotman", kDown);
  EXPECT_EQ(inherited.first, Fault::GhostHit);
  EXPECT_EQ(with(inherited, kReflected, Fault::GhostHit), 1U);
  EXPECT_EQ(with(inherited, kPrimary, Fault::GhostHit), 0U);
  // What a ghost spawns is not judged.
  EXPECT_GT(inherited.unjudged[kReflected], 0U);
  EXPECT_EQ(sum(inherited), 1U);
  EXPECT_EQ(sum(faults_of(kCleared, "wyvill-trotman:secondary:cluster", kDown)), 0U);
}

TEST(FaultFinderTest, NamesWhatIsWrongWithAPrimaryRay) {
  // A sphere less itself is nothing, and one event at a time it is seen.
  const FaultCounts ghost =
      faults_of("difference() { sphere(1); sphere(1); }", "wyvill-trotman", kDown);
  EXPECT_EQ(ghost.first, Fault::GhostHit);
  EXPECT_EQ(with(ghost, kPrimary, Fault::GhostHit), 1U);
  // Of two coincident materials the first is seen.
  const FaultCounts wrong =
      faults_of("material(\"a\") sphere(1); material(\"b\") sphere(1);", "wyvill-trotman", kDown);
  EXPECT_EQ(wrong.first, Fault::WrongInterface);
  // An epsilon as thick as the ball.
  const FaultCounts missed = faults_of("sphere(1);", "epsilon:3", kDown);
  EXPECT_EQ(missed.first, Fault::MissedHit);
}

TEST(FaultFinderTest, NamesWhatAnOffsetDoes) {
  const std::string mirror =
      "material(\"m\", mirror=1/2) halfspace([0, 0, 1], 0); material(\"w\") halfspace([0, 0, -1], "
      "-6);";
  EXPECT_EQ(sum(faults_of(mirror, "regularized", kDown, "offset:1")), 0U);
  // Started beyond the wall's face, the reflected ray misses it, in the wall's medium.
  EXPECT_EQ(faults_of(mirror, "regularized", kDown, "offset:7").first, Fault::MissedHit);
}

TEST(FaultFinderTest, FindsShadowsOfASurfaceOnItself) {
  int self = 0;
  for (int i = 1; i <= 40; ++i) {
    const ExactRay ray{{number::Rational(i, 64), 0, 5}, {0, number::Rational(1, 64), -1}};
    const FaultCounts counts = faults_of(
        "light(position=[9, 9, 40]); translate([1/3, 0, 1/7]) sphere(1);", "regularized", ray);
    EXPECT_EQ(sum(counts), with(counts, kShadow, Fault::SelfIntersection));
    self += sum(counts) > 0 ? 1 : 0;
  }
  EXPECT_GT(self, 3);
  EXPECT_LT(self, 37);
}

TEST(FaultFinderTest, CountsAddUp) {
  const FaultCounts one = faults_of(kCleared, "wyvill-trotman", kDown);
  FaultCounts sum_of;
  sum_of.add(one);
  sum_of.add(one);
  EXPECT_EQ(sum_of.rays[kReflected], 2 * one.rays[kReflected]);
  EXPECT_EQ(sum_of.unjudged[kReflected], 2 * one.unjudged[kReflected]);
  EXPECT_EQ(with(sum_of, kReflected, Fault::GhostHit), 2U);
}

}  // namespace
}  // namespace lamina::census
