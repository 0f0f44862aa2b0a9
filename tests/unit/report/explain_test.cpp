#include "report/explain.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "base/seeded_stream.hpp"
#include "number/all_numbers.hpp"
#include "report/divergence.hpp"
#include "report/outcome.hpp"
#include "report/page.hpp"
#include "scene/rays.hpp"
#include "support/class_tally.hpp"
#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {
namespace {

using census::Artifact;
using geometry::ExactRay;
using method::Method;
using number::Rational;
using support::scene_of;
using trace::NumberChoice;

scene::Scene figure(const std::string& name) {
  return scene::read_scene(LAMINA_SOURCE_DIR "/data/scenes/figure" + name + ".csg");
}

std::vector<Method> methods(const std::vector<std::string>& names) {
  std::vector<Method> result;
  for (const std::string& name : names) {
    result.push_back(method::parse_method(name));
  }
  return result;
}

std::vector<Method> all_methods() {
  return methods({"roth", "wyvill-sharp", "epsilon:1e-6", "epsilon:1e-3:relative", "regularized",
                  "wyvill-trotman", "wyvill-trotman:parity", "wyvill-trotman:no-look-ahead"});
}

template <typename... Numbers>
std::vector<NumberChoice> choices() {
  return {trace::number_choice<Numbers>()...};
}

std::vector<NumberChoice> several_numbers() {
  return choices<float, double, number::bin<11>, number::mpfr<16>, number::exact>();
}

template <typename... Numbers>
std::string explain_in(const scene::Scene& scene, const ExactRay& ray, const std::string& method) {
  return explain(scene, ray, methods({method}), choices<Numbers...>(), {});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++n;
  }
  return n;
}

// The text with line breaks and indents as single spaces: sentences may be broken anywhere.
std::string flowing(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) {
    result += word + " ";
  }
  return result;
}

::testing::AssertionResult says(const std::string& text, const std::string& sentence) {
  if (flowing(text).find(sentence) != std::string::npos) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "no '" << sentence << "' in\n" << text;
}

// Rays from outside through the scene's solids.
std::vector<ExactRay> rays_at(const scene::Scene& scene, std::uint64_t case_id, std::uint64_t n) {
  base::SeededStream stream("report/explain", 1, case_id);
  return scene::uniform_rays(scene.bounds.value_or(scene::Bounds{{-1, -1, -1}, {2, 2, 2}}), n,
                             stream);
}

// The first of the rays on which the method goes wrong in this way.
template <typename Number>
std::optional<ExactRay> find_ray(const scene::Scene& scene, const std::vector<ExactRay>& rays,
                                 const std::string& method, Divergence::Cause cause,
                                 census::Artifact artifact) {
  const Method m = method::parse_method(method);
  const NumberChoice number = trace::number_choice<Number>();
  census::Truth truth(scene);
  for (const ExactRay& ray : rays) {
    truth.find(ray);
    Lane lane(scene, ray, truth, number, {});
    const Outcome outcome(scene, ray, truth, m, lane);
    if (outcome.verdict[artifact] > 0 && first_divergence(outcome).cause == cause) {
      return ray;
    }
  }
  return std::nullopt;
}

const ExactRay kDownOnFigure4{{3, Rational(1) / 4, 5}, {0, 0, -1}};

TEST(ExplainTest, NoLineIsWiderThanThePage) {
  for (const char* name : {"02", "03", "04", "06", "07", "09", "12a", "12b", "12c", "12d", "14_box",
                           "14_cone", "14_cylinder", "14_sphere", "14_torus", "15"}) {
    const scene::Scene scene = figure(name);
    for (const ExactRay& ray : rays_at(scene, 1, 4)) {
      std::istringstream text(explain(scene, ray, all_methods(), several_numbers(), {}));
      for (std::string line; std::getline(text, line);) {
        EXPECT_LE(width_of(line), kPageWidth) << line;
        EXPECT_FALSE(line.ends_with(' ')) << line;
      }
    }
  }
}

TEST(ExplainTest, Figure4RothReportsAGhost) {
  const std::string text = explain_in<double>(figure("04"), kDownOnFigure4, "roth");
  EXPECT_TRUE(says(text, "roth in double: first wrong, ghost surface"));
  EXPECT_TRUE(says(text, "same carrier as B"));
  EXPECT_TRUE(says(text, "interface empty -> B, owned by D"));
  EXPECT_TRUE(says(text, "-> 4 / 0 B leaves"));
  EXPECT_TRUE(says(text,
                   "The interface is reported as B, the first event of its group; B does not "
                   "own it: in no order of these events does B change the medium."));
}

TEST(ExplainTest, Figures6And7WyvillSharpLosesBothSurfaces) {
  for (const char* name : {"06", "07"}) {
    const scene::Scene scene = figure(name);
    const auto ray = find_ray<double>(scene, rays_at(scene, 0, 2000), "wyvill-sharp",
                                      Divergence::Cause::InsideTest, Artifact::MissedLogic);
    ASSERT_TRUE(ray) << "figure " << name;
    const std::string text = explain_in<double>(scene, *ray, "wyvill-sharp");
    EXPECT_TRUE(says(text,
                     "are crossed at exactly the same t, but the inside test finds the "
                     "rounded point of"));
    EXPECT_TRUE(says(text, ": neither is reported."));
  }
}

TEST(ExplainTest, Figure15SingleEventsShowTheLamina) {
  const ExactRay ray{{1, -8, 4}, {Rational(-1) / 8, 1, Rational(-1) / 2}};
  const std::string text = explain_in<double>(figure("15"), ray, "wyvill-trotman");
  EXPECT_TRUE(says(text, "lamina of no thickness: nothing changes"));
  EXPECT_TRUE(says(text, "first wrong, ghost hit x2"));
  EXPECT_TRUE(says(text,
                   "A and B are crossed at exactly the same t, but are processed one at a "
                   "time: behind A alone the medium is sphere."));
}

TEST(ExplainTest, SaysWhatIsRight) {
  const std::string one = explain_in<number::exact>(figure("04"), kDownOnFigure4, "regularized");
  EXPECT_TRUE(says(one, "regularized in exact: right"));
  EXPECT_TRUE(says(one, "C enters ..C. empty interface B -> empty"));
  EXPECT_EQ(one.find("=>"), std::string::npos);

  const std::string all =
      explain(figure("04"), kDownOnFigure4, all_methods(), several_numbers(), {});
  EXPECT_TRUE(says(all, "Right wyvill-sharp in all 5 number types"));
  EXPECT_TRUE(says(all, "regularized in all 5 number types"));
}

TEST(ExplainTest, ADistinctOutcomeIsPrintedOnce) {
  const std::string text =
      explain(figure("04"), kDownOnFigure4, all_methods(), several_numbers(), {});
  EXPECT_EQ(count(text, "Wrong:"), 1);
  EXPECT_TRUE(says(text, "Wrong: first wrong, ghost surface roth in all 5 number types"));
  const std::string some = explain(figure("04"), kDownOnFigure4, methods({"roth"}),
                                   choices<double, number::exact>(), {});
  EXPECT_TRUE(says(some, "roth in double, exact t in double"));
}

TEST(ExplainTest, EqualTSplitByRounding) {
  const scene::Scene scene = scene_of(R"(rotate([17, 29, 43]) translate([1/7, 1/3, 1/10]) {
    material("a") cube([1, 2, 2]);
    material("b") translate([1, 0, 0]) cube([1, 2, 2]);
  })");
  const auto ray = find_ray<float>(scene, rays_at(scene, 0, 400), "regularized",
                                   Divergence::Cause::Split, Artifact::WrongInterface);
  ASSERT_TRUE(ray);
  const std::string text = explain_in<float>(scene, *ray, "regularized");
  EXPECT_TRUE(says(text, "are crossed at exactly the same t; in float they are at t ="));
  EXPECT_TRUE(says(text, ", and so are not processed at once: between them the medium is"));
}

TEST(ExplainTest, DifferentTMerged) {
  const scene::Scene slab = scene_of(
      R"(intersection() { halfspace([1, 0, 0], 1); halfspace([-1, 0, 0], -0.9999999999); })");
  const ExactRay ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(says(explain_in<double>(slab, ray, "epsilon:1e-6"),
                   "In truth B and A are crossed one after the other, at t = 0.9999999999 and 1; "
                   "that is within epsilon, and so they are processed at once."));
  EXPECT_TRUE(says(explain_in<float>(slab, ray, "regularized"),
                   "; in float both are at t = 1, and so are processed at once."));
  EXPECT_TRUE(says(explain_in<double>(slab, ray, "regularized"), "regularized in double: right"));
}

TEST(ExplainTest, OrderSwappedByRounding) {
  const scene::Scene scene = scene_of(R"(rotate([17, 29, 43]) translate([1/7, 1/3, 1/10]) {
    material("a") cube([1, 2, 2]);
    material("b") scale(1/3) translate([3.0000003, 0, 0]) cube([3, 6, 6]);
  })");
  const auto ray = find_ray<float>(scene, rays_at(scene, 0, 4000), "regularized",
                                   Divergence::Cause::Swapped, Artifact::MissedLogic);
  ASSERT_TRUE(ray);
  const std::string text = explain_in<float>(scene, *ray, "regularized");
  EXPECT_TRUE(says(text, "In truth "));
  EXPECT_TRUE(says(text, "; rounding puts "));
}

TEST(ExplainTest, ARootThatIsNotFound) {
  // Nearer to the tangent y = 1 than bin11 tells.
  const ExactRay ray{{-8, 1 - Rational(1) / 65536, 0}, {1, 0, 0}};
  const scene::Scene scene = scene_of("sphere(1);");
  EXPECT_TRUE(says(explain_in<number::bin<11>>(scene, ray, "regularized"),
                   "The solver finds no root for A here; in truth the ray enters it at t ="));
  EXPECT_TRUE(says(explain_in<double>(scene, ray, "regularized"), "regularized in double: right"));
}

TEST(ExplainTest, ARootThatIsNone) {
  const scene::Scene scene = scene_of("torus(R=2, r=1);");
  const auto ray = find_ray<number::bin<11>>(scene, rays_at(scene, 0, 2000), "regularized",
                                             Divergence::Cause::RootInvented, Artifact::WrongCount);
  ASSERT_TRUE(ray);
  const std::string text = explain_in<number::bin<11>>(scene, *ray, "regularized");
  EXPECT_TRUE(says(text, "The solver finds a root for A at t = "));
  EXPECT_TRUE(says(text, "; in truth there is none."));
}

TEST(ExplainTest, TheOtherSideOfTheStart) {
  // float(1/3) is above 1/3, and 3 times it rounds to 1.
  const scene::Scene scene = scene_of("halfspace([3, 0, 0], 1);");
  const ExactRay ray{{Rational(1.0F / 3), 0, 0}, {-1, 0, 0}};
  const std::string text = explain_in<float>(scene, ray, "regularized");
  EXPECT_TRUE(says(text, "In truth A is crossed at t = "));
  EXPECT_TRUE(says(text, ", ahead of the start; here its t comes out as "));
}

TEST(ExplainTest, ATThatOverflows) {
  const scene::Scene scene = scene_of("halfspace([1, 0, 0], 3e38);");
  const ExactRay ray{{0, 0, 0}, {Rational(1) / (1 << 30), 0, 1}};
  EXPECT_TRUE(says(explain_in<float>(scene, ray, "regularized"),
                   "The t of A overflows; in truth it is 3.2212254"));
  EXPECT_TRUE(says(explain_in<double>(scene, ray, "regularized"), "regularized in double: right"));
}

TEST(ExplainTest, TheNormalsSense) {
  const scene::Scene scene = scene_of("torus(R=2, r=1/32);");
  const auto ray = find_ray<number::bin<11>>(scene, rays_at(scene, 0, 2000), "wyvill-trotman",
                                             Divergence::Cause::WrongSense, Artifact::Inconsistent);
  ASSERT_TRUE(ray);
  EXPECT_TRUE(says(explain_in<number::bin<11>>(scene, *ray, "wyvill-trotman"),
                   "By the normal at the rounded point of A the ray "));
}

TEST(ExplainTest, TheLookAheadGoesTooFar) {
  // From the hole in the middle: the point where the ray left the tori behind it is on them,
  // and so inside by f <= 0 of what it enters ahead.
  const scene::Scene scene =
      scene_of(R"(material("a") torus(R=3, r=1); material("b") torus(R=3, r=1);)");
  const ExactRay ray{{0, 0, 0}, {1, 0, 0}};
  const std::string text = explain_in<number::exact>(scene, ray, "wyvill-trotman");
  EXPECT_TRUE(says(text, "The look-ahead (W&T 3.6) crosses A together with B"));
}

TEST(ExplainTest, TouchesCarriersAndWhatIsBehind) {
  const scene::Scene scene = scene_of(R"(sphere(1); halfspace([0, 1, 0], 1);)");
  const std::string text = explain(scene, {{-3, 1, 0}, {1, 0, 0}}, {}, {}, {});
  EXPECT_TRUE(says(text, "The ray touches #0 (sphere[1]) at t = 3 and does not cross it there."));
  EXPECT_TRUE(says(
      text, "The ray lies in the surface of #1 (halfspace[2]): by convention it is outside of it"));
  const std::string behind = explain(scene, {{3, 0, 0}, {1, 0, 0}}, {}, {}, {});
  EXPECT_TRUE(says(behind, "Behind the start, at t <= 0: 2 events."));
  EXPECT_TRUE(says(behind, "Start in default"));
}

TEST(ExplainTest, ManyLeavesAreCutDownToThoseThatMatter) {
  std::string text = "halfspace([0, 0, 1], 1);";
  for (int i = 2; i < 60; ++i) {
    text +=
        fmt::format("intersection() {{ halfspace([0, 0, 1], 1); halfspace([0, 0, -1], -{}); }}", i);
  }
  const std::string explained = explain_in<double>(scene_of(text), {{0, 0, -3}, {0, 0, 1}}, "roth");
  EXPECT_TRUE(says(explained, "those that could matter"));
  EXPECT_TRUE(says(explained, "events: nothing changes"));

  std::string owners;
  for (int i = 0; i < 30; ++i) {
    owners += fmt::format("translate([0, 0, {}]) cube(1);", 2 * i);
  }
  const std::string numbered = explain_in<double>(
      scene_of(owners), {{Rational(1) / 2, Rational(1) / 2, -3}, {0, 0, 1}}, "roth");
  EXPECT_TRUE(says(numbered, "#4 leaf 4"));
  EXPECT_TRUE(says(numbered, "roth in double: right"));
}

// Random degenerate and rounded cases: every wrong outcome has a cause, every right one none.
TEST(ExplainTest, EveryWrongOutcomeHasACause) {
  support::ClassTally reached({"right", "wrong"});
  for (const char* name : {"04", "06", "07", "09", "12a", "12b", "14_box", "14_cone", "14_cylinder",
                           "14_sphere", "14_torus", "15"}) {
    const scene::Scene scene = figure(name);
    census::Truth truth(scene);
    for (ExactRay ray : rays_at(scene, 2, 12)) {
      ray.origin = ray.origin + Rational(1) / 2 * ray.direction;
      truth.find(ray);
      for (const NumberChoice& number : several_numbers()) {
        Lane lane(scene, ray, truth, number, {});
        for (const Method& method : all_methods()) {
          const Outcome outcome(scene, ray, truth, method, lane);
          const Divergence::Cause cause = first_divergence(outcome).cause;
          EXPECT_EQ(cause == Divergence::Cause::None, outcome.verdict.right());
          EXPECT_NE(cause, Divergence::Cause::Unknown)
              << explain(scene, ray, {&method, 1}, {&number, 1}, {});
          reached.add(outcome.verdict.right() ? "right" : "wrong");
        }
      }
    }
  }
  EXPECT_TRUE(reached.each_at_least(200)) << reached;
}

}  // namespace
}  // namespace lamina::report
