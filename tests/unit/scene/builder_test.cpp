#include "scene/builder.hpp"

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

std::vector<std::string> paths_of(const std::string& text) {
  std::vector<std::string> paths;
  for (const Leaf& leaf : scene_of(text).leaves) {
    paths.push_back(leaf.path);
  }
  return paths;
}

// The materials of the leaves, in their order.
std::vector<std::string> materials_of(const std::string& text) {
  const Scene scene = scene_of(text);
  std::vector<std::string> names;
  for (const Leaf& leaf : scene.leaves) {
    names.push_back(scene.materials[leaf.medium].name);
  }
  return names;
}

const Material& material(const Scene& scene, const std::string& name) {
  for (const Material& candidate : scene.materials) {
    if (candidate.name == name) {
      return candidate;
    }
  }
  throw std::out_of_range("no material " + name);
}

using Names = std::vector<std::string>;

TEST(SceneTreeTest, OperatorsMeanWhatTheySay) {
  const std::string a = "material(\"a\") cube([2, 1, 1]);";
  const std::string b = "material(\"b\") translate([1, 0, 0]) cube([2, 1, 1]);";
  const ExactPoint in_a{Rational(1) / 2, Rational(1) / 2, Rational(1) / 2};
  const ExactPoint in_both{Rational(3) / 2, Rational(1) / 2, Rational(1) / 2};
  const ExactPoint in_b{Rational(5) / 2, Rational(1) / 2, Rational(1) / 2};
  const auto media = [&](const std::string& text) {
    const Scene scene = scene_of(text);
    return Names{*material_at(scene, in_a), *material_at(scene, in_both),
                 *material_at(scene, in_b)};
  };
  const Names added{"a", "b", "b"};
  EXPECT_EQ(media(a + b), added);
  for (const std::string node : {"add()", "union()", "group()", "root()", "render()",
                                 "render(convexity = 2)", "translate([0, 0, 0])", "color()"}) {
    EXPECT_EQ(media(node + "{" + a + b + "}"), added) << node;
  }
  EXPECT_EQ(media("difference() {" + a + b + "}"), (Names{"a", "", ""}));
  EXPECT_EQ(media("intersection() {" + a + b + "}"), (Names{"", "a", ""}));
  EXPECT_EQ(media("difference() {" + a + "}"), (Names{"a", "a", ""}));
}

TEST(SceneTreeTest, EmptyChildrenAreOpenScads) {
  EXPECT_TRUE(scene_of("").tree.empty());
  EXPECT_TRUE(scene_of("group();").tree.empty());
  EXPECT_TRUE(scene_of("difference() { group() {} cube(); }").tree.empty());
  EXPECT_TRUE(scene_of("difference() { cube(0); cube(); }").tree.empty());
  EXPECT_TRUE(scene_of("intersection() { cube(); union(); sphere(); }").tree.empty());
  EXPECT_EQ(scene_of("difference() { cube(); group(); sphere(); }").leaves.size(), 7U);
  EXPECT_EQ(scene_of("difference() { cube(); group(); }").leaves.size(), 6U);
  EXPECT_EQ(scene_of("union() { group(); cube(); }").leaves.size(), 6U);
}

TEST(SceneTreeTest, LeavesThatAreDroppedLeaveNothingBehind) {
  const Scene scene =
      scene_of("intersection() { cube(); group(); }\ntranslate([5, 0, 0]) sphere();");
  EXPECT_EQ(scene.leaves.size(), 1U);
  EXPECT_EQ(scene.carriers.size(), 1U);
  EXPECT_EQ(scene.frames.size(), 1U);
  EXPECT_EQ(scene.leaves_of_carrier.size(), 1U);
  EXPECT_EQ(scene.tree.leaf_count(), 1U);
  EXPECT_EQ(scene.bounds->lower, (ExactPoint{4, -1, -1}));
}

TEST(SceneTreeTest, CoincidentSurfacesShareACarrier) {
  const Scene scene = scene_of(
      "rotate([17, 29, 43]) { cube(2); translate([2, 0, 0]) cube(1); }\nsphere(); sphere(1);");
  ASSERT_EQ(scene.leaves.size(), 14U);
  EXPECT_EQ(scene.leaves[1].carrier, scene.leaves[6].carrier);  // +x and -x
  EXPECT_EQ(scene.leaves[1].side, -scene.leaves[6].side);
  EXPECT_EQ(scene.leaves[2].carrier, scene.leaves[8].carrier);  // -y twice
  EXPECT_EQ(scene.leaves[2].side, scene.leaves[8].side);
  EXPECT_EQ(scene.leaves[12].carrier, scene.leaves[13].carrier);
  EXPECT_EQ(scene.leaves_of_carrier[scene.leaves[1].carrier], (std::vector<csg::LeafIndex>{1, 6}));
  EXPECT_EQ(scene.carriers.size(), 10U);
}

TEST(SceneTreeTest, EqualFramesAreOne) {
  const Scene scene = scene_of(
      "translate([1, 0, 0]) { cube(); sphere(); } translate([1, 0, 0]) sphere(2); cube();");
  EXPECT_EQ(scene.frames.size(), 2U);
  EXPECT_EQ(scene.leaves[0].frame, scene.leaves[7].frame);
  EXPECT_EQ(scene.frames[scene.leaves[0].frame], geometry::translation({-1, 0, 0}));
  EXPECT_EQ(scene.frames[scene.leaves[8].frame], geometry::AffineMap{});
}

TEST(SceneTreeTest, BoundsAreAroundAllBoundedSolids) {
  const Scene scene = scene_of(
      "rotate(90) cube([1, 2, 3]); translate([5, 0, 0]) scale([1, 1, 1/2]) sphere(1); cone(1);");
  ASSERT_TRUE(scene.bounds);
  EXPECT_EQ(scene.bounds->lower, (ExactPoint{-2, -1, Rational(-1) / 2}));
  EXPECT_EQ(scene.bounds->upper, (ExactPoint{6, 1, 3}));
}

TEST(ScenePathTest, NamesOperatorsAndPositions) {
  EXPECT_EQ(paths_of("sphere();"), (Names{"sphere"}));
  EXPECT_EQ(paths_of("sphere(); torus(2, 1);"), (Names{"sphere[1]", "torus[2]"}));
  EXPECT_EQ(paths_of("difference() { cube(); translate([1, 0, 0]) sphere(); }").at(6),
            "difference.sphere[2]");
  EXPECT_EQ(paths_of("difference() { cube(); sphere(); }").at(1), "difference.cube[1].+x");
  EXPECT_EQ(paths_of("difference() sphere();"), (Names{"difference.sphere"}));
  EXPECT_EQ(paths_of("group() { union() color(\"red\") sphere(); }"), (Names{"sphere"}));
  EXPECT_EQ(paths_of("group() { sphere(); sphere(); }"), (Names{"add.sphere[1]", "add.sphere[2]"}));
  EXPECT_EQ(paths_of("sphere(); intersection() { group() { sphere(); sphere(); } sphere(); }"),
            (Names{"sphere[1]", "intersection[2].add[1].sphere[1]",
                   "intersection[2].add[1].sphere[2]", "intersection[2].sphere[2]"}));
  EXPECT_EQ(paths_of("sphere(); rotate(3) cylinder();").at(3), "cylinder[2].top");
}

TEST(ScenePathTest, DeclarationsAndWhatIsLeftOutAreNoObjects) {
  EXPECT_EQ(paths_of("light([1, 2, 3]); material(\"m\"); *cube(); sphere();"), (Names{"sphere"}));
}

TEST(SceneModifierTest, FollowOpenScad) {
  EXPECT_EQ(paths_of("%cube(); sphere(); *union() { hull(); } #torus(2, 1);"),
            (Names{"sphere[1]", "torus[2]"}));
  EXPECT_EQ(paths_of("difference() { sphere(); %nonsense(1); }"), (Names{"difference.sphere"}));
  EXPECT_TRUE(scene_of("difference() { %cube(); *sphere(); }").tree.empty());
}

TEST(SceneModifierTest, TheRootIsAllThereIs) {
  const Scene scene = scene_of("cube(); translate([9, 0, 0]) { cube(); !sphere(); }");
  ASSERT_EQ(scene.leaves.size(), 1U);
  EXPECT_EQ(scene.leaves[0].path, "sphere");
  EXPECT_EQ(scene.frames[0], geometry::AffineMap{});  // as in OpenSCAD, nothing moves it
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(paths_of("* !cube(); % group() !cube(); sphere();"), (Names{"sphere"}));
}

TEST(SceneModifierTest, OnlyTheFirstRootCounts) {
  const Scene scene = scene_of("group() { !sphere(1); }\n !sphere(2);");
  ASSERT_EQ(scene.leaves.size(), 1U);
  EXPECT_EQ(scene.leaves[0].surface, surface::sphere(1));
  EXPECT_EQ(scene.warnings, (Names{"scene:2:3: warning: `sphere`: only the first `!` counts"}));
}

TEST(SceneMaterialTest, TheInnermostWins) {
  EXPECT_EQ(materials_of("sphere();"), (Names{"default"}));
  EXPECT_EQ(materials_of("material(\"a\") { sphere(); material(\"b\") sphere(); }"),
            (Names{"a", "b"}));
  EXPECT_EQ(materials_of("material(\"a\") color(\"red\") sphere();"), (Names{"[1, 0, 0, 1]"}));
  EXPECT_EQ(materials_of("color(\"red\") material(\"a\") sphere();"), (Names{"a"}));
  EXPECT_EQ(materials_of("material(\"a\") color() sphere();"), (Names{"a"}));
}

TEST(SceneMaterialTest, EqualNamesAreOneMaterial) {
  const Scene scene = scene_of(
      "material(\"a\") sphere(); sphere(2); material(\"a\") sphere(3); material(\"default\") "
      "cube();");
  ASSERT_EQ(scene.materials.size(), 3U);
  EXPECT_EQ(scene.materials[csg::kEmpty].name, "");
  EXPECT_EQ(scene.leaves[0].medium, scene.leaves[2].medium);
  EXPECT_EQ(scene.leaves[1].medium, scene.leaves[3].medium);
  EXPECT_EQ(scene.tree.medium_of(2), scene.leaves[2].medium);
}

TEST(SceneMaterialTest, ColoursAreStatedOnce) {
  const Scene scene = scene_of(
      "material(\"a\") sphere(); material(\"a\", color = [0.5, 1/4, 0, 1/8]);"
      "material(\"b\", \"blue\") sphere(2); material(\"c\") sphere(3);");
  EXPECT_EQ(material(scene, "a").color, (std::array<double, 4>{0.5, 0.25, 0, 0.125}));
  EXPECT_FALSE(material(scene, "a").opaque());
  EXPECT_EQ(material(scene, "b").color, (std::array<double, 4>{0, 0, 1, 1}));
  EXPECT_EQ(material(scene, "c").color, Material{}.color);
  EXPECT_EQ(support::error_of("material(\"a\", \"red\"); material(\"a\", \"#f00\");"), "");
  EXPECT_TRUE(fails_at("material(\"a\", \"red\");\nmaterial(\"a\", \"lime\");", "2:1",
                       "`a` has another look already"));
}

TEST(SceneMaterialTest, TheLookIsStatedWithTheColour) {
  const Scene scene = scene_of(
      "material(\"a\", [1, 0, 0, 1/2], index = 3/2, mirror = 0.25, ambient = 0.1, diffuse = 0.5,"
      "specular = 1, shininess = 7, texture = \"wood\", second_color = [0, 1, 0], grain = 1/8) "
      "sphere(); material(\"b\", index = 4/3) sphere(2); material(\"b\") sphere(3);");
  Material a;
  a.name = "a";
  a.color = {1, 0, 0, 0.5};
  a.refractive_index = Rational(3, 2);
  a.mirror = 0.25;
  a.ambient = 0.1;
  a.diffuse = 0.5;
  a.specular = 1;
  a.shininess = 7;
  a.texture = Texture::Wood;
  a.second_color = {0, 1, 0};
  a.grain = 0.125;
  EXPECT_EQ(material(scene, "a"), a);
  EXPECT_EQ(material(scene, "b").refractive_index, Rational(4, 3));
  EXPECT_EQ(material(scene, "b").color, Material{}.color);
  EXPECT_EQ(scene.materials[csg::kEmpty].refractive_index, 1);
}

TEST(SceneMaterialTest, AWrongLookIsPointedAt) {
  EXPECT_TRUE(fails_at("material(\"a\", mirror = 2);", "1:24", "from 0 to 1"));
  EXPECT_TRUE(fails_at("material(\"a\", index = 0);", "1:23", "must be positive"));
  EXPECT_TRUE(fails_at("material(\"a\", grain = 0);", "1:23", "must be positive"));
  EXPECT_TRUE(fails_at("material(\"a\", texture = \"tweed\");", "1:25", "\"marble\""));
  EXPECT_TRUE(fails_at("material(\"a\", shine = 1);", "1:15", "texture"));
}

TEST(SceneMaterialTest, AColourIsAMaterial) {
  const Scene scene = scene_of(
      "color([1, 0, 0, 1]) sphere(); color(\"red\") sphere(2);"
      "color(\"Red\", 0.5) sphere(3); color([1, 0, 0], alpha = 1/2) cube();");
  EXPECT_EQ(scene.leaves[0].medium, scene.leaves[1].medium);
  EXPECT_EQ(scene.leaves[2].medium, scene.leaves[3].medium);
  EXPECT_EQ(material(scene, "[1, 0, 0, 0.5]").color, (std::array<double, 4>{1, 0, 0, 0.5}));
}

TEST(SceneMaterialTest, OpenScadWritesNoColourAsMinusOne) {
  EXPECT_EQ(materials_of("color([-1, -1, -1, 1]) sphere();"), (Names{"default"}));
}

TEST(SceneDeclarationTest, ReadsCameraLightsAndBackground) {
  const Scene scene = scene_of(
      "camera(eye = [1, 2, 3], look_at = [0, 0, 1/2], up = [0, 1, 0], fov = 40);"
      "light([5, 6, 7]); light(position = [0, 0, 9], color = [1, 0.5, 0]);"
      "background(color = [0.25, 0.5, 1]);");
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->eye, (ExactPoint{1, 2, 3}));
  EXPECT_EQ(scene.camera->look_at, (ExactPoint{0, 0, Rational(1) / 2}));
  EXPECT_EQ(scene.camera->up, (ExactPoint{0, 1, 0}));
  EXPECT_EQ(scene.camera->fov_degrees, 40);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].color, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(scene.lights[1].color, (std::array<double, 3>{1, 0.5, 0}));
  EXPECT_EQ(scene.background, (std::array<double, 3>{0.25, 0.5, 1}));
  EXPECT_EQ(scene.name, "scene");
  EXPECT_FALSE(scene_of("cube();").camera.has_value());
}

TEST(SceneDeclarationTest, RefusesWrongArguments) {
  EXPECT_TRUE(fails_at("camera();", "1:1", "`camera`: the argument `eye` is missing"));
  EXPECT_TRUE(fails_at("camera([0, 0, 0], [0, 0, 0]);", "1:1", "must span a plane"));
  EXPECT_TRUE(fails_at("camera([0, 0, 0], [0, 0, 1]);", "1:1", "must span a plane"));
  EXPECT_TRUE(fails_at("camera([0, 0, 0], [1, 0, 1], fov = 180);", "1:36", "between 0 and 180"));
  EXPECT_TRUE(fails_at("camera([0,0,0], [1,0,1]);\ncamera([0,0,0], [1,0,1]);", "2:1", "keep one"));
  EXPECT_TRUE(fails_at("camera([0,0,0], [1,0,1]) cube();", "1:1", "it takes no children"));
  EXPECT_TRUE(fails_at("group() { light([1, 2, 3]); }", "1:11", "it stands at top level"));
  EXPECT_TRUE(fails_at("group() { material(\"m\"); }", "1:11", "it stands at top level"));
  EXPECT_TRUE(fails_at("light([1, 2, 3], \"reddish\");", "1:18", "`reddish` is no colour"));
  EXPECT_TRUE(fails_at("background([1, 2, 0]);", "1:12", "must be from 0 to 1"));
  EXPECT_TRUE(fails_at("background([1, 0]);", "1:12", "three or four components"));
  EXPECT_TRUE(fails_at("background();", "1:1", "`background`: the argument `color` is missing"));
  EXPECT_TRUE(fails_at("material();", "1:1", "`material`: the argument `name` is missing"));
  EXPECT_TRUE(fails_at("material(\"\") cube();", "1:10", "the name must not be empty"));
  EXPECT_TRUE(fails_at("material(3) cube();", "1:10", "`name` must be a \"string\""));
  EXPECT_TRUE(fails_at("color(\"red\", 2) cube();", "1:14", "`alpha` must be from 0 to 1"));
  EXPECT_TRUE(fails_at("color([0, 0, -0.5]) cube();", "1:7", "must be from 0 to 1"));
}

TEST(SceneErrorTest, NamesNodesThatAreNotReadYet) {
  for (const std::string node : {"polyhedron", "circle", "text", "hull", "minkowski", "import",
                                 "surface", "projection", "offset", "resize"}) {
    EXPECT_TRUE(fails_at("cube();\n " + node + "(1, a = [2]) { cube(); }", "2:2",
                         "`" + node + "`: this node is not supported yet"));
  }
}

TEST(SceneErrorTest, NamesNodesThatDoNotExist) {
  EXPECT_TRUE(fails_at("union() { cubes(1); }", "1:11", "`cubes`: there is no such node"));
  EXPECT_TRUE(fails_at("Cube();", "1:1", "`Cube`: there is no such node"));
}

TEST(SceneErrorTest, OperatorsTakeNoArguments) {
  EXPECT_TRUE(fails_at("union(1) cube();", "1:7", "`union`: at most 0 arguments"));
  EXPECT_TRUE(fails_at("difference(a = 1) cube();", "1:12", "there is no argument `a`"));
  EXPECT_TRUE(fails_at("render(convexity = 1, 2) cube();", "1:23", "given twice"));
}

TEST(SceneFacetTest, SettingsHoldInsideTheirBlock) {
  const auto facets = [](const std::string& text) { return scene_of(text, true).leaves.size(); };
  EXPECT_EQ(facets("cylinder($fn = 7);"), 9U);
  EXPECT_EQ(facets("$fn = 7; cylinder();"), 9U);
  EXPECT_EQ(facets("cylinder(); $fn = 7;"), 9U);
  EXPECT_EQ(facets("$fn = 7; cylinder($fn = 9);"), 11U);
  EXPECT_EQ(facets("union($fn = 7) { cylinder(); } cylinder(h = 2, $fn = 5);"), 16U);
  EXPECT_EQ(facets("translate([1, 0, 0]) { $fn = 7; cylinder(); }"), 9U);
  EXPECT_EQ(facets("color(\"red\", $fn = 7) cylinder();"), 9U);
  EXPECT_EQ(facets("$fa = 30; cylinder(r = 100, h = 1);"), 14U);
  EXPECT_EQ(facets("$fs = 10; cylinder(r = 10, h = 1);"), 9U);
  EXPECT_TRUE(fails_at("$fn = 7; $fn = 8;", "1:10", "the argument `$fn` is given twice"));
  EXPECT_TRUE(fails_at("$fn = [7];", "1:7", "`$fn` must be a number"));
}

}  // namespace
}  // namespace lamina::scene
