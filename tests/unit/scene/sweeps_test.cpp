#include <gtest/gtest.h>

#include "scene/scene.hpp"
#include "scene/writer.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using geometry::ContourKind;
using number::Rational;
using support::scene_of;
using surface::Sweep;

constexpr const char* kTriangle = "contour([[0, 0], [2, 0], [0, 1]]);";

const surface::SweptSurface& sweep_of(const Scene& scene, std::size_t leaf) {
  return *scene.leaves.at(leaf).surface.sweep;
}

TEST(SweepNodeTest, StatesHalfSpacesAndTheirCaps) {
  const Scene prism = scene_of(std::string("translational_sweep() ") + kTriangle);
  ASSERT_EQ(prism.leaves.size(), 3U);
  EXPECT_EQ(sweep_of(prism, 0).sweep(), Sweep::Translational);
  EXPECT_EQ(prism.leaves[0].path, "translational_sweep.side");
  EXPECT_EQ(prism.leaves[1].surface, surface::plane({0, 0, 1}, 0));
  EXPECT_EQ(prism.leaves[2].surface, surface::plane({0, 0, -1}, -1));
  EXPECT_EQ(prism.bounds->upper.x, 2);
  EXPECT_EQ(prism.bounds->upper.z, 1);

  const Scene pyramid = scene_of(std::string("conic_sweep() ") + kTriangle);
  ASSERT_EQ(pyramid.leaves.size(), 3U);
  EXPECT_EQ(sweep_of(pyramid, 0).sweep(), Sweep::Conic);

  const Scene turned =
      scene_of("rotational_sweep() contour([[0, 0], [3, 1], [0, 2]], closed=false);");
  ASSERT_EQ(turned.leaves.size(), 1U);
  EXPECT_EQ(turned.leaves[0].path, "rotational_sweep");
  EXPECT_FALSE(sweep_of(turned, 0).contour().closed());
  EXPECT_EQ(turned.bounds->lower.y, -3);

  const Scene infinite = scene_of(std::string("conic_sweep(capped=false) ") + kTriangle);
  EXPECT_EQ(infinite.leaves.size(), 1U);
  EXPECT_FALSE(infinite.bounds.has_value());
}

TEST(SweepNodeTest, BoundsWhatIsScaledByPolynomials) {
  const Scene scene =
      scene_of(std::string("generalised_conic_sweep([2, -3], [1, 0, 1]) ") + kTriangle);
  ASSERT_EQ(scene.leaves.size(), 3U);
  EXPECT_EQ(sweep_of(scene, 0).sweep(), Sweep::GeneralisedConic);
  // 2 - 3 z times 0 to 2, and 1 + z^2 times 0 to 1.
  EXPECT_EQ(scene.bounds->lower, (geometry::ExactPoint{-2, 0, 0}));
  EXPECT_EQ(scene.bounds->upper, (geometry::ExactPoint{4, 2, 1}));
}

TEST(SweepNodeTest, ReadsKindsOfContours) {
  const auto kind = [](const std::string& name) {
    const Scene scene =
        scene_of("translational_sweep() contour([[0, 0], [2, 0], [2, 2], [0, 1/3]], kind=\"" +
                 name + "\");");
    return sweep_of(scene, 0).contour().kind();
  };
  EXPECT_EQ(kind("line"), ContourKind::Line);
  EXPECT_EQ(kind("bspline"), ContourKind::BSpline);
  EXPECT_EQ(kind("catmull_rom"), ContourKind::CatmullRom);
}

TEST(SweepNodeTest, EqualContoursAreOne) {
  const Scene scene = scene_of(std::string("translational_sweep() ") + kTriangle +
                               "translate([5, 0, 0]) conic_sweep() " + kTriangle);
  EXPECT_EQ(&sweep_of(scene, 0).contour(), &sweep_of(scene, 3).contour());
}

TEST(SweepNodeTest, SweepsInOnePlaceShareACarrier) {
  const std::string text = std::string("translational_sweep() ") + kTriangle;
  const Scene scene =
      scene_of(text + "difference() {" + text + "translate([1, 0, 0]) " + text + "}");
  EXPECT_EQ(scene.leaves[0].carrier, scene.leaves[3].carrier);
  EXPECT_NE(scene.leaves[0].carrier, scene.leaves[6].carrier);
}

TEST(SweepNodeTest, ReadsExtrusionsOfOpenScad) {
  const Scene straight = scene_of(
      "linear_extrude(height = 4, center = true, convexity = 1, scale = [1, 1], $fn = 0) {\n"
      "  group() { polygon(points = [[0, 0], [2, 0], [0, 1]], paths = [[2, 1, 0]], convexity = 1); "
      "}\n"
      "}");
  ASSERT_EQ(straight.leaves.size(), 3U);
  EXPECT_EQ(straight.leaves[1].surface, surface::plane({0, 0, 1}, -2));
  EXPECT_EQ(straight.leaves[2].surface, surface::plane({0, 0, -1}, -2));
  EXPECT_EQ(sweep_of(straight, 0).contour().points().front(), (geometry::PlanePoint{0, 1}));

  const Scene left = scene_of("rotate_extrude() polygon([[-1, 0], [-3, 0], [-2, 1]]);");
  EXPECT_EQ(sweep_of(left, 0).contour().points()[1], (geometry::PlanePoint{3, 0}));
  const Scene box = scene_of("linear_extrude(2) square([2, 3], center = true);");
  EXPECT_EQ(box.bounds->lower.x, -1);
  EXPECT_EQ(box.bounds->upper.y, Rational(3, 2));
}

TEST(SweepNodeTest, AnExtrusionOfNothingIsEmpty) {
  const Scene scene = scene_of("linear_extrude(5) group();\nrotate_extrude() { group() {} }");
  EXPECT_TRUE(scene.leaves.empty());
  EXPECT_EQ(scene.warnings.size(), 2U);
  EXPECT_EQ(scene_of("linear_extrude(5) { square(1); group(); }").leaves.size(), 3U);
}

TEST(SweepNodeTest, WhatIsLeftOfTheAxisStaysOpen) {
  const Scene open = scene_of("rotate_extrude() contour([[0, 0], [-1, 1], [0, 2]], closed=false);");
  EXPECT_FALSE(sweep_of(open, 0).contour().closed());
  EXPECT_EQ(sweep_of(open, 0).contour().points()[1], (geometry::PlanePoint{1, 1}));
}

TEST(SweepNodeTest, NumbersBeyondTheDoublesAreReadAsAnyOthers) {
  const Scene scene = scene_of("conic_spline_sweep() contour([[1e200, 0], [1e200, 1]]);");
  EXPECT_GE(scene.bounds->upper.x, number::parse_rational("1e200"));
}

TEST(SweepNodeTest, ConicSplinesAndConeStacksAreOrdinaryTrees) {
  const Scene spline = scene_of("conic_spline_sweep() contour([[1, 0], [2, 1], [2, 2]]);");
  EXPECT_EQ(spline.leaves.size(), 12U);  // two conics an interval, and two planes each
  const Scene cones =
      scene_of("cone_stack(3) contour([[0, 0], [2, 1], [1, 2], [0, 3]], closed=false);");
  EXPECT_EQ(cones.leaves.size(), 9U);
}

TEST(SweepNodeTest, EachReadsBackFromItsText) {
  const std::string contour = "contour([[1, 0], [2, 1/3], [1, 2]], kind=\"bspline\")";
  for (const std::string sweep :
       {"translational_sweep() ", "conic_sweep(capped=false) ", "rotational_sweep() ",
        "generalised_conic_sweep([1, 1/3], [2, 0, 1]) "}) {
    const Scene scene = scene_of("translate([1, 2, 3]) " + sweep + contour + ";");
    const std::string text = text_of(syntax_of(scene));
    const Scene again = scene_of(text);
    ASSERT_EQ(again.leaves.size(), scene.leaves.size()) << text;
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
      EXPECT_EQ(again.carriers[again.leaves[i].carrier], scene.carriers[scene.leaves[i].carrier])
          << text;
    }
  }
}

TEST(SphereSweepNodeTest, StatesOneHalfSpaceAndItsBounds) {
  const Scene scene = scene_of(
      "sphere_sweep(1/4) contour([[0, 0, 0], [2, 0, 0], [2, 3, 1]], kind=\"catmull_rom\", "
      "closed=false);");
  ASSERT_EQ(scene.leaves.size(), 1U);
  EXPECT_EQ(scene.leaves[0].path, "sphere_sweep");
  const surface::SphereSweep& sweep = *scene.leaves[0].surface.sphere_sweep;
  EXPECT_EQ(sweep.radius(), Rational(1, 4));
  EXPECT_EQ(sweep.trajectory().kind(), ContourKind::CatmullRom);
  EXPECT_FALSE(sweep.trajectory().closed());
  EXPECT_LE(scene.bounds->lower.x, Rational(-1, 4));
  EXPECT_GE(scene.bounds->upper.y, Rational(13, 4));
  // In one place they share a carrier.
  const std::string text = "sphere_sweep(r=1) contour([[0, 0, 0], [2, 0, 0], [2, 3, 1]]);";
  const Scene two = scene_of(text + text + "translate([1, 0, 0]) " + text + "scale(1) sphere(1);");
  EXPECT_EQ(two.leaves[0].carrier, two.leaves[1].carrier);
  EXPECT_EQ(two.carriers.size(), 3U);
  EXPECT_TRUE(two.leaves[0].surface == two.leaves[1].surface);
}

TEST(SphereSweepNodeTest, ReadsBackFromItsText) {
  const Scene scene = scene_of(
      "rotate(quaternion=[1, 2, 3, 4]) sphere_sweep(1/3) contour([[0, 0, 0], [2, 0, 1/7], [2, 3, "
      "1]], kind=\"bspline\");");
  const std::string text = text_of(syntax_of(scene));
  const Scene again = scene_of(text);
  ASSERT_EQ(again.leaves.size(), 1U) << text;
  EXPECT_EQ(again.carriers[0], scene.carriers[0]) << text;
  EXPECT_TRUE(again.leaves[0].surface == scene.leaves[0].surface) << text;
}

TEST(SphereSweepNodeTest, ErrorsNameTheNodeAndThePoint) {
  using support::fails_at;
  EXPECT_TRUE(fails_at("sphere_sweep(1);", "1:1", "it takes one contour"));
  EXPECT_TRUE(fails_at("sphere_sweep() contour([[0, 0, 0], [1, 0, 0]], closed=false);", "1:1",
                       "the argument `r` is missing"));
  EXPECT_TRUE(fails_at("sphere_sweep(0) contour([[0, 0, 0], [1, 0, 0]], closed=false);", "1:1",
                       "must be positive"));
  EXPECT_TRUE(fails_at("sphere_sweep(1) square(1);", "1:17", "points in space"));
  EXPECT_TRUE(fails_at("sphere_sweep(1) contour([[0, 0], [1, 0]]);", "1:26", "3 numbers"));
  EXPECT_TRUE(fails_at("sphere_sweep(1) contour([[0, 0, 0], [1, 0, 0]]);", "1:17",
                       "a closed contour needs 3 points"));
  EXPECT_TRUE(fails_at("sphere_sweep(1) contour([[0, 0, 0], [1, 0, 0], [1, 0, 0]]);", "1:17",
                       "point 3 of the contour repeats point 2"));
  EXPECT_TRUE(
      fails_at("sphere_sweep(1) contour([[0, 0, 0], [1, 0, 0], [1, 1, 0]], kind=\"round\");",
               "1:17", "one of line, bspline, catmull_rom"));
}

TEST(SweepErrorTest, NamesTheNodeAndThePoint) {
  using support::fails_at;
  EXPECT_TRUE(fails_at("rotational_sweep();", "1:1", "it takes one contour"));
  EXPECT_TRUE(fails_at("rotational_sweep() cube();", "1:20", "a sweep takes a contour"));
  EXPECT_TRUE(fails_at("contour([[1, 0], [2, 1], [1, 3]]);", "1:1", "it is no solid"));
  EXPECT_TRUE(fails_at("conic_sweep() contour([[1, 0], [2, 1]]);", "1:15", "needs 3 points"));
  EXPECT_TRUE(fails_at("conic_sweep() contour([[1, 0], [2, 1], [2, 1]]);", "1:15",
                       "point 3 of the contour repeats point 2"));
  EXPECT_TRUE(fails_at("conic_sweep() contour([[1, 0], [2, 1], [1]]);", "1:40", "2 numbers"));
  EXPECT_TRUE(fails_at("conic_sweep() contour([[1, 0], [2, 1], [1, 3]], kind=\"round\");", "1:15",
                       "one of line, bspline, catmull_rom"));
  EXPECT_TRUE(fails_at("rotational_sweep() contour([[-1, 0], [2, 1], [1, 3]]);", "1:1", "point "));
  EXPECT_TRUE(fails_at("conic_sweep() contour([[0, 0], [2, 1], [0, 3]], closed=false);", "1:1",
                       "close it"));
  EXPECT_TRUE(fails_at("generalised_conic_sweep([0], [1]) contour([[0, 0], [2, 1], [0, 3]]);",
                       "1:1", "cannot be scaled by zero"));
  EXPECT_TRUE(fails_at("generalised_conic_sweep([1]) contour([[0, 0], [2, 1], [0, 3]]);", "1:1",
                       "generalised_conic_sweep(x = "));
  EXPECT_TRUE(fails_at("linear_extrude(2, twist = 3) square(1);", "1:27", "leave `twist` out"));
  EXPECT_TRUE(fails_at("linear_extrude(2, scale = 2) square(1);", "1:27", "leave `scale` out"));
  EXPECT_TRUE(fails_at("rotate_extrude(angle = 90) square(1);", "1:24", "leave `angle` out"));
  EXPECT_TRUE(fails_at("linear_extrude(2) polygon([[0, 0], [1, 0], [0, 1]], paths = [[0, 1, 3]]);",
                       "1:61", "point 3 of `paths`"));
  EXPECT_TRUE(fails_at("conic_spline_sweep() contour([[1, 0], [2, 1]], kind=\"line\");", "1:53",
                       "leave `kind` out"));
  EXPECT_TRUE(fails_at("conic_spline_sweep(arcs=[[3, 1, 0]]) contour([[1, 0], [2, 1]]);", "1:25",
                       "from 1 to 2"));
  EXPECT_TRUE(fails_at("cone_stack(0) contour([[1, 0], [2, 1], [1, 3]]);", "1:12", "whole number"));
}

}  // namespace
}  // namespace lamina::scene
