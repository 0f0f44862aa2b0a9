#include "scene/primitives.hpp"

#include <gtest/gtest.h>

#include "support/print.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using geometry::ExactPoint;
using number::Rational;
using support::fails_at;
using support::material_at;
using support::scene_of;

bool inside(const std::string& text, const ExactPoint& point, bool facets = false) {
  const std::optional<std::string> material = material_at(scene_of(text, facets), point);
  EXPECT_TRUE(material.has_value()) << "the point is on a carrier";
  return material == "default";
}

Bounds bounds_of(const std::string& text) { return scene_of(text).bounds.value(); }

std::vector<std::string> paths_of(const Scene& scene) {
  std::vector<std::string> paths;
  for (const Leaf& leaf : scene.leaves) {
    paths.push_back(leaf.path);
  }
  return paths;
}

// The surfaces of a text's leaves, in the solid's own coordinates.
std::vector<surface::LocalSurface> surfaces_of(const std::string& text) {
  std::vector<surface::LocalSurface> surfaces;
  for (const Leaf& leaf : scene_of(text).leaves) {
    surfaces.push_back(leaf.surface);
  }
  return surfaces;
}

const Rational kHalf = Rational(1) / 2;
const Rational kTiny = Rational(1) / 1'000'000;

TEST(CubeTest, IsSixPlanes) {
  const Scene scene = scene_of("cube([1, 2, 3/4]);");
  EXPECT_EQ(paths_of(scene), (std::vector<std::string>{"cube.-x", "cube.+x", "cube.-y", "cube.+y",
                                                       "cube.-z", "cube.+z"}));
  EXPECT_EQ(scene.frames.size(), 1U);
  EXPECT_EQ(scene.leaves[3].surface, surface::plane({0, 1, 0}, 2));
  EXPECT_EQ(scene.leaves[4].surface, surface::plane({0, 0, -1}, 0));
}

TEST(CubeTest, TakesOpenScadsArguments) {
  EXPECT_EQ(surfaces_of("cube();"), surfaces_of("cube(size = [1, 1, 1], center = false);"));
  EXPECT_EQ(surfaces_of("cube(2);"), surfaces_of("cube([2, 2, 2]);"));
  EXPECT_EQ(surfaces_of("cube(2, true);"), surfaces_of("cube(center = true, size = 2);"));
  EXPECT_EQ(surfaces_of("cube(undef);"), surfaces_of("cube(1);"));
  EXPECT_EQ(bounds_of("cube(2, center = true);").lower, (ExactPoint{-1, -1, -1}));
  EXPECT_EQ(bounds_of("cube([1, 2, 3]);").upper, (ExactPoint{1, 2, 3}));
}

TEST(SphereTest, TakesOpenScadsArguments) {
  EXPECT_EQ(surfaces_of("sphere();"), std::vector{surface::sphere(1)});
  EXPECT_EQ(surfaces_of("sphere(1/3);"), std::vector{surface::sphere(Rational(1) / 3)});
  EXPECT_EQ(surfaces_of("sphere(r = 2, $fn = 9);"), std::vector{surface::sphere(2)});
  EXPECT_EQ(surfaces_of("sphere(d = 3);"), std::vector{surface::sphere(Rational(3) / 2)});
  EXPECT_EQ(paths_of(scene_of("sphere();")), std::vector<std::string>{"sphere"});
  EXPECT_EQ(bounds_of("sphere(2);").lower, (ExactPoint{-2, -2, -2}));
}

TEST(CylinderTest, IsACylinderLessTwoHalfSpaces) {
  const Scene scene = scene_of("cylinder(h = 2, r = 3);");
  EXPECT_EQ(paths_of(scene),
            (std::vector<std::string>{"cylinder.side", "cylinder.bottom", "cylinder.top"}));
  EXPECT_EQ(scene.frames.size(), 1U);
  EXPECT_EQ(scene.leaves[0].surface, surface::infinite_cylinder(3));
  EXPECT_EQ(scene.leaves[1].surface, surface::plane({0, 0, 1}, 0));
  EXPECT_EQ(scene.leaves[2].surface, surface::plane({0, 0, -1}, -2));
  EXPECT_EQ(scene.tree.nodes()[scene.tree.root()].op, csg::Operator::Difference);
  EXPECT_TRUE(inside("cylinder(h = 2, r = 3);", {2, 2, 1}));
  EXPECT_FALSE(inside("cylinder(h = 2, r = 3);", {2, 2, 3}));
  EXPECT_FALSE(inside("cylinder(h = 2, r = 3);", {2, 2, -1}));
  EXPECT_FALSE(inside("cylinder(h = 2, r = 3);", {3, 1, 1}));
}

TEST(CylinderTest, TakesOpenScadsArguments) {
  EXPECT_EQ(surfaces_of("cylinder();"), surfaces_of("cylinder(h = 1, r1 = 1, r2 = 1);"));
  EXPECT_EQ(surfaces_of("cylinder(3, 2, 1, true);"),
            surfaces_of("cylinder(center = true, r2 = 1, r1 = 2, h = 3);"));
  EXPECT_EQ(surfaces_of("cylinder(h = 3, d = 4);"), surfaces_of("cylinder(h = 3, r = 2);"));
  EXPECT_EQ(surfaces_of("cylinder(h = 3, d1 = 4, d2 = 1);"), surfaces_of("cylinder(3, 2, 0.5);"));
  EXPECT_EQ(surfaces_of("cylinder(h = 3, r = 2, r2 = 1);"), surfaces_of("cylinder(3, 2, 1);"));
  EXPECT_EQ(surfaces_of("cylinder(h = 3, r1 = 2);"), surfaces_of("cylinder(3, 2, 1);"));
  EXPECT_EQ(bounds_of("cylinder(3, 2, 1, true);").lower, (ExactPoint{-2, -2, -3 * kHalf}));
  EXPECT_EQ(bounds_of("cylinder(3, 1, 2);").upper, (ExactPoint{2, 2, 3}));
}

TEST(CylinderTest, ATruncatedConeHasOneNappe) {
  for (const std::string text : {"cylinder(2, 2, 1);", "cylinder(2, 1, 2);"}) {
    const Scene scene = scene_of(text);
    EXPECT_EQ(scene.leaves[0].surface.kind, surface::Kind::Quadric);
    EXPECT_TRUE(inside(text, {3 * kHalf - kTiny, 0, 1})) << text;
    EXPECT_FALSE(inside(text, {3 * kHalf + kTiny, 0, 1})) << text;
    EXPECT_FALSE(inside(text, {0, 0, 10})) << text;
    EXPECT_FALSE(inside(text, {0, 0, -10})) << text;
  }
  EXPECT_TRUE(inside("cylinder(2, 2, 1);", {2 - kTiny, 0, kTiny}));
  EXPECT_TRUE(inside("cylinder(2, 1, 2);", {2 - kTiny, 0, 2 - kTiny}));
}

TEST(CylinderTest, AConeEndsInItsApex) {
  EXPECT_TRUE(inside("cylinder(2, 1, 0);", {0, 0, 2 - kTiny}));
  EXPECT_FALSE(inside("cylinder(2, 1, 0);", {0, 0, 2 + kTiny}));
  EXPECT_FALSE(inside("cylinder(2, 1, 0);", {kHalf + kTiny, 0, 1}));
  EXPECT_TRUE(inside("cylinder(2, 0, 1);", {kHalf - kTiny, 0, 1}));
  EXPECT_FALSE(inside("cylinder(2, 0, 1);", {0, 0, -kTiny}));
}

TEST(HalfSpaceTest, IsBelowItsOffset) {
  EXPECT_TRUE(inside("halfspace([0, 0, 2], 3);", {5, 5, 1}));
  EXPECT_FALSE(inside("halfspace(normal = [0, 0, 2], offset = 3);", {5, 5, 2}));
  EXPECT_FALSE(scene_of("halfspace([0, 0, 2], 3);").bounds.has_value());
}

TEST(QuadricTest, IsTheFormOfItsMatrix) {
  const std::string text = "quadric([[1, 2, 0, 0], [0, 1, 0, 6], [0, 4, -1, 0], [0, 0, 0, -7]]);";
  EXPECT_EQ(surfaces_of(text).at(0).coefficients,
            (std::array<Rational, 10>{1, 1, -1, 2, 0, 4, 0, 6, 0, -7}));
  EXPECT_TRUE(inside(text, {0, 0, 0}));
  EXPECT_FALSE(inside(text, {3, 0, 0}));
}

TEST(InfiniteTest, CylindersAndConesGoOn) {
  EXPECT_TRUE(inside("infinite_cylinder(r = 2);", {1, 1, 1000}));
  EXPECT_FALSE(inside("infinite_cylinder(2);", {2, 1, 1000}));
  EXPECT_TRUE(inside("cone(1/2);", {4, 0, 10}));
  EXPECT_TRUE(inside("cone(slope = 1/2);", {4, 0, -10}));
  EXPECT_FALSE(inside("cone(1/2);", {6, 0, 10}));
}

TEST(TorusTest, IsOneLeafAboutZ) {
  EXPECT_EQ(surfaces_of("torus(R = 3, r = 1);"), std::vector{surface::torus(3, 1)});
  EXPECT_TRUE(inside("torus(3, 1);", {0, 3, kHalf}));
  EXPECT_FALSE(inside("torus(3, 1);", {0, 0, 0}));
  EXPECT_EQ(bounds_of("torus(3, 1);").upper, (ExactPoint{4, 4, 1}));
}

TEST(PrimitiveTest, SizeZeroIsEmptyWithAWarning) {
  for (const std::string node : {"cube([1, 0, 1])", "sphere(0)", "cylinder(h = 0)",
                                 "cylinder(r1 = 0, r2 = 0)", "infinite_cylinder(0)", "cone(0)"}) {
    const Scene scene = scene_of("\n " + node + ";");
    EXPECT_TRUE(scene.tree.empty()) << node;
    EXPECT_FALSE(scene.bounds.has_value()) << node;
    ASSERT_EQ(scene.warnings.size(), 1U) << node;
    EXPECT_TRUE(scene.warnings[0].starts_with("scene:2:2: warning: `")) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("its size is zero"), std::string::npos);
  }
}

TEST(PrimitiveTest, FacetsOnlyWhatOpenScadFacets) {
  EXPECT_EQ(scene_of("sphere(1, $fn = 4);", true).leaves.size(), 6U);
  EXPECT_EQ(scene_of("cylinder(1, 3, 2, $fn = 8);", true).leaves.size(), 10U);
  EXPECT_EQ(scene_of("cube();", true).leaves.size(), 6U);
  EXPECT_EQ(scene_of("torus(3, 1, $fn = 8);", true).leaves.size(), 1U);
  EXPECT_EQ(scene_of("infinite_cylinder(1, $fn = 8);", true).leaves.size(), 1U);
  EXPECT_TRUE(inside("cylinder(1, 2, 2, $fn = 4);", {kHalf, kHalf, kHalf}, true));
  EXPECT_FALSE(inside("cylinder(1, 2, 2, $fn = 4);", {5 * kHalf / 2, 5 * kHalf / 2, kHalf}, true));
}

TEST(PrimitiveTest, TheWiderRimDecidesTheFacets) {
  EXPECT_EQ(scene_of("cylinder(h = 50, r1 = 1, r2 = 100);", true).leaves.size(), 32U);
  EXPECT_EQ(scene_of("cylinder(h = 50, r1 = 100, r2 = 1);", true).leaves.size(), 32U);
}

TEST(PrimitiveErrorTest, NamesTheNodeAndWhatToWrite) {
  EXPECT_EQ(support::error_of("cube(size = [1, 2, true]);"),
            "scene:1:20: `cube`: `size` must hold numbers; write cube(size = [x, y, z], center = "
            "false)\ncube(size = [1, 2, true]);\n                   ^");
}

TEST(PrimitiveErrorTest, RefusesWrongArguments) {
  EXPECT_TRUE(fails_at("cube([1, 2]);", "1:6", "`cube`: `size` must have three coordinates"));
  EXPECT_TRUE(fails_at("cube([1, 2, 3, 4]);", "1:6", "`size` must have three coordinates"));
  EXPECT_TRUE(fails_at("cube(\"1\");", "1:6", "`size` must be a list of numbers"));
  EXPECT_TRUE(fails_at("cube([1, -2, 3]);", "1:6", "`size` must not be negative"));
  EXPECT_TRUE(fails_at("cube(1, center = 1);", "1:18", "`center` must be true or false"));
  EXPECT_TRUE(fails_at("cube(1, false, 3);", "1:16", "at most 2 arguments without a name"));
  EXPECT_TRUE(fails_at("cube(length = 3);", "1:6", "there is no argument `length`"));
  EXPECT_TRUE(fails_at("cube(1, size = 2);", "1:9", "the argument `size` is given twice"));
  EXPECT_TRUE(fails_at("cube(1) sphere();", "1:1", "`cube`: it takes no children"));
  EXPECT_TRUE(fails_at("sphere([1, 2]);", "1:8", "`sphere`: `r` must be a number"));
  EXPECT_TRUE(fails_at("sphere(-1);", "1:8", "`r` must not be negative"));
  EXPECT_TRUE(fails_at("sphere(d = -1);", "1:12", "`d` must not be negative"));
  EXPECT_TRUE(fails_at("sphere(1, d = 2);", "1:15", "`r` and `d` cannot both be given"));
  EXPECT_TRUE(fails_at("sphere($fn = true);", "1:14", "`$fn` must be a number"));
  EXPECT_TRUE(fails_at("cylinder(h = -1);", "1:14", "`cylinder`: `h` must not be negative"));
  EXPECT_TRUE(fails_at("cylinder(r1 = -1);", "1:15", "`r1` must not be negative"));
  EXPECT_TRUE(fails_at("cylinder(1, d1 = 1, r1 = 1);", "1:18", "cannot both be given"));
  EXPECT_TRUE(fails_at("cylinder(1, 1, 1, true, 1);", "1:25", "at most 4 arguments"));
  EXPECT_TRUE(fails_at("halfspace([0, 0, 1]);", "1:1", "`halfspace`: the argument `offset` is"));
  EXPECT_TRUE(fails_at("halfspace(undef, 1);", "1:1", "the argument `normal` is missing"));
  EXPECT_TRUE(fails_at("halfspace([0, 0, 0], 1);", "1:11", "`normal` must not be zero"));
  EXPECT_TRUE(fails_at("halfspace([0, 1], 1);", "1:11", "must have three coordinates"));
  EXPECT_TRUE(fails_at("quadric();", "1:1", "`quadric`: the argument `matrix` is missing"));
  EXPECT_TRUE(fails_at("quadric([[1, 0, 0, 0]]);", "1:9", "`matrix` must have four rows"));
  EXPECT_TRUE(fails_at("quadric([[1, 0, 0]]);", "1:10", "must be a list of 4 numbers"));
  EXPECT_TRUE(fails_at("quadric([1]);", "1:10", "must be a list of 4 numbers"));
  EXPECT_TRUE(fails_at("quadric([[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,1]]);", "1:9",
                       "`matrix` must not give a constant"));
  EXPECT_TRUE(fails_at("infinite_cylinder();", "1:1", "`infinite_cylinder`: the argument `r`"));
  EXPECT_TRUE(fails_at("infinite_cylinder(-1);", "1:19", "`r` must not be negative"));
  EXPECT_TRUE(fails_at("cone();", "1:1", "`cone`: the argument `slope` is missing"));
  EXPECT_TRUE(fails_at("cone(-1);", "1:6", "`slope` must not be negative"));
  EXPECT_TRUE(fails_at("torus(1);", "1:1", "`torus`: the argument `r` is missing"));
  EXPECT_TRUE(fails_at("torus(0, 1);", "1:7", "`R` must be positive"));
  EXPECT_TRUE(fails_at("torus(1, r = -1);", "1:14", "`r` must be positive"));
}

TEST(PrimitiveErrorTest, RefusesTooManyFacets) {
  const std::string too_many = "it has more than 100000 facets: lower $fn";
  EXPECT_NE(support::error_of("sphere(1, $fn = 1000);", true).find(too_many), std::string::npos);
  EXPECT_NE(support::error_of("cylinder($fn = 1e300);", true).find(too_many), std::string::npos);
  EXPECT_EQ(support::error_of("sphere(1, $fn = 1000);", false), "");
}

}  // namespace
}  // namespace lamina::scene
