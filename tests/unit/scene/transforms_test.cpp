#include "scene/transforms.hpp"

#include <gtest/gtest.h>

#include "support/print.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using geometry::AffineMap;
using number::Rational;
using support::fails_at;

// The map of what stands before a sphere.
AffineMap map_of(const std::string& text) {
  const Scene scene = support::scene_of(text + " sphere();");
  return geometry::inverse(scene.frames.at(scene.leaves.at(0).frame)).value();
}

const geometry::ExactPoint kZ{0, 0, 1};

TEST(TransformTest, Translates) {
  EXPECT_EQ(map_of("translate([1, 1/2, -3])"), geometry::translation({1, Rational(1) / 2, -3}));
  EXPECT_EQ(map_of("translate(v = [1, 2])"), geometry::translation({1, 2, 0}));
}

TEST(TransformTest, Scales) {
  EXPECT_EQ(map_of("scale([1, 2, 3])"), geometry::scaling({1, 2, 3}));
  EXPECT_EQ(map_of("scale([2, 3])"), geometry::scaling({2, 3, 1}));
  EXPECT_EQ(map_of("scale(v = -1/2)"),
            geometry::scaling({Rational(-1) / 2, Rational(-1) / 2, Rational(-1) / 2}));
}

TEST(TransformTest, Mirrors) {
  EXPECT_EQ(map_of("mirror([1, 2, 3])"), geometry::reflection({1, 2, 3}));
  EXPECT_EQ(map_of("mirror([1, 0])"), geometry::scaling({-1, 1, 1}));
}

TEST(TransformTest, Rotates) {
  EXPECT_EQ(map_of("rotate(30)"), geometry::rotation_about(kZ, 30));
  EXPECT_EQ(map_of("rotate(a = 30, v = [1, 2, 3])"), geometry::rotation_about({1, 2, 3}, 30));
  EXPECT_EQ(map_of("rotate(30, [1, 2, 3])"), geometry::rotation_about({1, 2, 3}, 30));
  EXPECT_EQ(map_of("rotate(quaternion = [1, 0, 0, 1/2])"),
            geometry::rotation(1, {0, 0, Rational(1) / 2}));
}

TEST(TransformTest, RotatesAboutXThenYThenZ) {
  EXPECT_EQ(map_of("rotate([10, 20, 30])"), map_of("rotate(30) rotate(20, [0, 1, 0]) "
                                                   "rotate(10, [1, 0, 0])"));
  const AffineMap map = map_of("rotate([90, 0, 90])");
  EXPECT_EQ(apply(map, {0, 1, 0}), (geometry::ExactPoint{0, 0, 1}));
}

TEST(TransformTest, TakesMatrices) {
  const AffineMap expected{{AffineMap::Row{1, Rational(1) / 3, 0, 4}, AffineMap::Row{0, 2, 0, 5},
                            AffineMap::Row{0, 0, -1, 6}}};
  EXPECT_EQ(map_of("multmatrix([[1, 1/3, 0, 4], [0, 2, 0, 5], [0, 0, -1, 6], [0, 0, 0, 1]])"),
            expected);
  EXPECT_EQ(map_of("multmatrix(m = [[1, 1/3, 0, 4], [0, 2, 0, 5], [0, 0, -1, 6]])"), expected);
}

TEST(TransformTest, TheOuterOneActsLast) {
  const AffineMap map = map_of("translate([1, 0, 0]) rotate(90) scale(2)");
  EXPECT_EQ(apply(map, {1, 0, 0}), (geometry::ExactPoint{1, 2, 0}));
}

TEST(TransformErrorTest, RefusesWrongArguments) {
  EXPECT_TRUE(fails_at("translate() cube();", "1:1", "`translate`: the argument `v` is missing"));
  EXPECT_TRUE(fails_at("translate(1) cube();", "1:11", "`v` must be a list of numbers"));
  EXPECT_TRUE(fails_at("translate([1]) cube();", "1:11", "`v` must have three coordinates"));
  EXPECT_TRUE(fails_at("translate([0, 0, 0], 1) cube();", "1:22", "at most 1 arguments"));
  EXPECT_TRUE(fails_at("scale([1, 0, 1]) cube();", "1:7", "`scale`: a scale must not be zero"));
  EXPECT_TRUE(fails_at("scale(0);", "1:7", "a scale must not be zero"));
  EXPECT_TRUE(fails_at("mirror([0, 0, 0]);", "1:8", "the normal of the mirror must not be zero"));
  EXPECT_TRUE(fails_at("rotate();", "1:1", "`rotate`: the argument `a` is missing"));
  EXPECT_TRUE(fails_at("rotate(v = [0, 0, 1]);", "1:1", "the argument `a` is missing"));
  EXPECT_TRUE(fails_at("rotate(3, [0, 0, 0]);", "1:11", "the axis must not be zero"));
  EXPECT_TRUE(fails_at("rotate([1, 2, 3], [0, 0, 1]);", "1:19", "an axis goes with one angle"));
  EXPECT_TRUE(fails_at("rotate(quaternion = [1, 0, 0]);", "1:21", "must be [w, x, y, z]"));
  EXPECT_TRUE(fails_at("rotate(quaternion = [0, 0, 0, 0]);", "1:21", "not all zero"));
  EXPECT_TRUE(fails_at("rotate(3, quaternion = [1, 0, 0, 0]);", "1:24", "without other arguments"));
  EXPECT_TRUE(fails_at("multmatrix([[1, 0, 0, 0], [0, 1, 0, 0]]);", "1:12", "three or four rows"));
  EXPECT_TRUE(fails_at("multmatrix([[1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]);", "1:13",
                       "must be a list of 4 numbers"));
  EXPECT_TRUE(fails_at("multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]);",
                       "1:12", "the last row of `m` must be [0, 0, 0, 1]"));
  EXPECT_TRUE(fails_at("multmatrix([[1, 2, 0, 0], [2, 4, 0, 0], [0, 0, 1, 0]]);", "1:12",
                       "`m` must not be singular"));
}

}  // namespace
}  // namespace lamina::scene
