#include "trace/ray_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/number_types.hpp"
#include "support/scenes.hpp"

namespace lamina::trace {
namespace {

using geometry::ExactPoint;
using geometry::ExactRay;
using number::Rational;

constexpr const char* kBall = "material(\"glass\", color=[1, 1, 1, 1/2]) sphere(1);";

double value(const Rational& q) { return number::nearest_double(q); }

class RayPathTest : public ::testing::Test {
 protected:
  void begin(const std::string& text, const std::string& method, const ExactRay& ray) {
    scene_ = support::scene_of(text);
    path_ = make_ray_path<double>(scene_, {});
    method_ = method::parse_method(method);
    path_->start(ray);
    path_->run(method_, report_);
  }

  std::optional<ExactPoint> spawn(const Spawn& spawn) {
    const auto direction = path_->spawn(method_, spawn);
    if (direction) {
      path_->run(method_, report_);
    }
    return direction;
  }

  // t of the first interface; -1 if there is none.
  [[nodiscard]] double first_t() const {
    return report_.interfaces.empty() ? -1 : path_->t(report_.interfaces.front().crossing);
  }

  scene::Scene scene_;
  std::unique_ptr<RayPath> path_;
  method::Method method_;
  method::Report report_;
};

TEST_F(RayPathTest, ReflectsAtTheAngleOfIncidence) {
  begin(kBall, "regularized", {{0, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(first_t(), 4);
  const auto back = spawn({.branch = Branch::Reflection});
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, (ExactPoint{0, 0, 1}));
  EXPECT_EQ(first_t(), -1);

  begin("halfspace([0, 3, 4], 0);", "regularized", {{0, 0, 5}, {0, 0, -1}});
  const auto aside = spawn({.branch = Branch::Reflection});
  ASSERT_TRUE(aside);
  // d - 2 (d.n) n with n = (0, 3/5, 4/5).
  EXPECT_NEAR(value(aside->y), 24.0 / 25, 1e-15);
  EXPECT_NEAR(value(aside->z), 7.0 / 25, 1e-15);
}

TEST_F(RayPathTest, GoesStraightOnWithoutRefraction) {
  begin(kBall, "wyvill-trotman", {{0, 0, 5}, {0, 0, -1}});
  const auto on = spawn({.branch = Branch::Transmission});
  ASSERT_TRUE(on);
  EXPECT_EQ(*on, (ExactPoint{0, 0, -1}));
  EXPECT_EQ(first_t(), 2);
  EXPECT_EQ(report_.start, report_.interfaces.front().transition.from);
}

// Of a medium below z = 0 with an index of refraction.
std::string below(const std::string& index) {
  return "material(\"m\", index=" + index + ") halfspace([0, 0, 1], 0);";
}

// sin(angle of refraction) = ratio of the indices * sin(angle of incidence), Snell.
TEST_F(RayPathTest, RefractsBySnellsLaw) {
  for (const auto& [index, ratio] : {std::pair{"3/2", 2.0 / 3}, {"8/9", 9.0 / 8}}) {
    begin(below(index), "wyvill-trotman", {{0, -3, 4}, {0, 3, -4}});
    const auto on = spawn({.branch = Branch::Transmission});
    ASSERT_TRUE(on);
    const double sine = value(on->y) / std::hypot(value(on->y), value(on->z));
    EXPECT_NEAR(sine, ratio * 3 / 5, 1e-15);
    EXPECT_LT(on->z, 0);
  }
}

TEST_F(RayPathTest, IsReflectedTotallyBeyondTheCriticalAngle) {
  // The critical sine is the index below; that of the ray is 3/5.
  for (const auto& [index, refracts] : {std::pair{"0.6001", true}, {"0.5999", false}}) {
    begin(below(index), "wyvill-trotman", {{0, -3, 4}, {0, 3, -4}});
    EXPECT_EQ(spawn({.branch = Branch::Transmission}).has_value(), refracts);
  }
}

// Plates of several indices with parallel faces: the ray leaves as it came.
TEST_F(RayPathTest, LeavesAStackOfPlatesInTheDirectionItCame) {
  begin(
      "material(\"a\", index=3/2) intersection() { halfspace([0, 0, 1], 3); "
      "halfspace([0, 0, -1], -2); }"
      "material(\"b\", index=13/10) intersection() { halfspace([0, 0, 1], 2); "
      "halfspace([0, 0, -1], -1); }"
      "material(\"c\", index=2) intersection() { halfspace([0, 0, 1], 1); "
      "halfspace([0, 0, -1], 0); }",
      "wyvill-trotman:secondary:cluster", {{0, -3, 7}, {0, 3, -4}});
  std::optional<ExactPoint> direction;
  std::string media;
  for (int face = 0; face < 4; ++face) {
    ASSERT_EQ(report_.interfaces.size(), 1u) << face;
    media += scene_.materials[report_.interfaces.front().transition.to].name;
    direction = spawn({.branch = Branch::Transmission});
    ASSERT_TRUE(direction) << face;
  }
  EXPECT_EQ(media, "abc");
  EXPECT_TRUE(report_.interfaces.empty());
  EXPECT_NEAR(value(direction->y) / value(direction->z), -3.0 / 4, 1e-15);
}

TEST_F(RayPathTest, ShadowRaysEndAtTheLight) {
  begin("sphere(1); translate([0, 0, 9]) sphere(1);", "regularized", {{0, 5, 5}, {0, -4, -4}});
  ASSERT_GT(first_t(), 0);
  const auto towards = spawn({.branch = Branch::Shadow, .light = {0, 0, 12}});
  ASSERT_TRUE(towards);
  // s = 1 is the light; the second ball is before it.
  EXPECT_GT(first_t(), 0.5);
  EXPECT_LT(first_t(), 1);
}

TEST_F(RayPathTest, StartsWhereThePolicySays) {
  // Reflected straight back from z = 1: the far plane z = 9 is 8 away less the offset.
  const std::string text = "halfspace([0, 0, 1], 1); halfspace([0, 0, -1], -9);";
  const auto away = [&](const std::string& policy) {
    begin(text, "regularized", {{0, 0, 5}, {0, 0, -2}});
    EXPECT_TRUE(spawn({.policy = parse_spawn(policy)}));
    return 8 - 2 * first_t();
  };
  EXPECT_EQ(away("none"), 0);
  EXPECT_EQ(away("offset:1/4"), 0.25);
  EXPECT_EQ(away("normal-offset:1/4"), 0.25);
  EXPECT_EQ(away("offset:1/64:relative"), 5.0 / 64);
  EXPECT_EQ(away("ulp-offset"), 256 * std::ldexp(1.0, -52));
}

// One branch after the other at each hit, as a tree is gone through.
TEST_F(RayPathTest, GoesBackToTheRayThatSpawned) {
  begin(kBall, "wyvill-trotman", {{0, 0, 5}, {0, 0, -1}});
  ASSERT_TRUE(spawn({.branch = Branch::Transmission}));
  EXPECT_EQ(first_t(), 2);
  ASSERT_TRUE(spawn({.branch = Branch::Transmission}));
  EXPECT_EQ(first_t(), -1);
  path_->back();
  ASSERT_TRUE(path_->hit());
  EXPECT_EQ(path_->hit()->point.z, -1);
  const auto inner = spawn({.branch = Branch::Reflection});
  ASSERT_TRUE(inner);
  EXPECT_EQ(*inner, (ExactPoint{0, 0, 1}));
  EXPECT_EQ(first_t(), 2);
  path_->back();
  path_->back();
  EXPECT_EQ(path_->hit()->point.z, 1);
  EXPECT_EQ(path_->hit()->gradient.z, 2);
  ASSERT_TRUE(spawn({.branch = Branch::Reflection}));
  EXPECT_EQ(first_t(), -1);
}

// From a point 1 ulp or so off the sphere, along a chord of it.
TEST_F(RayPathTest, DividesOutTheRootOfTheSurfaceItLeaves) {
  const std::string text = "translate([1/3, 0, 0]) { sphere(1); sphere(1); }";
  for (int i = 1; i <= 32; ++i) {
    begin(text, "regularized", {{Rational(i, 64), 0, 5}, {0, Rational(1, 64), -1}});
    ASSERT_GT(first_t(), 0);
    ASSERT_TRUE(spawn({.branch = Branch::Transmission, .policy = parse_spawn("divide-out")}));
    ASSERT_GT(first_t(), 0.5) << i;
    std::size_t at_zero = 0;
    for (std::size_t c = 0; c < path_->crossings().size(); ++c) {
      at_zero += path_->t(c) == 0 ? 1 : 0;
    }
    EXPECT_EQ(at_zero, 2u);
  }
}

// A method that carries nothing from ray to ray hits where it starts, or not, as rounding has it;
// with the leaf's state it does not.
TEST_F(RayPathTest, ALeafStateRejectsWhatContradictsIt) {
  int hits_itself = 0;
  for (int i = 1; i <= 64; ++i) {
    const ExactRay ray{{Rational(i, 64), 0, 5}, {0, Rational(1, 64), -1}};
    begin("translate([1/3, 0, 0]) sphere(1);", "regularized", ray);
    ASSERT_TRUE(spawn({}));
    hits_itself += first_t() >= 0 ? 1 : 0;
    begin("translate([1/3, 0, 0]) sphere(1);", "regularized", ray);
    ASSERT_TRUE(spawn({.policy = parse_spawn("leaf-state")}));
    EXPECT_EQ(first_t(), -1) << i;
    begin("translate([1/3, 0, 0]) sphere(1);", "regularized", ray);
    ASSERT_TRUE(spawn({.policy = parse_spawn("error-bound")}));
    EXPECT_EQ(first_t(), -1) << i;
  }
  EXPECT_GT(hits_itself, 5);
}

TEST_F(RayPathTest, HasNothingToSpawnAtWithoutAnInterface) {
  begin(kBall, "regularized", {{0, 5, 5}, {0, 0, -1}});
  EXPECT_EQ(first_t(), -1);
  EXPECT_FALSE(spawn({}));
}

// (A add C) - B of which A and B share a plane: A's event first, then B's is the hit.
class ClearedFaceTest : public RayPathTest {
 protected:
  void begin_with(const std::string& method) {
    begin(
        "difference() { material(\"A\") halfspace([0, 0, 1], 0); intersection() { "
        "halfspace([0, 0, -1], 0); halfspace([0, 0, 1], 3); } }",
        method, {{0, 0, 5}, {0, 0, -1}});
    ASSERT_EQ(first_t(), 5);
  }
};

TEST_F(ClearedFaceTest, InheritedStatesStayInsideOfWhatWasCrossedBeforeTheHit) {
  begin_with("wyvill-trotman");
  ASSERT_TRUE(spawn({}));
  EXPECT_EQ(first_t(), 3);  // where B ends, A begins: a ghost
}

TEST_F(ClearedFaceTest, TheClustersStatesAreThoseBeforeTheClass) {
  begin_with("wyvill-trotman:secondary:cluster");
  ASSERT_TRUE(spawn({}));
  EXPECT_EQ(first_t(), -1);
}

TEST_F(ClearedFaceTest, HybridStatesAreRight) {
  begin_with("wyvill-trotman:secondary:hybrid");
  ASSERT_TRUE(spawn({}));
  EXPECT_EQ(first_t(), -1);
}

template <typename Number>
class EveryRayPathTest : public ::testing::Test {};
TYPED_TEST_SUITE(EveryRayPathTest, support::RoundedNumberTypes);

// Inside a mirror ball a ray turns by the same angle at each bounce: at the distance z from the
// middle, by an angle of cosine 2 z^2 - 1.
TYPED_TEST(EveryRayPathTest, TurnsByTheSameAngleAtEveryBounceInABall) {
  const Rational z(11, 16);
  const double cosine = value(Rational(2 * z * z - 1));
  const double tolerance =
      1e-14 + std::ldexp(64.0, -number::number_traits<TypeParam>::kSignificandBits);
  const scene::Scene scene =
      support::scene_of("difference() { halfspace([0, 0, 1], 9); sphere(1); }");
  const auto path = make_ray_path<TypeParam>(scene, {});
  const method::Method method = method::parse_method("wyvill-trotman:secondary:cluster");
  method::Report report;
  ExactPoint before{1, 0, 0};
  path->start({{0, 0, -z}, before});
  for (int bounce = 0; bounce < 8; ++bounce) {
    path->run(method, report);
    ASSERT_EQ(report.interfaces.size(), 1u) << bounce;
    const auto next = path->spawn(method, {});
    ASSERT_TRUE(next) << bounce;
    const double lengths = std::sqrt(value(dot(before, before)) * value(dot(*next, *next)));
    EXPECT_NEAR(value(dot(before, *next)) / lengths, cosine, tolerance) << bounce;
    before = *next;
  }
}

}  // namespace
}  // namespace lamina::trace
