// Rays in special position at sphere sweeps, by hand: exactly, and in double where all that
// follows from the ray's numbers is exact there.
#include "surface/sphere_sweep.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/contract.hpp"
#include "surface/rounded_sphere_sweep.hpp"

namespace lamina::surface {
namespace {

using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::Trajectory;
using number::Rational;
using Points = std::vector<ExactPoint>;
using Times = std::vector<Rational>;

SphereSweep sweep(const Rational& radius, Points points, ContourKind kind = ContourKind::Line,
                  bool closed = false) {
  return {radius, std::make_shared<const Trajectory>(std::move(points), kind, closed)};
}

// The t of the crossings, which are rational in these tests.
Times exact_times(const SphereSweep& surface, const ExactRay& ray) {
  const SphereSweep::Crossings found = surface.crossings(ray);
  EXPECT_FALSE(found.in_boundary);
  Times times;
  for (const number::Root& root : found.t) {
    const Rational t(number::nearest_double(root));
    EXPECT_TRUE(compare(root, t) == 0);
    times.push_back(t);
  }
  return times;
}

Times double_times(const SphereSweep& surface, const ExactRay& ray) {
  std::vector<RoundedSphereSweep<double>::Crossing> crossings;
  EXPECT_TRUE(RoundedSphereSweep<double>(surface).find_crossings(
      {nearest_double(ray.origin), nearest_double(ray.direction)}, {}, crossings));
  Times times;
  for (const auto& crossing : crossings) {
    times.emplace_back(crossing.t);
  }
  return times;
}

void expect_times(const SphereSweep& surface, const ExactRay& ray, const Times& times) {
  EXPECT_EQ(exact_times(surface, ray), times);
  EXPECT_EQ(double_times(surface, ray), times);
}

TEST(SphereSweepTest, ACapsuleIsCrossedWhereItsCylinderAndBallsAre) {
  const SphereSweep capsule = sweep(5, {{0, 0, 0}, {8, 0, 0}});
  expect_times(capsule, {{-9, 0, 0}, {1, 0, 0}}, {4, 22});
  expect_times(capsule, {{-9, 3, 0}, {1, 0, 0}}, {5, 21});
  expect_times(capsule, {{4, -9, 3}, {0, 2, 0}}, {Rational(5, 2), Rational(13, 2)});
  expect_times(capsule, {{-3, 0, -9}, {0, 0, 1}}, {5, 13});
  expect_times(capsule, {{-6, 0, -9}, {0, 0, 1}}, {});
}

TEST(SphereSweepTest, ATouchIsNoCrossing) {
  const SphereSweep capsule = sweep(1, {{0, 0, 0}, {8, 0, 0}});
  expect_times(capsule, {{4, -3, 1}, {0, 1, 0}}, {});
  expect_times(capsule, {{-1, -3, 0}, {0, 1, 0}}, {});
  // Two straight parts whose walls touch: the ray goes from one into the other.
  const SphereSweep two = sweep(1, {{0, 0, 0}, {8, 0, 0}, {8, 9, 0}, {0, 9, 0}, {0, 2, 0}});
  expect_times(two, {{0, -3, 0}, {0, 1, 0}}, {2, 13});
}

TEST(SphereSweepTest, OverlappingAndTouchingPartsAreOne) {
  const Points way{{0, 0, 0}, {8, 0, 0}, {8, 3, 0}, {0, 3, 0}};
  const ExactRay ray{{2, -5, 0}, {0, 1, 0}};
  expect_times(sweep(1, way), ray, {4, 6, 7, 9});
  expect_times(sweep(Rational(3, 2), way), ray, {Rational(7, 2), Rational(19, 2)});
  expect_times(sweep(2, way), ray, {3, 10});
}

TEST(SphereSweepTest, ARayAlongAWallIsInTheBoundary) {
  const ExactRay ray{{-5, 0, 1}, {1, 0, 0}};
  const SphereSweep capsule = sweep(1, {{0, 0, 0}, {8, 0, 0}});
  EXPECT_TRUE(capsule.crossings(ray).in_boundary);
  std::vector<RoundedSphereSweep<double>::Crossing> crossings;
  EXPECT_FALSE(
      RoundedSphereSweep<double>(capsule).find_crossings({{-5, 0, 1}, {1, 0, 0}}, {}, crossings));
  // Inside of another part all along.
  const SphereSweep covered = sweep(1, {{0, 0, 0}, {8, 0, 0}, {8, 0, 1}, {0, 0, 1}});
  expect_times(covered, ray, {4, 14});
  // A spline along a line, there and back.
  const SphereSweep back = sweep(1, {{0, 0, 0}, {8, 0, 0}, {2, 0, 0}}, ContourKind::CatmullRom);
  EXPECT_TRUE(back.crossings(ray).in_boundary);
}

// At its points this trajectory is at right angles to the axes, and bends with a radius of 1/4: by
// symmetry, balls smaller than that are met there first and last.
TEST(SphereSweepTest, ASmoothBendIsMetAtItsBall) {
  const Points square{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  expect_times(sweep(Rational(1, 8), square, ContourKind::CatmullRom, true),
               {{-3, 0, 0}, {1, 0, 0}},
               {Rational(15, 8), Rational(17, 8), Rational(31, 8), Rational(33, 8)});
}

TEST(SphereSweepTest, SidesAreThoseOfTheNearestBall) {
  const SphereSweep capsule = sweep(5, {{0, 0, 0}, {8, 0, 0}});
  EXPECT_EQ(capsule.side({4, 3, 4}), 0);
  EXPECT_EQ(capsule.side({-3, 0, 4}), 0);
  EXPECT_EQ(capsule.side({4, 3, Rational(39, 10)}), -1);
  EXPECT_EQ(capsule.side({-3, 0, Rational(41, 10)}), 1);
  EXPECT_EQ(capsule.side({8, 0, 0}), -1);
  const RoundedSphereSweep<double> rounded(capsule);
  std::vector<RoundedSphereSweep<double>::Crossing> scratch;
  EXPECT_EQ(rounded.side({4, 3, 4}, {}, scratch), 0);
  EXPECT_EQ(rounded.side({-3, 0, 3.9}, {}, scratch), -1);
  EXPECT_EQ(rounded.side({-3, 0, 4.1}, {}, scratch), 1);
  EXPECT_EQ(rounded.side({1e6, 0, 0}, {}, scratch), 1);
}

TEST(SphereSweepTest, NormalsPointAwayFromTheTrajectory) {
  const SphereSweep capsule = sweep(5, {{0, 0, 0}, {8, 0, 0}});
  EXPECT_EQ(capsule.normal_near({4, 3, 4}), (ExactPoint{0, 3, 4}));
  EXPECT_EQ(capsule.normal_near({-3, 0, 4}), (ExactPoint{-3, 0, 4}));
  EXPECT_EQ(capsule.normal_near({12, 0, 3}), (ExactPoint{4, 0, 3}));
}

TEST(SphereSweepTest, CountsTheFeetOfAPoint) {
  EXPECT_TRUE(sweep(5, {{0, 0, 0}, {8, 0, 0}}).has_one_foot({4, 3, 4}));
  EXPECT_TRUE(sweep(1, {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}}).has_one_foot({8, 0, 1}));
  const Points square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  EXPECT_FALSE(sweep(1, square, ContourKind::Line, true).has_one_foot({0, 0, 0}));
}

TEST(SphereSweepTest, TheRadiusMustBePositive) {
  EXPECT_THROW(sweep(0, {{0, 0, 0}, {8, 0, 0}}), base::InputError);
  EXPECT_THROW(sweep(-1, {{0, 0, 0}, {8, 0, 0}}), base::InputError);
}

TEST(SphereSweepTest, NumbersBeyondTheRangeBreakNothing) {
  const Rational large = number::parse_rational("1e30");
  std::vector<RoundedSphereSweep<float>::Crossing> crossings;
  RoundedSphereSweep<float>(sweep(large, {{0, 0, 0}, {large, 0, 0}}, ContourKind::BSpline))
      .find_crossings({{-1e31F, 0, 0}, {1e30F, 0, 0}}, {}, crossings);
  for (const auto& crossing : crossings) {
    EXPECT_EQ(crossing.t - crossing.t, 0);
  }
}

}  // namespace
}  // namespace lamina::surface
