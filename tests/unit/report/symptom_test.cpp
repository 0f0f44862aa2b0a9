// What is wrong with rays of scenes where it is plain.
#include "report/symptom.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {
namespace {

using census::Artifact;
using geometry::ExactRay;
using number::Rational;

template <typename Number>
std::optional<Symptom> symptom_of(const std::string& text, const ExactRay& ray,
                                  const std::string& method) {
  return symptom(support::scene_of(text), ray, method::parse_method(method),
                 trace::number_choice<Number>(), {});
}

// The first leaf of the group is inside nothing, and does not own the surface.
constexpr const char* kGhostSurface =
    "intersection() { halfspace([1, 0, 0], 0); halfspace([0, 0, 1], 1); } halfspace([0, 0, 1], 1);";
const ExactRay kDown{{1, 0, 3}, {0, 0, -1}};

TEST(SymptomTest, ARightRayHasNone) {
  EXPECT_FALSE(symptom_of<float>("sphere(1);", {{0, 0, -3}, {0, 0, 1}}, "roth"));
  EXPECT_FALSE(symptom_of<float>(kGhostSurface, kDown, "regularized"));
}

TEST(SymptomTest, ARayInACarrierHasNone) {
  EXPECT_FALSE(symptom_of<float>(kGhostSurface, {{5, 0, 1}, {-1, 0, 0}}, "roth"));
}

TEST(SymptomTest, LogicIsToldFromRounding) {
  const auto logic = symptom_of<float>(kGhostSurface, kDown, "roth");
  ASSERT_TRUE(logic);
  EXPECT_TRUE(logic->first_wrong);
  EXPECT_EQ(logic->artifact, Artifact::GhostSurface);
  EXPECT_EQ(logic->cause, Divergence::Cause::NotOwner);
  EXPECT_TRUE(logic->in_exact);
  EXPECT_EQ(text_of(*logic), "first wrong, ghost surface; in exact numbers too");

  // Nearer to the tangent than bin11 tells.
  const auto rounding = symptom_of<number::bin<11>>(
      "sphere(1);", {{-8, 1 - Rational(1, 65536), 0}, {1, 0, 0}}, "regularized");
  ASSERT_TRUE(rounding);
  EXPECT_EQ(rounding->artifact, Artifact::MissedSolver);
  EXPECT_EQ(rounding->cause, Divergence::Cause::RootMissing);
  EXPECT_FALSE(rounding->in_exact);
  EXPECT_EQ(text_of(*rounding), "first wrong, missed: solver; not in exact numbers");
}

TEST(SymptomTest, TheArtifactIsThatOfTheNearestWrongInterface) {
  // The sphere that bin11 takes for touched lies in front of the ghost surface, which is reported.
  const auto both = symptom_of<number::bin<11>>(
      "sphere(1); intersection() { halfspace([1, 0, 0], 0); halfspace([0, 0, 1], -3); } "
      "halfspace([0, 0, 1], -3);",
      {{1 - Rational(1, 65536), 0, 3}, {0, 0, -1}}, "roth");
  ASSERT_TRUE(both);
  EXPECT_EQ(both->artifact, Artifact::MissedSolver);
}

TEST(SymptomTest, TheSameInTheFirstInterfaceShowsWhatALaterOneDid) {
  const Symptom later{false, Artifact::GhostHit, Divergence::Cause::Split, false};
  Symptom first = later;
  first.first_wrong = true;
  EXPECT_TRUE(later.shows(later));
  EXPECT_TRUE(first.shows(later));
  EXPECT_FALSE(later.shows(first));
  Symptom other = later;
  other.artifact = Artifact::MissedLogic;
  EXPECT_FALSE(other.shows(later));
  other = later;
  other.cause = Divergence::Cause::Swapped;
  EXPECT_FALSE(other.shows(later));
  other = later;
  other.in_exact = true;
  EXPECT_FALSE(other.shows(later));
}

}  // namespace
}  // namespace lamina::report
