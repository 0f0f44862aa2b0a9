// Scenes that are written and read back: nothing that a ray depends on may change.
#include "scene/writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/seeded_stream.hpp"
#include "scene/families.hpp"
#include "support/corpus.hpp"
#include "support/print.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using support::scene_of;

std::string written(const Scene& scene) { return text_of(syntax_of(scene)); }
std::string written(const std::string& text) { return written(scene_of(text)); }

void expect_same(const Scene& scene, const Scene& read) {
  EXPECT_EQ(read.frames, scene.frames);
  EXPECT_EQ(read.carriers, scene.carriers);
  EXPECT_EQ(read.leaves_of_carrier, scene.leaves_of_carrier);
  ASSERT_EQ(read.leaves.size(), scene.leaves.size());
  for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
    const Leaf& a = scene.leaves[i];
    const Leaf& b = read.leaves[i];
    EXPECT_EQ(b.surface, a.surface) << a.path;
    EXPECT_EQ(b.frame, a.frame) << a.path;
    EXPECT_EQ(b.carrier, a.carrier) << a.path;
    EXPECT_EQ(b.side, a.side) << a.path;
    EXPECT_EQ(read.materials[b.medium].name, scene.materials[a.medium].name) << a.path;
  }
  ASSERT_EQ(read.tree.nodes().size(), scene.tree.nodes().size());
  for (std::size_t i = 0; i < scene.tree.nodes().size(); ++i) {
    const csg::Tree::Node& a = scene.tree.nodes()[i];
    const csg::Tree::Node& b = read.tree.nodes()[i];
    EXPECT_EQ(b.op, a.op) << i;
    EXPECT_EQ(b.left, a.left) << i;
    EXPECT_EQ(b.right, a.right) << i;
    EXPECT_EQ(b.parent, a.parent) << i;
  }
}

void expect_round_trip(const Scene& scene) {
  const std::string text = written(scene);
  SCOPED_TRACE(scene.name + "\n" + text.substr(0, 2000));
  const Scene read = scene_of(text);
  expect_same(scene, read);
  EXPECT_EQ(written(read), text);
}

// What is declared: the materials of the solid by their names, and what stands besides them.
void expect_same_declarations(const Scene& scene) {
  const std::string text = text_of(declarations_of(scene)) + written(scene);
  SCOPED_TRACE(text.substr(0, 2000));
  const Scene read = scene_of(text);
  expect_same(scene, read);
  for (const Material& material : scene.materials) {
    EXPECT_EQ(std::count(read.materials.begin(), read.materials.end(), material), 1)
        << material.name;
  }
  ASSERT_EQ(read.camera.has_value(), scene.camera.has_value());
  if (scene.camera) {
    EXPECT_EQ(read.camera->eye, scene.camera->eye);
    EXPECT_EQ(read.camera->look_at, scene.camera->look_at);
    EXPECT_EQ(read.camera->up, scene.camera->up);
    EXPECT_EQ(read.camera->fov_degrees, scene.camera->fov_degrees);
  }
  ASSERT_EQ(read.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    EXPECT_EQ(read.lights[i].position, scene.lights[i].position);
    EXPECT_EQ(read.lights[i].color, scene.lights[i].color);
  }
  EXPECT_EQ(read.background, scene.background);
}

TEST(WriterTest, FiguresReadBackAsTheyWere) {
  const auto folder = std::filesystem::path(LAMINA_SOURCE_DIR) / "data" / "scenes";
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Scene scene = read_scene(entry.path().string());
    expect_round_trip(scene);
    expect_same_declarations(scene);
    ++scenes;
  }
  EXPECT_GE(scenes, 16);
}

TEST(WriterTest, FamiliesReadBackAsTheyWere) {
  for (std::uint64_t case_id = 0; case_id < 60; ++case_id) {
    expect_round_trip(open_scene(family_spelling("coincident-faces", 1, case_id)));
    expect_round_trip(open_scene(family_spelling("ghost-cylinders", 1, case_id)));
  }
}

TEST(WriterTest, RealModelsReadBackAsTheyWere) {
  const auto folder = support::corpus_folder();
  if (!folder) {
    GTEST_SKIP() << support::kNoCorpus;
  }
  for (const char* model : {"oscex_csg", "oscex_example004", "koen_lee_drill_centerer",
                            "martmaiste_pole_mount_round", "dankamongmen_twitchpiece"}) {
    const std::string path = (*folder / (std::string(model) + ".csg")).string();
    expect_round_trip(read_scene(path));
    expect_round_trip(read_scene(path, {.facets = true}));
  }
}

// Operators with any number of operands in any nesting: the text nests no more than it must,
// but the tree that is balanced from it has to be the one that was.
std::string random_operation(base::SeededStream& stream, int depth) {
  if (depth == 0 || stream.chance(0.2)) {
    return "halfspace([1, 0, 0], " + std::to_string(stream.below(9)) + ");\n";
  }
  std::string text;
  if (stream.chance(0.2)) {
    text += "translate([0, " + std::to_string(stream.below(2)) + ", 1/3]) ";
  }
  if (stream.chance(0.2)) {
    text += stream.chance(0.5) ? "material(\"a\") " : "material(\"default\") ";
  }
  if (stream.chance(0.1)) {
    text += "rotate([0, 30, 10]) ";
  }
  constexpr std::array kOperators{"add", "difference", "intersection"};
  text += std::string(kOperators[stream.below(kOperators.size())]) + "() {\n";
  for (std::uint64_t operands = 1 + stream.below(7); operands > 0; --operands) {
    text += random_operation(stream, depth - 1);
  }
  return text + "}\n";
}

TEST(WriterTest, AnyTreeReadsBackAsItWas) {
  for (std::uint64_t case_id = 0; case_id < 200; ++case_id) {
    base::SeededStream stream("scene/writer", 1, case_id);
    const std::string text = random_operation(stream, 3);
    SCOPED_TRACE(text);
    expect_round_trip(scene_of(text));
  }
}

TEST(WriterTest, EveryPrimitiveAndMapIsStatedAsItIs) {
  for (const std::string text :
       {"sphere(3/7);\n", "infinite_cylinder(0.1);\n", "cone(2/3);\n", "torus(2, 1/3);\n",
        "halfspace([1, -2, 1/3], 0.7);\n",
        "quadric([[1, 2, 0, 0], [0, 0, 0, 1], [0, 0, 0, 0], "
        "[0, 0, 0, 1/3]]);\n",
        "translate([1, 2, 1/3]) sphere(1);\n", "scale([1, -2, 1/3]) sphere(1);\n",
        "translate([1, 0, 0]) rotate(quaternion=[1, 1/3, 0, -2]) sphere(1);\n",
        "multmatrix([[1, 1/3, 0, 0], [0, 1, 0, 5], [0, 0, 1, 0]]) sphere(1);\n",
        "material(\"a \\\"b\\\" \\\\\") sphere(1);\n"}) {
    EXPECT_EQ(written(text), text);
  }
  // Half a turn has no quaternion 1 + xi + yj + zk.
  expect_round_trip(scene_of("rotate(a=180, v=[1, 2, 3]) halfspace([1, 0, 0], 1);"));
  // Its apex is not at the origin.
  expect_round_trip(scene_of("cylinder(h=3, r1=1, r2=2);"));
}

TEST(WriterTest, WhatLeavesShareIsStatedOnce) {
  EXPECT_EQ(written("translate([0, 0, 1]) rotate(a=90, v=[0, 0, 1]) material(\"a\") { sphere(1); "
                    "translate([1/3, 0, 0]) { halfspace([1, 0, 0], 1); sphere(2); } }"),
            "material(\"a\") translate([0, 0, 1]) rotate(quaternion=[1, 0, 0, 1]) add() {\n"
            "  sphere(1);\n"
            "  translate([1/3, 0, 0]) add() {\n"
            "    halfspace([1, 0, 0], 1);\n"
            "    sphere(2);\n"
            "  }\n"
            "}\n");
}

TEST(WriterTest, NothingIsAnEmptyText) { EXPECT_EQ(written(""), ""); }

}  // namespace
}  // namespace lamina::scene
