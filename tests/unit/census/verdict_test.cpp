// What a judge counts, on scenes whose truth is plain and with a tracer that says what it is told.
#include "census/verdict.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/fake_tracer.hpp"
#include "support/scenes.hpp"

namespace lamina::census {
namespace {

using csg::Medium;
using Found = support::FakeTracer::Found;
using Counts = std::map<Artifact, std::uint32_t>;

constexpr Medium kA = 1;
constexpr Medium kB = 2;

// Two leaves: from x = low on, and up to x = high.
std::string slab(const std::string& material, int low, int high) {
  return "material(\"" + material + "\") intersection() { halfspace([-1, 0, 0], " +
         std::to_string(-low) + "); halfspace([1, 0, 0], " + std::to_string(high) + "); }\n";
}

class Bench {
 public:
  // The ray goes along x from the origin, so that t is x.
  explicit Bench(const std::string& text)
      : scene_(support::scene_of(text)),
        truth_(scene_),
        judge_(truth_, tracer_, scene_.leaves.size()) {
    truth_.find({{0, 0, 0}, {1, 0, 0}});
  }

  Verdict judge(const std::vector<Found>& found, const method::Report& report,
                double direction_length = 1) {
    tracer_.set(found);
    judge_.match();
    return judge_.judge(report, direction_length);
  }

  [[nodiscard]] const Judge& judge() const { return judge_; }
  [[nodiscard]] const Truth& truth() const { return truth_; }

 private:
  scene::Scene scene_;
  Truth truth_;
  support::FakeTracer tracer_;
  Judge judge_;
};

Found enter(csg::LeafIndex leaf, double t, std::uint16_t index = 0) {
  return {{leaf, index, t > 0, true}, t};
}
Found leave(csg::LeafIndex leaf, double t, std::uint16_t index = 0) {
  return {{leaf, index, t > 0, false}, t};
}

method::Report report(Medium start, const std::vector<method::Interface>& interfaces, Medium end,
                      std::uint32_t inconsistent = 0) {
  return {start, interfaces, end, 0, inconsistent};
}

// Every artifact that is counted, and no other.
void expect_counts(const Verdict& verdict, const Counts& expected) {
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    const auto artifact = static_cast<Artifact>(a);
    const auto found = expected.find(artifact);
    EXPECT_EQ(verdict[artifact], found == expected.end() ? 0U : found->second)
        << artifact_texts()[a].name;
  }
  EXPECT_EQ(verdict.right(), expected.empty());
}

// A slab of a from 2 to 5: leaf 0 is entered at 2, leaf 1 left at 5.
class SlabVerdictTest : public ::testing::Test {
 protected:
  Bench bench_{slab("a", 2, 5)};
  const std::vector<Found> both_{enter(0, 2), leave(1, 5)};
};

TEST_F(SlabVerdictTest, WhatIsRightIsRight) {
  const Verdict verdict = bench_.judge(both_, report(0, {{0, {0, kA}}, {1, {kA, 0}}}, 0));
  expect_counts(verdict, {});
  EXPECT_EQ(verdict.wrong_length, 0);
  EXPECT_EQ(verdict.persistence, 0U);
  EXPECT_TRUE(verdict.first_hit_measured);
  EXPECT_EQ(verdict.first_hit.t_ulps, 1);
  EXPECT_EQ(verdict.first_hit.point_rel, 0.25);
  EXPECT_EQ(verdict.first_hit.normal_rad, 0.5);
  EXPECT_TRUE(bench_.judge().findings().empty());
  EXPECT_EQ(bench_.judge().reported_classes(), (std::vector<bool>{true, true}));
}

TEST_F(SlabVerdictTest, ALostRootIsMissedBySolver) {
  const Verdict verdict = bench_.judge({enter(0, 2)}, report(0, {{0, {0, kA}}}, kA));
  expect_counts(verdict, {{Artifact::MissedSolver, 1},
                          {Artifact::GhostMaterial, 1},
                          {Artifact::Inconsistent, 1},
                          {Artifact::WrongCount, 1},
                          {Artifact::WrongParity, 1}});
  EXPECT_EQ(verdict.wrong_length, 0);  // the interval has no end
  EXPECT_EQ(verdict.persistence, 1U);
  ASSERT_EQ(bench_.judge().findings().size(), 1U);
  EXPECT_EQ(bench_.judge().findings()[0].artifact, Artifact::MissedSolver);
  EXPECT_EQ(bench_.judge().findings()[0].cls, 1U);
  EXPECT_EQ(bench_.judge().findings()[0].crossing, kNoCrossing);
  EXPECT_EQ(bench_.judge().matches(), (std::vector<std::uint32_t>{0, kNoCrossing}));
}

TEST_F(SlabVerdictTest, FoundButNotAcceptedIsMissedByLogic) {
  const Verdict verdict = bench_.judge(both_, report(0, {}, 0), 2);
  expect_counts(verdict,
                {{Artifact::FirstWrong, 1}, {Artifact::MissedLogic, 2}, {Artifact::Void, 1}});
  EXPECT_EQ(verdict.wrong_length, 6);  // 2 to 5, at two units of length to one of t
  EXPECT_EQ(verdict.persistence, 1U);
  EXPECT_FALSE(verdict.first_hit_measured);
}

TEST_F(SlabVerdictTest, FoundBehindTheStartIsMissedByRange) {
  const Verdict verdict =
      bench_.judge({enter(0, -0.5), leave(1, 5)}, report(kA, {{1, {kA, 0}}}, 0));
  expect_counts(
      verdict,
      {{Artifact::FirstWrong, 1}, {Artifact::MissedRange, 1}, {Artifact::GhostMaterial, 1}});
  EXPECT_EQ(verdict.wrong_length, 2);
}

TEST_F(SlabVerdictTest, AnInterfaceOfOtherMediaIsWrong) {
  const Verdict verdict = bench_.judge(both_, report(0, {{0, {0, kB}}, {1, {kB, 0}}}, 0));
  expect_counts(
      verdict,
      {{Artifact::FirstWrong, 1}, {Artifact::WrongInterface, 2}, {Artifact::WrongMedium, 1}});
  EXPECT_EQ(verdict.wrong_length, 3);
  ASSERT_EQ(bench_.judge().findings().size(), 2U);
  EXPECT_EQ(bench_.judge().findings()[1].artifact, Artifact::WrongInterface);
  EXPECT_EQ(bench_.judge().findings()[1].cls, 1U);
  EXPECT_EQ(bench_.judge().findings()[1].crossing, 1U);
}

TEST_F(SlabVerdictTest, AWrongSecondInterfaceLeavesTheFirstRight) {
  const Verdict verdict = bench_.judge(both_, report(0, {{0, {0, kA}}, {1, {kA, kB}}}, kB));
  expect_counts(
      verdict,
      {{Artifact::WrongInterface, 1}, {Artifact::GhostMaterial, 1}, {Artifact::Inconsistent, 1}});
  EXPECT_TRUE(verdict.first_hit_measured);
}

TEST_F(SlabVerdictTest, RejectedEventsAndAWrongEndAreInconsistent) {
  const method::Report wrong_end = report(0, {{0, {0, kA}}, {1, {kA, 0}}}, kA, 2);
  expect_counts(bench_.judge(both_, wrong_end), {{Artifact::Inconsistent, 3}});
}

TEST_F(SlabVerdictTest, AReportThatStartsWrongIsWrongUntilItsFirstInterface) {
  const Verdict verdict = bench_.judge(both_, report(kA, {{0, {0, kA}}, {1, {kA, 0}}}, 0));
  expect_counts(verdict, {{Artifact::GhostMaterial, 1}});
  EXPECT_EQ(verdict.wrong_length, 2);
}

// A ball of radius 1 around (4, 0, 0): its one leaf is entered at 3 and left at 5.
class BallVerdictTest : public ::testing::Test {
 protected:
  Bench bench_{"material(\"a\") translate([4, 0, 0]) sphere(1);"};
};

TEST_F(BallVerdictTest, ALostPairHasTheRightParity) {
  const Verdict verdict = bench_.judge({}, report(0, {}, 0));
  expect_counts(verdict, {{Artifact::FirstWrong, 1},
                          {Artifact::MissedSolver, 2},
                          {Artifact::Void, 1},
                          {Artifact::WrongCount, 1}});
  EXPECT_EQ(verdict.wrong_length, 2);
}

TEST_F(BallVerdictTest, AnInventedPairIsAGhostBehindThePlaceItIsIn) {
  const std::vector<Found> found{enter(0, 3), leave(0, 5, 1), enter(0, 6, 2), leave(0, 7, 3)};
  const Verdict verdict =
      bench_.judge(found, report(0, {{0, {0, kA}}, {1, {kA, 0}}, {2, {0, kA}}, {3, {kA, 0}}}, 0));
  // The invented material begins and ends within one exact interval, and is right behind it.
  expect_counts(verdict, {{Artifact::GhostHit, 2}, {Artifact::WrongCount, 1}});
  EXPECT_EQ(bench_.judge().matches(), (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(bench_.judge().findings().size(), 2U);
  EXPECT_EQ(bench_.judge().findings()[0].cls, 2U);
  EXPECT_EQ(bench_.judge().findings()[0].crossing, 2U);
}

TEST_F(BallVerdictTest, PairsTheNearestWhereSomeAreLeftOver) {
  // The pair nearer to 3 and 5 is matched, though it is the second one.
  bench_.judge({enter(0, 0.5), leave(0, 0.75, 1), enter(0, 3.25, 2), leave(0, 5, 3)},
               report(0, {}, 0));
  EXPECT_EQ(bench_.judge().matches(), (std::vector<std::uint32_t>{2, 3}));
  // As many pairs as possible go before nearness.
  bench_.judge({enter(0, 0.5), leave(0, 0.75, 1), enter(0, 3, 2)}, report(0, {}, 0));
  EXPECT_EQ(bench_.judge().matches(), (std::vector<std::uint32_t>{0, 1}));
}

TEST_F(BallVerdictTest, EnteringIsPairedWithEntering) {
  // A leave nearer to the enter at 3 than to the leave at 5.
  const Verdict verdict = bench_.judge({leave(0, 3.125)}, report(kA, {{0, {kA, 0}}}, 0));
  EXPECT_EQ(bench_.judge().matches(), (std::vector<std::uint32_t>{kNoCrossing, 0}));
  expect_counts(verdict, {{Artifact::FirstWrong, 1},
                          {Artifact::MissedSolver, 1},
                          {Artifact::GhostMaterial, 1},
                          {Artifact::WrongCount, 1},
                          {Artifact::WrongParity, 1}});
  EXPECT_EQ(verdict.wrong_length, 3);
}

TEST_F(BallVerdictTest, EqualCountsArePairedInOrderHoweverFarOff) {
  const Verdict verdict =
      bench_.judge({enter(0, 40), leave(0, 50, 1)}, report(0, {{0, {0, kA}}, {1, {kA, 0}}}, 0));
  expect_counts(verdict, {});
}

// Figure 4: b begins at 2, and so does the plane of a solid a that is elsewhere.
TEST(VerdictTest, ALeafThatDoesNotOwnTheInterfaceIsAGhostSurface) {
  Bench bench(
      "add() { material(\"a\") intersection() { halfspace([-1, 0, 0], -2);"
      " halfspace([0, -1, 0], -9); } material(\"b\") halfspace([-1, 0, 0], -2); }");
  ASSERT_EQ(bench.truth().classes().size(), 1U);
  const std::vector<Found> both{enter(0, 2), enter(2, 2)};
  const Verdict ghost = bench.judge(both, report(0, {{0, {0, kB}}}, kB));
  expect_counts(ghost, {{Artifact::FirstWrong, 1}, {Artifact::GhostSurface, 1}});
  ASSERT_EQ(bench.judge().findings().size(), 1U);
  EXPECT_EQ(bench.judge().findings()[0].artifact, Artifact::GhostSurface);
  expect_counts(bench.judge(both, report(0, {{1, {0, kB}}}, kB)), {});
}

TEST(VerdictTest, OnlyTheOwnersRootsTellWhyAHitIsMissed) {
  Bench bench(
      "add() { material(\"a\") intersection() { halfspace([-1, 0, 0], -2);"
      " halfspace([0, -1, 0], -9); } material(\"b\") halfspace([-1, 0, 0], -2); }");
  // The root of the leaf that is no owner is lost: that is not why.
  const Verdict verdict = bench.judge({enter(2, 2)}, report(0, {}, kB));
  expect_counts(verdict, {{Artifact::FirstWrong, 1},
                          {Artifact::MissedLogic, 1},
                          {Artifact::Void, 1},
                          {Artifact::WrongCount, 1},
                          {Artifact::WrongParity, 1}});
}

// a - a: a lamina at 2 that both enter, another at 5 that both leave.
class LaminaVerdictTest : public ::testing::Test {
 protected:
  Bench bench_{"difference() {\n" + slab("a", 2, 5) + slab("a", 2, 5) + "}"};
  const std::vector<Found> all_{enter(0, 2), enter(2, 2), leave(1, 5), leave(3, 5)};
};

TEST_F(LaminaVerdictTest, UnseenLaminaeAreCounted) {
  const Verdict verdict = bench_.judge(all_, report(0, {}, 0));
  expect_counts(verdict, {});
  EXPECT_EQ(verdict.lamina_fronts, 1U);
  EXPECT_EQ(verdict.lamina_fronts_seen, 0U);
  EXPECT_EQ(verdict.lamina_backs, 1U);
  EXPECT_EQ(verdict.lamina_backs_seen, 0U);
}

TEST_F(LaminaVerdictTest, ASeenFrontIsAGhostHit) {
  const Verdict verdict = bench_.judge(all_, report(0, {{0, {0, kA}}, {1, {kA, 0}}}, 0));
  expect_counts(verdict, {{Artifact::FirstWrong, 1}, {Artifact::GhostHit, 2}});
  EXPECT_EQ(verdict.lamina_fronts_seen, 1U);
  EXPECT_EQ(verdict.lamina_backs_seen, 0U);
  EXPECT_EQ(verdict.persistence, 0U);
}

TEST_F(LaminaVerdictTest, ASeenBackIsAGhostHit) {
  const Verdict verdict = bench_.judge(all_, report(0, {{2, {0, kA}}, {3, {kA, 0}}}, 0));
  expect_counts(verdict, {{Artifact::FirstWrong, 1}, {Artifact::GhostHit, 2}});
  EXPECT_EQ(verdict.lamina_fronts_seen, 0U);
  EXPECT_EQ(verdict.lamina_backs_seen, 1U);
}

// Slabs of a at 1 .. 2, 3 .. 4 and 6 .. 8.
TEST(VerdictTest, PersistenceIsTheLongestRunOfWrongIntervals) {
  Bench bench("add() {\n" + slab("a", 1, 2) + slab("a", 3, 4) + slab("a", 6, 8) + "}");
  const std::vector<Found> all{enter(0, 1), leave(1, 2), enter(2, 3),
                               leave(3, 4), enter(4, 6), leave(5, 8)};
  // Stuck in material from 1 to 6: wrong in 2 .. 3, right in 3 .. 4, wrong in 4 .. 6.
  const Verdict stuck = bench.judge(all, report(0, {{0, {0, kA}}, {5, {kA, 0}}}, 0));
  expect_counts(stuck, {{Artifact::MissedLogic, 4}, {Artifact::GhostMaterial, 2}});
  EXPECT_EQ(stuck.persistence, 1U);
  EXPECT_EQ(stuck.wrong_length, 3);
  // Another material from 1 to 6: wrong four times in a row, then right.
  const Verdict other = bench.judge(all, report(0, {{0, {0, kB}}, {4, {kB, kA}}, {5, {kA, 0}}}, 0));
  expect_counts(other, {{Artifact::FirstWrong, 1},
                        {Artifact::MissedLogic, 3},
                        {Artifact::WrongInterface, 2},
                        {Artifact::GhostMaterial, 2},
                        {Artifact::WrongMedium, 2}});
  EXPECT_EQ(other.persistence, 4U);
  EXPECT_EQ(other.wrong_length, 5);
}

TEST(VerdictTest, NothingSeenIsRightWhereNothingIs) {
  Bench bench("material(\"a\") translate([0, 9, 0]) sphere(1);");
  expect_counts(bench.judge({}, report(0, {}, 0)), {});
  const Verdict ghost =
      bench.judge({enter(0, 1), leave(0, 2, 1)}, report(0, {{0, {0, kA}}, {1, {kA, 0}}}, 0));
  expect_counts(ghost,
                {{Artifact::FirstWrong, 1}, {Artifact::GhostHit, 2}, {Artifact::WrongCount, 1}});
}

TEST(VerdictTest, TextsHaveDistinctNames) {
  std::map<std::string_view, int> names;
  for (const ArtifactText& text : artifact_texts()) {
    EXPECT_EQ(++names[text.name], 1) << text.name;
    EXPECT_FALSE(text.heading.empty());
    EXPECT_TRUE(text.definition.ends_with('.'));
  }
}

}  // namespace
}  // namespace lamina::census
