#include "trace/whitted.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.hpp"

namespace lamina::trace {
namespace {

using geometry::ExactRay;

constexpr const char* kMethod = "wyvill-trotman:secondary:cluster";
// Some hundred operations in double on numbers up to 100: 100 * 100 * 2^-53 = 1.1e-12, and the
// colours are at most 1.5.
constexpr double kTolerance = 2e-12;

// The colour of one ray, in double.
Color color_of(const std::string& text, const ExactRay& ray, int depth = 5,
               TreeObserver* observer = nullptr) {
  const scene::Scene scene = support::scene_of(text);
  Whitted whitted(scene, make_ray_path<double>(scene, {}),
                  {method::parse_method(kMethod), {}, depth}, observer);
  return whitted.color(ray);
}

void expect_near(const Color& color, const Color& expected) {
  EXPECT_NEAR(color.x, expected.x, kTolerance);
  EXPECT_NEAR(color.y, expected.y, kTolerance);
  EXPECT_NEAR(color.z, expected.z, kTolerance);
}

ExactRay down(int x = 0) { return {{x, 0, 5}, {0, 0, -1}}; }

const std::string kFloor =
    "material(\"floor\", color=[1, 0.5, 0.25], ambient=0.2, diffuse=0.6, specular=0) "
    "halfspace([0, 0, 1], 0);";

TEST(WhittedTest, NothingIsTheBackground) {
  expect_near(color_of("sphere(1); background(color=[0.1, 0.2, 0.3]);", {{0, 0, 5}, {1, 0, 0}}),
              {0.1, 0.2, 0.3});
}

TEST(WhittedTest, DiffuseLightFollowsTheCosine) {
  expect_near(color_of(kFloor, down()), {0.2, 0.1, 0.05});
  expect_near(color_of(kFloor + "light(position=[0, 0, 10]);", down()), {0.8, 0.4, 0.2});
  // 3, 4, 5: the cosine is 4/5.
  expect_near(color_of(kFloor + "light(position=[3, 0, 4], color=[0, 1, 1]);", down()),
              {0.2, 0.5 * (0.2 + 0.6 * 0.8), 0.25 * (0.2 + 0.6 * 0.8)});
  // Two lights add up; one below the floor does not count.
  expect_near(color_of(kFloor + "light(position=[0, 0, 9]); light(position=[0, 0, 7]); "
                                "light(position=[0, 1, -3]);",
                       down()),
              {1.4, 0.7, 0.35});
}

TEST(WhittedTest, HighlightsAreWhereTheMirroredRayMeetsTheLight) {
  const std::string shiny =
      "material(\"shiny\", color=[0, 0, 0], specular=0.5, shininess=2) halfspace([0, 0, 1], 0);";
  expect_near(color_of(shiny + "light(position=[0, 0, 3]);", down()), {0.5, 0.5, 0.5});
  // The cosine to the power of shininess.
  expect_near(color_of(shiny + "light(position=[3, 0, 4]);", down()), {0.32, 0.32, 0.32});
}

TEST(WhittedTest, ShadowsAreDarkAndGlassWeakensLight) {
  const std::string lamp = "light(position=[0, 0, 40], color=[1, 1, 1]);";
  const ExactRay slanting{{10, 0, 10}, {-1, 0, -1}};
  expect_near(color_of(kFloor + "translate([0, 0, 20]) sphere(1);" + lamp, slanting),
              {0.2, 0.1, 0.05});
  // A light between the surface and the obstacle shines on it.
  expect_near(color_of(kFloor + "translate([0, 0, 50]) sphere(1);" + lamp, slanting),
              {0.8, 0.4, 0.2});
  // One ball of glass is entered once: its opacity counts once.
  expect_near(color_of(kFloor +
                           "material(\"glass\", color=[1, 1, 1, 1/4]) translate([0, 0, 20]) "
                           "sphere(1);" +
                           lamp,
                       slanting),
              {0.2 + 0.75 * 0.6, 0.1 + 0.75 * 0.3, 0.05 + 0.75 * 0.15});
}

// K panes of opacity 1/4 leave (3/4)^K of what is behind.
TEST(WhittedTest, PanesLetThroughWhatTheirOpacitySays) {
  std::string panes = "background(color=[1, 1, 1]); ";
  for (int k = 1; k <= 4; ++k) {
    panes += "material(\"pane\", color=[0, 0, 0, 1/4]) translate([-1, -1, " +
             std::to_string(-2 * k) + "]) cube([2, 2, 1]);";
    const double through = std::pow(0.75, k);
    expect_near(color_of(panes, down(), 2 * k), {through, through, through});
    // A tree that is not deep enough ends in the dark.
    expect_near(color_of(panes, down(), 2 * k - 1), {0, 0, 0});
  }
}

// Between two mirrors of factor 1/2 with a colour of their own: a geometric series.
TEST(WhittedTest, MirrorsAddUpAGeometricSeries) {
  const std::string mirrors =
      "material(\"mirror\", color=[1, 1, 0], ambient=1, diffuse=0, specular=0, mirror=1/2) {"
      "halfspace([0, 0, 1], 0); halfspace([0, 0, -1], -9); }";
  for (int depth = 0; depth <= 6; ++depth) {
    const double sum = 1 - std::pow(0.5, depth + 1);
    expect_near(color_of(mirrors, down(), depth), {sum, sum, 0});
  }
}

// Where everything shines alike, and no light is lost, everything looks alike: what is reflected,
// transmitted and a surface's own adds up to one.
TEST(WhittedTest, NoEnergyIsLostOrMade) {
  const std::string room = "background(color=[1, 1, 1]); ";
  for (const char* look : {"color=[1, 1, 1, 0], mirror=1/4", "color=[1, 1, 1, 1/2], mirror=0",
                           "color=[1, 1, 1, 1/2], mirror=1/8, index=3/2",
                           "color=[1, 1, 1, 1], mirror=1", "color=[1, 1, 1, 1/8], index=1/2"}) {
    const std::string ball =
        std::string("material(\"m\", ambient=1, diffuse=0, specular=0, ") + look + ") sphere(1);";
    const Color color = color_of(room + ball, {{number::Rational(1, 2), 0, 5}, {0, 0, -1}}, 12);
    // Beyond the depth 12 light is lost that was reflected at least 10 times in the ball: at most
    // (1/4)^10 of it, 9.6e-7.
    EXPECT_NEAR(color.x, 1, 1e-6) << look;
    EXPECT_LE(color.x, 1 + kTolerance) << look;
  }
}

TEST(WhittedTest, ReflectsAllLightBeyondTheCriticalAngle) {
  // From inside of glass of index 3/2 at 45 degrees: up and down between the faces, for ever.
  const std::string glass =
      "background(color=[1, 1, 1]); material(\"glass\", color=[0, 0, 0, 0], index=3/2) "
      "intersection() { halfspace([0, 0, 1], 1); halfspace([0, 0, -1], 1); "
      "halfspace([1, 0, 0], 7/2); }";
  expect_near(color_of(glass, {{0, 0, 0}, {1, 0, 1}}, 3), {0, 0, 0});
  // Less slanting it leaves at once.
  expect_near(color_of(glass, {{0, 0, 0}, {1, 0, 3}}, 3), {1, 1, 1});
}

TEST(WhittedTest, TexturesMixTheTwoColors) {
  scene::Material material;
  material.color = {1, 0.5, 0, 1};
  material.second_color = {0, 0.5, 1};
  material.grain = 0.5;
  EXPECT_EQ(texture_color(material, {3, 4, 5}).x, 1);
  material.texture = scene::Texture::Checker;
  EXPECT_EQ(texture_color(material, {0.1, 0.1, 0.1}).x, 1);
  EXPECT_EQ(texture_color(material, {0.6, 0.1, 0.1}).x, 0);
  EXPECT_EQ(texture_color(material, {0.6, -0.1, 0.1}).x, 1);
  for (const scene::Texture texture : {scene::Texture::Wood, scene::Texture::Marble}) {
    material.texture = texture;
    double least = 1;
    double most = 0;
    for (int i = 0; i < 200; ++i) {
      const Color color = texture_color(material, {0.013 * i, 0.5, 0.007 * i});
      EXPECT_NEAR(color.x + color.z, 1, kTolerance);
      EXPECT_NEAR(color.y, 0.5, kTolerance);
      least = std::min(least, color.x);
      most = std::max(most, color.x);
    }
    EXPECT_LT(least, 0.2);
    EXPECT_GT(most, 0.8);
  }
}

// The rays of a tree, as an observer is told of them.
struct Told final : TreeObserver {
  std::string text;
  void primary(const ExactRay&, const RayPath&, const method::Report&) override { text += "p"; }
  void spawned(Branch branch, const geometry::ExactPoint&, const RayPath&,
               const method::Report&) override {
    text += branch == Branch::Reflection ? "(r" : branch == Branch::Shadow ? "(s" : "(t";
  }
  void back() override { text += ")"; }
};

TEST(WhittedTest, TellsOfEachRayDepthFirst) {
  Told told;
  color_of(
      "light(position=[0, 0, 9]); material(\"glass\", color=[1, 1, 1, 1/2], mirror=1/2) sphere(1);",
      down(), 2, &told);
  EXPECT_EQ(told.text, "p(s)(t(t)(r))(r)");
}

}  // namespace
}  // namespace lamina::trace
