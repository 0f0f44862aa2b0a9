#include "scene/rounding.hpp"

#include <gtest/gtest.h>

#include "base/seeded_stream.hpp"
#include "method/tracer.hpp"
#include "scene/families.hpp"
#include "support/print.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using geometry::AffineMap;
using number::Integer;
using number::Rational;
using support::scene_of;

// Does a binary float of so many bits, and of any exponent, hold the value?
bool fits(const Rational& value, int bits) {
  Integer odd = abs(numerator(value));
  while (odd != 0 && odd % 2 == 0) {
    odd /= 2;
  }
  Integer power = denominator(value);
  while (power % 2 == 0) {
    power /= 2;
  }
  return power == 1 && odd < Integer(1) << static_cast<unsigned>(bits);
}

void expect_equal_scenes(const Scene& actual, const Scene& expected) {
  EXPECT_EQ(actual.frames, expected.frames);
  EXPECT_EQ(actual.carriers, expected.carriers);
  EXPECT_EQ(actual.leaves_of_carrier, expected.leaves_of_carrier);
  ASSERT_EQ(actual.leaves.size(), expected.leaves.size());
  for (std::size_t i = 0; i < actual.leaves.size(); ++i) {
    EXPECT_EQ(actual.leaves[i].surface, expected.leaves[i].surface);
    EXPECT_EQ(actual.leaves[i].frame, expected.leaves[i].frame);
    EXPECT_EQ(actual.leaves[i].carrier, expected.leaves[i].carrier);
    EXPECT_EQ(actual.leaves[i].side, expected.leaves[i].side);
    EXPECT_EQ(actual.leaves[i].medium, expected.leaves[i].medium);
  }
}

TEST(RoundingTest, RoundsToTheNearestOrToNothing) {
  EXPECT_EQ(rounding<float>(Rational(1, 3)), Rational(11184811, 33554432));
  EXPECT_EQ(rounding<float>(Rational(-3, 4)), Rational(-3, 4));
  EXPECT_EQ(rounding<number::exact>(Rational(1, 3)), Rational(1, 3));
  const Rational large = number::parse_rational("1e39");
  EXPECT_EQ(rounding<float>(large), std::nullopt);
  EXPECT_EQ(rounding<float>(Rational(-large)), std::nullopt);
  EXPECT_TRUE(rounding<double>(large));
  EXPECT_EQ(rounding<float>(Rational(1 / large / large)), Rational(0));
}

TEST(RoundingTest, WhatIsHeldExactlyStaysAsItIs) {
  const Scene scene = scene_of(R"(
    material("a") translate([1/4, -3, 1000]) scale([2, 1/8, 4]) difference() {
      cube([1, 2.5, 3]);
      rotate([0, 0, 90]) translate([1/2, 1/2, 1/2]) cube([2, 1/2, 1]);
    }
    material("b") mirror([0, 0, 1]) { sphere(3/2); torus(3, 1/2); }
    translate([1/4, -3, 1000]) halfspace([0, 1, 2], 3);)");
  ASSERT_GE(scene.frames.size(), 4U);
  const auto rounded = rounded_scene(scene, rounding<float>);
  ASSERT_TRUE(rounded);
  expect_equal_scenes(*rounded, scene);
  const auto constants = scene_of_constants(*rounded, rounding<float>);
  ASSERT_TRUE(constants);
  expect_equal_scenes(*constants, scene);
}

TEST(RoundingTest, ExactNumbersKeepEveryScene) {
  for (std::uint64_t case_id = 0; case_id < 20; ++case_id) {
    const Scene scene = scene_of(coincident_faces(1, case_id).text);
    const auto rounded = rounded_scene(scene, rounding<number::exact>);
    ASSERT_TRUE(rounded);
    expect_equal_scenes(*rounded, scene);
    const auto constants = scene_of_constants(*rounded, rounding<number::exact>);
    ASSERT_TRUE(constants);
    expect_equal_scenes(*constants, scene);
  }
}

TEST(RoundingTest, OfASphereSweepThePointsAndTheRadiusAreRounded) {
  const Scene scene = scene_of(
      "sphere_sweep(1/3) contour([[0, 1/3, 0], [2, 0, 0], [2, 0, 1/5]], kind=\"bspline\");");
  const auto held = rounded_surface(scene.leaves[0].surface, rounding<float>);
  ASSERT_TRUE(held);
  EXPECT_EQ(held->sphere_sweep->radius(), Rational(11184811, 33554432));
  EXPECT_EQ(held->sphere_sweep->trajectory().points()[0].y, Rational(11184811, 33554432));
  EXPECT_EQ(held->sphere_sweep->trajectory().points()[1].x, 2);
  EXPECT_EQ(held->sphere_sweep->trajectory().kind(), geometry::ContourKind::BSpline);
  const auto far = scene_of("sphere_sweep(1) contour([[1e39, 0, 0], [2, 0, 0]], closed=false);");
  EXPECT_FALSE(rounded_surface(far.leaves[0].surface, rounding<float>));
  const auto one =
      scene_of("sphere_sweep(1) contour([[1, 0, 0], [1.000000001, 0, 0]], closed=false);");
  EXPECT_FALSE(rounded_surface(one.leaves[0].surface, rounding<float>));
}

TEST(RoundingTest, LeavesThatAreRoundedApartGetTheirOwnCarriers) {
  const Scene scene =
      scene_of("translate([0, 0, 1/3]) halfspace([0, 0, 1], 4); halfspace([0, 0, -1], -13/3);");
  ASSERT_EQ(scene.carriers.size(), 1U);
  const auto rounded = rounded_scene(scene, rounding<float>);
  ASSERT_TRUE(rounded);
  ASSERT_EQ(rounded->carriers.size(), 2U);
  EXPECT_NE(rounded->leaves[0].carrier, rounded->leaves[1].carrier);
  for (csg::LeafIndex i = 0; i < 2; ++i) {
    EXPECT_EQ(rounded->leaves_of_carrier[rounded->leaves[i].carrier],
              std::vector<csg::LeafIndex>{i});
  }
  // By hand: where the planes are now.
  const Rational first = 4 + Rational(11184811, 33554432);
  const Rational second(9087659, 2097152);
  EXPECT_EQ(surface::sign_at(rounded->carriers[rounded->leaves[0].carrier], {7, 8, first}), 0);
  EXPECT_EQ(surface::sign_at(rounded->carriers[rounded->leaves[1].carrier], {7, 8, second}), 0);
}

TEST(RoundingTest, LeavesThatAreRoundedTogetherShareACarrier) {
  const Scene scene = scene_of(
      "halfspace([0, 0, 1], 1/3); halfspace([0, 0, -1], -333333333334/1000000000000);"
      "halfspace([0, 0, 1], 1/2);");
  ASSERT_EQ(scene.carriers.size(), 3U);
  const auto rounded = rounded_scene(scene, rounding<float>);
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->carriers.size(), 2U);
  EXPECT_EQ(rounded->leaves_of_carrier, (std::vector<std::vector<csg::LeafIndex>>{{0, 1}, {2}}));
  EXPECT_EQ(rounded->leaves[0].side, -rounded->leaves[1].side);
}

template <typename Number>
void expect_entries_held() {
  constexpr int kBits = number::number_traits<Number>::kSignificandBits;
  const Rational unit(1, Integer(1) << static_cast<unsigned>(kBits));  // half an ulp, relative
  std::size_t changed = 0;
  for (std::uint64_t case_id = 0; case_id < 30; ++case_id) {
    const Scene scene = scene_of(coincident_faces(3, case_id).text);
    const auto rounded = rounded_scene(scene, rounding<Number>);
    ASSERT_TRUE(rounded);
    const auto constants = scene_of_constants(*rounded, rounding<Number>);
    ASSERT_TRUE(constants);
    for (std::size_t f = 0; f < scene.frames.size(); ++f) {
      const AffineMap ideal = inverse(scene.frames[f]).value();
      const AffineMap placement = inverse(rounded->frames[f]).value();
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          const auto expect_nearest = [&](const Rational& value, const Rational& exact) {
            EXPECT_TRUE(fits(value, kBits)) << value << " for " << exact;
            EXPECT_LE(Rational(abs(value - exact)), Rational(unit * abs(exact)));
            changed += value != exact ? 1 : 0;
          };
          expect_nearest(placement.rows[i][j], ideal.rows[i][j]);
          expect_nearest(constants->frames[f].rows[i][j], rounded->frames[f].rows[i][j]);
        }
      }
    }
    for (std::size_t leaf = 0; leaf < scene.leaves.size(); ++leaf) {
      EXPECT_EQ(constants->leaves[leaf].surface, rounded->leaves[leaf].surface);
      for (std::size_t c = 0; c < 10; ++c) {
        const Rational& value = rounded->leaves[leaf].surface.coefficients[c];
        const Rational& exact = scene.leaves[leaf].surface.coefficients[c];
        EXPECT_TRUE(fits(value, kBits)) << value;
        EXPECT_LE(Rational(abs(value - exact)), Rational(unit * abs(exact)));
      }
    }
  }
  EXPECT_GE(changed, 100U);
}

TEST(RoundingTest, EveryEntryIsHeldByTheNumberTypeAndNearest) {
  expect_entries_held<number::bin<11>>();
  expect_entries_held<float>();
  expect_entries_held<double>();
  expect_entries_held<number::bin<113>>();
}

TEST(RoundingTest, APlacementThatBecomesSingularKeepsItsFrame) {
  const Scene scene = scene_of("translate([1/3, 0, 0]) scale([1, 1, 1e-60]) cube(1);");
  EXPECT_EQ(inverse_of_rounded_placement(scene.frames[0], rounding<float>), scene.frames[0]);
  EXPECT_NE(inverse_of_rounded_placement(scene.frames[0], rounding<double>), scene.frames[0]);
  const auto rounded = rounded_scene(scene, rounding<float>);
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->frames, scene.frames);
  EXPECT_FALSE(scene_of_constants(*rounded, rounding<float>));  // 1e60 overflows
  const auto in_double = rounded_scene(scene, rounding<double>);
  ASSERT_TRUE(in_double);
  EXPECT_TRUE(scene_of_constants(*in_double, rounding<double>));
}

TEST(RoundingTest, APlacementThatOverflowsKeepsItsFrame) {
  const Scene scene = scene_of("scale(1e50) translate([1/3, 0, 0]) cube(1);");
  const auto rounded = rounded_scene(scene, rounding<float>);
  ASSERT_TRUE(rounded);
  EXPECT_EQ(rounded->frames, scene.frames);
  EXPECT_FALSE(scene_of_constants(*rounded, rounding<float>));  // 1e-50 is zero: singular
}

TEST(RoundingTest, ASurfaceThatIsLostLeavesNoScene) {
  const auto in_float = [](const char* text) {
    return rounded_scene(scene_of(text), rounding<float>).has_value();
  };
  const auto in_double = [](const char* text) {
    return rounded_scene(scene_of(text), rounding<double>).has_value();
  };
  for (const char* text :
       {"sphere(1e30);", "halfspace([1e-60, 0, 0], 1);", "halfspace([1e60, 0, 0], 1);"}) {
    EXPECT_FALSE(in_float(text)) << text;
    EXPECT_TRUE(in_double(text)) << text;
  }
}

// Planes and rays along the axes make every entry of the inverse map visible: f at the origin
// is the entry of the translation, and its slope one of the others. There is one rounding, that
// of the quotient.
template <typename Number>
void expect_the_tracers_constants() {
  using Traits = number::number_traits<Number>;
  constexpr const char* kPlanes =
      "{ halfspace([1, 0, 0], 0); halfspace([0, 1, 0], 0); "
      "halfspace([0, 0, 1], 0); }";
  std::size_t compared = 0;
  for (std::uint64_t case_id = 0; case_id < 40; ++case_id) {
    base::SeededStream stream("scene/rounding_test", 1, case_id);
    const auto number = [&stream] {
      const std::int64_t dividend = stream.integer(1, 40);
      return number::to_text(Rational(dividend, stream.integer(1, 40)));
    };
    std::string text;
    for (const char* map : {"translate", "rotate", "scale"}) {
      text += std::string(map) + "([" + number();
      text += ", " + number();
      text += ", " + number() + "]) ";
    }
    const Scene scene = scene_of(text + kPlanes);
    const auto constants =
        scene_of_constants(rounded_scene(scene, rounding<Number>).value(), rounding<Number>);
    ASSERT_TRUE(constants);
    const auto tracer = method::make_tracer<Number>(scene, {});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<Rational, 3> d{};
      d[axis] = 1;
      tracer->find({{0, 0, 0}, {d[0], d[1], d[2]}});
      ASSERT_EQ(tracer->crossings().size(), 3U);
      for (std::size_t c = 0; c < 3; ++c) {
        const Leaf& leaf = scene.leaves[tracer->crossings()[c].leaf];
        const std::size_t row = leaf.surface.coefficients[0] != 0   ? 0
                                : leaf.surface.coefficients[1] != 0 ? 1
                                                                    : 2;
        const auto& entries = constants->frames[leaf.frame].rows[row];
        const Number expected = Traits::from_exact(Rational(-entries[3] / entries[axis]));
        EXPECT_EQ(tracer->t(c), static_cast<double>(expected))
            << "case " << case_id << ", entry " << row << " " << axis;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 360U);
}

TEST(RoundingTest, TheConstantsAreTheTracers) {
  expect_the_tracers_constants<number::bin<11>>();
  expect_the_tracers_constants<float>();
  expect_the_tracers_constants<double>();
}

}  // namespace
}  // namespace lamina::scene
