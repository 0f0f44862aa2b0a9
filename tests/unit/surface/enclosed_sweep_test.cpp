#include "surface/enclosed_sweep.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace lamina::surface {
namespace {

using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Interval;
using number::Rational;
using number::Root;

constexpr int kBits = 128;

EnclosedSweep sweep_of(Sweep sweep, std::vector<PlanePoint> points, bool closed = true) {
  const auto contour =
      std::make_shared<const geometry::Contour>(std::move(points), ContourKind::Line, closed);
  return EnclosedSweep(
      std::make_shared<const PlacedSweep>(PlacedSweep{SweptSurface(sweep, contour), {}}));
}

EnclosedSweep::EnclosedPoint enclosed(const ExactPoint& p) {
  return {Interval(p.x, kBits), Interval(p.y, kBits), Interval(p.z, kBits)};
}

EnclosedSweep::Start start_at(const EnclosedSweep& sweep, const ExactPoint& point) {
  return {true, sweep.curves_at({point, {1, 2, 3}}, Root(Rational(0)), enclosed(point))};
}

// Bounds of the crossings' s hold these and nothing else.
void expect_crossings(const std::optional<EnclosedSweep::Crossings>& found, int sign,
                      const std::vector<Rational>& right) {
  ASSERT_TRUE(found);
  EXPECT_EQ(found->sign, sign);
  ASSERT_EQ(found->crossings.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i) {
    const auto bounds = enclosure(found->crossings[i].root, 50);
    ASSERT_TRUE(bounds);
    EXPECT_LE(bounds->lower, right[i]);
    EXPECT_GE(bounds->upper, right[i]);
  }
}

const std::vector<PlanePoint> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Rational kThird(1, 3);

TEST(EnclosedSweepTest, FromNoSurface) {
  const EnclosedSweep prism = sweep_of(Sweep::Translational, kSquare);
  expect_crossings(prism.crossings(enclosed({-kThird, kThird, 7}), {kThird, 0, 5}, {}), 1, {1, 4});
  expect_crossings(prism.crossings(enclosed({kThird, kThird, 7}), {kThird, 0, 5}, {}), -1, {2});
  expect_crossings(prism.crossings(enclosed({kThird, kThird, 7}), {0, 0, 1}, {}), -1, {});
}

TEST(EnclosedSweepTest, FromTheSurface) {
  const EnclosedSweep prism = sweep_of(Sweep::Translational, kSquare);
  const ExactPoint on{0, kThird, 7};
  const auto start = start_at(prism, on);
  ASSERT_EQ(start.curves.size(), 1u);
  expect_crossings(prism.crossings(enclosed(on), {kThird, 0, 5}, start), -1, {3});
  expect_crossings(prism.crossings(enclosed(on), {-kThird, 0, 5}, start), 1, {});
}

// The wall is far thinner than the first numbers that are tried for a point in it.
TEST(EnclosedSweepTest, ThroughAThinWall) {
  const Rational thin(1, std::int64_t{1} << 60);
  const EnclosedSweep wall =
      sweep_of(Sweep::Translational, {{3, 0}, {3 + thin, 0}, {3 + thin, 7}, {3, 7}});
  expect_crossings(wall.crossings(enclosed({0, kThird, 0}), {kThird, kThird, 1}, {}), 1,
                   {9, 9 + 3 * thin});
  const ExactPoint on{3, 1, 0};
  expect_crossings(wall.crossings(enclosed(on), {kThird, kThird, 1}, start_at(wall, on)), -1,
                   {3 * thin});
}

// Both curves through the start are known. Unknown, they could be crossed at any s near 0.
TEST(EnclosedSweepTest, FromAnEdge) {
  const EnclosedSweep prism = sweep_of(Sweep::Translational, kSquare);
  const ExactPoint on{0, 0, kThird};
  const auto start = start_at(prism, on);
  ASSERT_EQ(start.curves.size(), 2u);
  expect_crossings(prism.crossings(enclosed(on), {1, kThird, 0}, start), -1, {1});
  expect_crossings(prism.crossings(enclosed(on), {1, -kThird, 0}, start), 1, {});
  EXPECT_FALSE(prism.crossings(enclosed({kThird, kThird, 0}), {kThird, kThird, 1}, {}));
}

TEST(EnclosedSweepTest, AlongTheSurfaceItIsOutside) {
  const EnclosedSweep prism = sweep_of(Sweep::Translational, kSquare);
  const ExactPoint on{0, kThird, 7};
  expect_crossings(prism.crossings(enclosed(on), {0, kThird, 5}, start_at(prism, on)), 0, {});
  expect_crossings(prism.crossings(enclosed(on), {0, 0, 5}, start_at(prism, on)), 0, {});
  const EnclosedSweep tube = sweep_of(Sweep::Rotational, {{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  const ExactPoint top{Rational(3, 2), 0, 1};
  expect_crossings(tube.crossings(enclosed(top), {kThird, 1, 0}, start_at(tube, top)), 0, {});
}

TEST(EnclosedSweepTest, KnowsTheCurvesThroughAPoint) {
  const EnclosedSweep prism = sweep_of(Sweep::Translational, kSquare);
  const auto curves_at = [&](const ExactRay& ray, const ExactPoint& point) {
    return prism.curves_at(ray, Root(Rational(1)), enclosed(point)).size();
  };
  EXPECT_EQ(curves_at({{5, 5, 5}, {1, 1, 1}}, {6, 6, 6}), 0u);
  EXPECT_EQ(curves_at({{-1, 5, 5}, {1, 1, 1}}, {0, 6, 6}), 1u);  // beyond the side
  EXPECT_EQ(curves_at({{0, 5, 7}, {0, 1, 0}}, {0, 6, 7}), 1u);   // all of the ray is
  EXPECT_EQ(curves_at({{-1, -1, 5}, {1, 1, 1}}, {0, 0, 6}), 2u);
}

// The turned corner is a double cone |z| = 1 - u. A ray parallel to a line of it has a crossing
// less, which no interval of a third's square shows.
TEST(EnclosedSweepTest, ParallelToAConesLine) {
  const EnclosedSweep cones = sweep_of(Sweep::Rotational, {{0, -1}, {1, 0}, {0, 1}}, false);
  expect_crossings(cones.crossings(enclosed({0, 0, -kThird}), {kThird, 0, kThird}, {}), -1, {2});
}

// In a cone that it never leaves, or leaves far away, which few bits do not tell.
TEST(EnclosedSweepTest, NearlyParallelToAConesSide) {
  const EnclosedSweep cone = sweep_of(Sweep::Conic, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  const Rational far(number::Integer(1) << 200);
  const ExactPoint off{kThird + 1 / far, 0, kThird};
  expect_crossings(cone.crossings(enclosed({0, 0, 1}), {kThird, 0, kThird}, {}), -1, {});
  EXPECT_FALSE(cone.crossings(enclosed({0, 0, 1}), off, {}));
  constexpr int kMoreBits = 512;
  const Interval one(Rational(1), kMoreBits);
  expect_crossings(cone.crossings({one - one, one - one, one}, off, {}), -1, {far});
}

TEST(EnclosedSweepTest, AlongTheAxis) {
  const EnclosedSweep cones = sweep_of(Sweep::Rotational, {{0, -1}, {1, 0}, {0, 1}}, false);
  expect_crossings(cones.crossings(enclosed({0, 0, -kThird}), {0, 0, kThird}, {}), -1, {4});
  expect_crossings(cones.crossings(enclosed({0, 0, -2}), {0, 0, kThird}, {}), 1, {3, 9});
}

// Through z = 0, where the cone's places are at infinity: out of one nappe and into the other.
TEST(EnclosedSweepTest, BetweenTheNappes) {
  const EnclosedSweep cone = sweep_of(Sweep::Conic, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  expect_crossings(cone.crossings(enclosed({kThird, Rational(1, 5), 1}), {0, 0, -kThird}, {}), -1,
                   {2, 4});
  EXPECT_FALSE(cone.crossings(enclosed({kThird, kThird, 1}), {-kThird, -kThird, -1}, {}));
}

}  // namespace
}  // namespace lamina::surface
