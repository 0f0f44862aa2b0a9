// What is small is plain here: the properties that are to stay are stated by hand.
#include "census/minimise.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/contract.hpp"
#include "scene/families.hpp"
#include "support/print.hpp"
#include "support/scenes.hpp"

namespace lamina::census {
namespace {

using geometry::ExactPoint;
using geometry::ExactRay;
using number::Rational;
using scene::Scene;
using support::scene_of;

const ExactRay kRay{{Rational(0.3F), Rational(-7.7F), Rational(1.1F)},
                    {Rational(0.01F), Rational(0.9F), Rational(-0.2F)}};

const Progress kNoProgress = [](std::uint64_t, std::uint64_t) { return true; };

Case minimised(const std::string& text, const Shows& shows, const ExactRay& ray = kRay) {
  return minimise(scene_of(text), ray, shows, kNoProgress);
}

bool has_torus(const Scene& scene, const ExactRay& /*ray*/) {
  return std::any_of(scene.leaves.begin(), scene.leaves.end(), [](const scene::Leaf& leaf) {
    return leaf.surface.kind == surface::Kind::Torus;
  });
}

// Do two planes from different frames coincide?
bool planes_coincide(const Scene& scene, const ExactRay& /*ray*/) {
  for (const auto& leaves : scene.leaves_of_carrier) {
    for (const csg::LeafIndex leaf : leaves) {
      if (scene.leaves[leaf].surface.kind == surface::Kind::Plane &&
          scene.leaves[leaf].frame != scene.leaves[leaves.front()].frame) {
        return true;
      }
    }
  }
  return false;
}

constexpr const char* kModel = R"(
  material("steel") rotate([17, 29, 43]) difference() {
    translate([1.25, 978/997, 3]) cube([2.75, 4, 5]);
    translate([4, 0.3, 0.7]) { cube(3); cylinder(h=3, r1=1, r2=2); }
    scale([1, 2, 3.3]) { sphere(1.234); material("brass") torus(2.718281828, 1/7); }
  }
  intersection() { sphere(3); cube([1, 2, 3], center=true); })";

TEST(MinimiseTest, OneLeafIsLeftWhereOneIsEnough) {
  const Case small = minimised(kModel, has_torus);
  EXPECT_EQ(small.text, "torus(1, 1);\n");
  EXPECT_EQ(small.scene.leaves.size(), 1U);
}

TEST(MinimiseTest, CoincidenceSurvivesTheShorteningOfItsNumbers) {
  const Case small = minimised(kModel, planes_coincide);
  EXPECT_EQ(small.scene.leaves.size(), 2U);
  EXPECT_EQ(small.scene.carriers.size(), 1U);
  EXPECT_LT(small.text.size(), 100U) << small.text;
  EXPECT_EQ(small.text.find("rotate"), std::string::npos) << small.text;
}

TEST(MinimiseTest, SumsAreShortenedTogether) {
  // A plane at 1.234 + 5.678 in one frame and at 6.912 in the other; each number must stay above
  // 1/20, so that none can become zero and free the others.
  const Case small = minimised(
      "halfspace([1, 0, 0], 6.912); translate([5.678, 0, 0]) halfspace([1, 0, 0], 1.234);",
      [](const Scene& scene, const ExactRay& ray) {
        const auto large = [](const Rational& value) { return abs(value) > Rational(1, 20); };
        return scene.leaves.size() == 2 && planes_coincide(scene, ray) &&
               large(scene.leaves[0].surface.coefficients[3]) &&
               large(scene.leaves[1].surface.coefficients[3]) &&
               large(scene.frames[scene.leaves[1].frame].rows[0][3]);
      });
  EXPECT_EQ(small.text,
            "halfspace([1, 0, 0], 2);\ntranslate([1, 0, 0]) halfspace([1, 0, 0], 1);\n");
}

TEST(MinimiseTest, MaterialsAreKeptWhereTheyMatter) {
  const Case small = minimised(kModel, [](const Scene& scene, const ExactRay& /*ray*/) {
    return std::any_of(scene.leaves.begin(), scene.leaves.end(), [&](const scene::Leaf& leaf) {
      return leaf.medium != scene.leaves[0].medium;
    });
  });
  EXPECT_EQ(small.scene.leaves.size(), 2U);
  EXPECT_NE(small.text.find("material(\"a\")"), std::string::npos) << small.text;
  EXPECT_EQ(small.text.find("steel"), std::string::npos) << small.text;
  EXPECT_EQ(small.text.find("brass"), std::string::npos) << small.text;
}

TEST(MinimiseTest, OperandsThatGoOnlyTogetherAreDropped) {
  // An even number of planes: no single one can be dropped.
  const Case small =
      minimised("cube(1); translate([5, 0, 0]) cube(2);", [](const Scene& scene, const ExactRay&) {
        return !scene.leaves.empty() && scene.leaves.size() % 2 == 0;
      });
  EXPECT_EQ(small.scene.leaves.size(), 2U);
}

TEST(MinimiseTest, RaysAreShortened) {
  const Case small = minimised("sphere(1);", [](const Scene& scene, const ExactRay& ray) {
    return !scene.leaves.empty() && abs(ray.origin.y + Rational(77, 10)) < Rational(1, 10) &&
           ray.direction.y > 0;
  });
  EXPECT_EQ(small.ray.origin, (ExactPoint{0, Rational(-31, 4), 0}));
  EXPECT_EQ(small.ray.direction, (ExactPoint{0, 1, 0}));
}

TEST(MinimiseTest, ShorterNumbersAreHeldByWhatHeldTheLongerOnes) {
  // 3 + 1/8 has a shorter neighbour 3.1 and the ray's 1.9375 has 1.9: no binary float has them.
  const Case small = minimised("halfspace([1, 0, 0], 3.125);",
                               [](const Scene& scene, const ExactRay& ray) {
                                 return abs(scene.leaves[0].surface.coefficients[3] + 3 +
                                            Rational(1, 8)) < Rational(1, 20) &&
                                        abs(ray.origin.x - Rational(31, 16)) < Rational(1, 20);
                               },
                               {{Rational(31, 16), 0, 0}, {1, 0, 0}});
  EXPECT_EQ(small.text, "halfspace([1, 0, 0], 3.125);\n");
  EXPECT_EQ(small.ray.origin.x, Rational(31, 16));
}

// From far outside and at nothing in particular.
const ExactRay kGenericRay{{Rational(100.3F), Rational(99.1F), Rational(97.7F)},
                           {Rational(-1.1F), Rational(-0.9F), Rational(-1.05F)}};

TEST(MinimiseTest, NoRayStartsOnASurfaceThatDidNot) {
  for (std::uint64_t case_id = 0; case_id < 20; ++case_id) {
    const Scene scene = scene::open_scene(scene::family_spelling("coincident-faces", 1, case_id));
    const Case small = minimise(
        scene, kGenericRay,
        [](const Scene& candidate, const ExactRay&) { return !candidate.leaves.empty(); },
        kNoProgress);
    EXPECT_EQ(small.scene.leaves.size(), 1U);
    EXPECT_NE(surface::sign_at(small.scene.carriers[0], small.ray.origin), 0) << small.text;
    EXPECT_NE(small.ray.direction, ExactPoint{});
  }
}

TEST(MinimiseTest, NoRayTouchesASurfaceOrHitsAnEdgeThatDidNot) {
  // All rays from x < -1 along x: the simplest touch the sphere, or hit the edge.
  const Case touching = minimised("sphere(1);",
                                  [](const Scene& scene, const ExactRay& ray) {
                                    return scene.leaves.size() == 1 &&
                                           scene.leaves[0].surface == surface::sphere(1) &&
                                           ray.origin.y > Rational(9, 10) && ray.direction.y == 0;
                                  },
                                  {{Rational(-3), Rational(0.97F), 0}, {1, 0, 0}});
  EXPECT_NE(touching.ray.origin.y, 1);
  const Case at_edge =
      minimised("intersection() { halfspace([-1, 0, 0], 0); halfspace([0, -1, 0], 0); }",
                [](const Scene& scene, const ExactRay& ray) {
                  return scene.carriers.size() == 2 && ray.direction.x > 0 && ray.direction.y > 0;
                },
                {{Rational(-3), Rational(-2.9F), 0}, {1, 1, 0}});
  const auto& [o, d] = at_edge.ray;
  EXPECT_NE(o.x * d.y, o.y * d.x) << "through the z axis";
}

TEST(MinimiseTest, TheTextReadsBackAsTheSceneAndTheResultIsTheSameEachTime) {
  const Case first = minimised(kModel, planes_coincide);
  const Case second = minimised(kModel, planes_coincide);
  EXPECT_EQ(first.text, second.text);
  EXPECT_EQ(first.ray.origin, second.ray.origin);
  EXPECT_EQ(first.ray.direction, second.ray.direction);
  const Scene read = scene_of(first.text);
  EXPECT_EQ(read.frames, first.scene.frames);
  EXPECT_EQ(read.carriers, first.scene.carriers);
}

TEST(MinimiseTest, StopsWhenToldAndKeepsTheSmallestSoFar) {
  std::size_t asked = 0;
  const Case small = minimise(scene_of(kModel), kRay, has_torus,
                              [&asked](std::uint64_t, std::uint64_t) { return ++asked < 5; });
  EXPECT_TRUE(has_torus(small.scene, small.ray));
  EXPECT_GT(small.scene.leaves.size(), 1U);
  EXPECT_LE(small.scene.leaves.size(), scene_of(kModel).leaves.size());
}

TEST(MinimiseTest, WhatIsToStayMustBeThere) {
  EXPECT_THROW(minimised("sphere(1);", has_torus), base::ContractError);
}

}  // namespace
}  // namespace lamina::census
