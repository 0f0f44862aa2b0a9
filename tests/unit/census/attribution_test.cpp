// Rays whose cause is known by argument: the level scenes are written out as text, with the
// numbers that rounding leaves, and their truth is looked at.
#include "census/attribution.hpp"

#include <gtest/gtest.h>

#include "census/census.hpp"
#include "number/all_numbers.hpp"
#include "scene/families.hpp"
#include "scene/rays.hpp"
#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {
namespace {

using geometry::ExactRay;
using number::Rational;
using support::scene_of;
using trace::NumberChoice;

std::vector<NumberChoice> all_numbers() {
  std::vector<NumberChoice> numbers;
#define LAMINA_CHOICE(Number) numbers.push_back(trace::number_choice<Number>());
  LAMINA_FOR_EACH_NUMBER(LAMINA_CHOICE)
#undef LAMINA_CHOICE
  return numbers;
}

// One method in one number type.
class Bench {
 public:
  Bench(scene::Scene scene, const std::string& method, const NumberChoice& number)
      : scene_(std::move(scene)),
        methods_{method::parse_method(method)},
        numbers_{number},
        truth_(scene_),
        tracer_(number.make_tracer(scene_, {})),
        judge_(truth_, *tracer_, scene_.leaves.size()),
        attribution_(scene_, truth_, methods_, numbers_) {}

  // The cause's name, or `right`.
  std::string cause(const ExactRay& ray) {
    truth_.find(ray);
    tracer_->find(ray);
    judge_.match();
    method::Report report;
    tracer_->run(methods_[0], report);
    if (judge_.judge(report, 1)[Artifact::FirstWrong] == 0) {
      return "right";
    }
    attribution_.find(ray);
    return std::string(cause_texts()[static_cast<std::size_t>(attribution_.cause(0, 0))].name);
  }

 private:
  scene::Scene scene_;
  std::vector<method::Method> methods_;
  std::vector<NumberChoice> numbers_;
  Truth truth_;
  std::unique_ptr<method::Tracer> tracer_;
  Judge judge_;
  Attribution attribution_;
};

template <typename Number>
std::string cause(const std::string& text, const ExactRay& ray,
                  const std::string& method = "regularized") {
  return Bench(scene_of(text), method, trace::number_choice<Number>()).cause(ray);
}

// The first interface of the truth, `from>to`.
std::string first_seen(const std::string& text, const ExactRay& ray) {
  const scene::Scene scene = scene_of(text);
  Truth truth(scene);
  truth.find(ray);
  for (const TruthClass& cls : truth.classes()) {
    if (cls.is_interface()) {
      const auto [from, to] = cls.effect.transition;
      return scene.materials[from].name + ">" + scene.materials[to].name;
    }
  }
  return "nothing";
}

TEST(AttributionTest, AnEpsilonThatIsTooWideIsTheModelsErrorInEveryNumberType) {
  for (const NumberChoice& number : all_numbers()) {
    Bench bench(scene_of("cube([9, 9, 1/2]);"), "epsilon:1", number);
    EXPECT_EQ(bench.cause({{1, 2, -5}, {0, 0, 1}}), "model") << number.name;
    // Slanted, the slab is thick enough.
    EXPECT_EQ(bench.cause({{1, 2, -1}, {4, 0, 1}}), "right") << number.name;
  }
}

TEST(AttributionTest, RothsGhostIsTheModelsErrorInEveryNumberType) {
  for (const NumberChoice& number : all_numbers()) {
    Bench bench(scene::read_scene(LAMINA_SOURCE_DIR "/data/scenes/figure04.csg"), "roth", number);
    EXPECT_EQ(bench.cause({{3, 0, 5}, {0, 0, -1}}), "model") << number.name;
    EXPECT_EQ(bench.cause({{0, 0, 5}, {0, 0, -1}}), "right") << number.name;
  }
}

// 1/3 + 4 and 13/3: with 24 bits the second is rounded up by more than the first.
TEST(AttributionTest, FacesThatRoundingTakesApartAreARepresentationError) {
  const auto text = [](const std::string& low, const std::string& high) {
    return "add() { material(\"a\") translate([0, 0, " + low +
           "]) cube([1, 1, 4]); material(\"b\") translate([0, 0, " + high + "]) cube(1); }";
  };
  const ExactRay ray{{Rational(1, 2), Rational(1, 2), 4}, {0, 0, 1}};
  const std::string ideal = text("1/3", "13/3");
  EXPECT_EQ(first_seen(ideal, ray), "a>b");
  EXPECT_EQ(first_seen(text("11184811/33554432", "9087659/2097152"), ray), "a>");
  EXPECT_EQ(cause<float>(ideal, ray), "representation");
  EXPECT_EQ(cause<number::bin<24>>(ideal, ray), "representation");
  EXPECT_EQ(cause<double>(ideal, ray), "right");  // rounded down, b begins inside of a
  EXPECT_EQ(cause<number::exact>(ideal, ray), "right");
}

// Half a unit in the last place off, the ray becomes a tangent.
TEST(AttributionTest, ARayThatRoundingMovesIsARepresentationError) {
  const ExactRay ray{{1 - Rational(1, 1 << 30), -3, 0}, {0, 1, 0}};
  EXPECT_EQ(first_seen("sphere(1);", ray), ">default");
  EXPECT_EQ(first_seen("sphere(1);", {{1, -3, 0}, {0, 1, 0}}), "nothing");
  EXPECT_EQ(cause<float>("sphere(1);", ray), "representation");
  EXPECT_EQ(cause<double>("sphere(1);", ray), "right");
}

TEST(AttributionTest, WhatOverflowsIsARepresentationError) {
  EXPECT_EQ(cause<float>("sphere(1e30);", {{0, 0, 0}, {1, 0, 0}}), "representation");
  EXPECT_EQ(cause<double>("sphere(1e30);", {{0, 0, 0}, {1, 0, 0}}), "right");
  EXPECT_EQ(cause<float>("sphere(1);", {{number::parse_rational("1e39"), 0, 0}, {-1, 0, 0}}),
            "representation");
}

// 3 is held by all types and 1/3 by none: with 24 bits and with 64 it is rounded up, and a scaled
// by its inverse ends below 3.
TEST(AttributionTest, AnInverseThatIsRoundedIsAConstructionError) {
  const auto text = [](const std::string& scale) {
    return "add() { material(\"a\") scale([1, 1, " + scale +
           "]) cube(1); material(\"b\") translate([0, 0, 3]) cube(1); }";
  };
  const ExactRay ray{{Rational(1, 2), Rational(1, 2), 1}, {0, 0, 1}};
  const std::string ideal = text("3");
  EXPECT_EQ(first_seen(ideal, ray), "a>b");
  EXPECT_EQ(first_seen(text("33554432/11184811"), ray), "a>");
  EXPECT_EQ(cause<float>(ideal, ray), "construction");
  EXPECT_EQ(cause<number::bin<24>>(ideal, ray), "construction");
  EXPECT_EQ(cause<number::bin<64>>(ideal, ray), "construction");
  EXPECT_EQ(cause<double>(ideal, ray), "right");
}

// All numbers are held exactly, the inverse maps too; 8 - 2^-23 is not, and a's end comes out
// at t = 0.
TEST(AttributionTest, WhatOnlyArithmeticGetsWrongIsAComputationError) {
  const std::string text =
      "add() { material(\"a\") translate([0, 0, -8]) cube([1, 1, 8]); material(\"b\") cube(1); }";
  const ExactRay ray{{Rational(1, 2), Rational(1, 2), -Rational(1, 1 << 23)}, {0, 0, 1}};
  EXPECT_EQ(first_seen(text, ray), "a>b");
  EXPECT_EQ(cause<float>(text, ray), "computation");
  EXPECT_EQ(cause<number::bin<24>>(text, ray), "computation");
  EXPECT_EQ(cause<double>(text, ray), "right");
}

// Rounding would do it, too.
TEST(AttributionTest, TheFirstStepIsTheCause) {
  const std::string text =
      "add() { material(\"a\") scale([1, 1, 3]) cube(1); material(\"b\") translate([0, 0, 3]) "
      "cube(1); }";
  const ExactRay ray{{Rational(1, 2), Rational(1, 2), 1}, {0, 0, 1}};
  EXPECT_EQ(cause<float>(text, ray, "epsilon:1e-9"), "construction");
  EXPECT_EQ(cause<float>(text, ray, "epsilon:10"), "model");
}

TEST(AttributionTest, CountsWhatExactArithmeticMissesToo) {
  const scene::Scene scene = scene_of("cube([9, 9, 1/2]); translate([0, 0, 10]) cube([9, 9, 3]);");
  const std::vector<method::Method> methods{method::regularized(),
                                            method::parse_method("epsilon:1")};
  const std::vector<NumberChoice> numbers{trace::number_choice<float>()};
  Truth truth(scene);
  Attribution attribution(scene, truth, methods, numbers);
  const ExactRay ray{{1, 2, -5}, {0, 0, 1}};
  truth.find(ray);
  ASSERT_EQ(truth.classes().size(), 4U);
  attribution.find(ray);
  EXPECT_EQ(attribution.missed_in_exact(1, std::vector<bool>(4, false)), 2U);
  EXPECT_EQ(attribution.missed_in_exact(1, {true, false, false, true}), 1U);
  EXPECT_EQ(attribution.missed_in_exact(1, std::vector<bool>(4, true)), 0U);
  EXPECT_EQ(attribution.missed_in_exact(0, std::vector<bool>(4, false)), 0U);
  // On the next ray nothing of this one is left.
  const ExactRay slanted{{1, 2, -1}, {4, 0, 1}};
  truth.find(slanted);
  attribution.find(slanted);
  EXPECT_EQ(attribution.missed_in_exact(1, std::vector<bool>(truth.classes().size(), false)), 0U);
}

// Rays at the patches of members of coincident-faces.
Census census_of_coincident_faces(const Plan& plan, std::size_t tasks, std::uint64_t rays_each) {
  constexpr std::uint64_t kSeed = 7;
  return run_census(
      plan, tasks,
      [rays_each](std::size_t case_id) {
        const scene::FamilyMember member = scene::coincident_faces(kSeed, case_id);
        Task task{scene_of(member.text), {}};
        for (std::uint64_t i = 0; i < rays_each; ++i) {
          base::SeededStream stream("attribution_test", case_id, i);
          const auto& patch = member.patches[stream.below(member.patches.size())];
          const double u = stream.unit();
          const double v = stream.unit();
          task.rays.push_back(scene::ray_through(patch.corner + u * patch.side1 + v * patch.side2,
                                                 stream.uniform(0, 20), stream));
        }
        return task;
      },
      [](auto, auto) { return true; });
}

TEST(AttributionTest, EveryRayThatIsFirstWrongHasOneCause) {
  Plan plan;
  for (const char* method : {"roth", "wyvill-sharp", "epsilon:1e-3", "regularized",
                             "wyvill-trotman", "wyvill-trotman:reference:1/1000"}) {
    plan.methods.push_back(method::parse_method(method));
  }
  plan.numbers = {trace::number_choice<number::bin<11>>(), trace::number_choice<float>(),
                  trace::number_choice<number::exact>()};
  const Census census = census_of_coincident_faces(plan, 24, 6);
  std::array<std::uint64_t, kCauseCount> caused{};
  for (std::size_t c = 0; c < census.cells.size(); ++c) {
    const Cell& cell = census.cells[c];
    SCOPED_TRACE(cell.method + " " + cell.number);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kCauseCount; ++i) {
      sum += cell.caused[i];
      caused[i] += cell.caused[i];
    }
    const std::uint64_t wrong = cell[Artifact::FirstWrong];
    const std::uint64_t by_model = cell.caused[static_cast<std::size_t>(Cause::Model)];
    EXPECT_EQ(sum, wrong);
    EXPECT_LE(by_model, census.cells[c - c % 3 + 2][Artifact::FirstWrong]);
    if (cell.number == "exact") {
      EXPECT_EQ(by_model, wrong);
    }
    if (cell.method == "regularized") {
      EXPECT_EQ(by_model, 0U);
    }
  }
  for (std::size_t i = 0; i < kCauseCount; ++i) {
    EXPECT_GE(caused[i], 5U) << cause_texts()[i].name;
  }
}

}  // namespace
}  // namespace lamina::census
