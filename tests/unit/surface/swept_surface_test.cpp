// Rays in special position at swept contours, by hand: exactly, and in double where the ray's
// numbers and all that follows from them are exact there.
#include "surface/swept_surface.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/contract.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina::surface {
namespace {

using geometry::Contour;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using Points = std::vector<PlanePoint>;
using Times = std::vector<Rational>;

SweptSurface polygon(Sweep sweep, Points points, bool closed = true) {
  return {sweep, std::make_shared<const Contour>(std::move(points), ContourKind::Line, closed)};
}

// The t of the crossings, which are rational in these tests.
Times exact_times(const SweptSurface& surface, const ExactRay& ray) {
  const SweptSurface::Crossings found = surface.crossings(ray);
  EXPECT_FALSE(found.in_boundary);
  Times times;
  for (const SweptSurface::Crossing& crossing : found.crossings) {
    const Rational t(number::nearest_double(crossing.t));
    EXPECT_TRUE(compare(crossing.t, t) == 0);
    times.push_back(t);
  }
  return times;
}

Times times_in_double(const SweptSurface& surface, const ExactRay& ray) {
  std::vector<RoundedSweep<double>::Crossing> found;
  RoundedSweep<double>(surface).find_crossings(
      {nearest_double(ray.origin), nearest_double(ray.direction)}, {}, found);
  Times times;
  for (const auto& crossing : found) {
    times.emplace_back(crossing.t);
  }
  return times;
}

void expect_times(const SweptSurface& surface, const ExactRay& ray, const Times& times) {
  EXPECT_EQ(exact_times(surface, ray), times);
  EXPECT_EQ(times_in_double(surface, ray), times);
}

const Points kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(SweptSurfaceTest, RayInASideCrossesNothing) {
  const SweptSurface prism = polygon(Sweep::Translational, kSquare);
  const ExactRay in_side{{-5, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(prism.crossings(in_side).in_boundary);
  EXPECT_TRUE(times_in_double(prism, in_side).empty());
}

TEST(SweptSurfaceTest, RayAlongAPrismIsInsideOrOutsideAllAlong) {
  const SweptSurface prism = polygon(Sweep::Translational, kSquare);
  const ExactRay inside{{Rational(1, 2), Rational(1, 2), -5}, {0, 0, 1}};
  EXPECT_TRUE(prism.crossings(inside).starts_inside);
  expect_times(prism, inside, {});
  EXPECT_FALSE(prism.crossings({{2, 2, -5}, {0, 0, 1}}).starts_inside);
}

TEST(SweptSurfaceTest, RayThatTouchesACornerCrossesNothing) {
  const SweptSurface diamond = polygon(Sweep::Translational, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  EXPECT_TRUE(exact_times(diamond, {{-5, 1, 0}, {1, 0, 0}}).empty());
}

TEST(SweptSurfaceTest, RayThroughTwoCornersCrossesAtBoth) {
  const SweptSurface diamond = polygon(Sweep::Translational, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  expect_times(diamond, {{-5, 0, 0}, {1, 0, 0}}, {4, 6});
}

TEST(SweptSurfaceTest, CrossingFartherAwayThanDoublesReach) {
  const Rational far(number::Integer(pow(number::Integer(10), 160)));
  const SweptSurface prism = polygon(Sweep::Translational, kSquare);
  const auto found = prism.crossings({{-far, Rational(1, 2), 0}, {1 / far, 0, 0}});
  ASSERT_EQ(found.crossings.size(), 2U);
  EXPECT_TRUE(compare(found.crossings[0].t, far * far) == 0);
}

// Pieces 0 and 3 lie on one line, which the ray crosses on piece 3.
TEST(SweptSurfaceTest, PieceIsTheOneThatTheRayMeets) {
  const SweptSurface prism =
      polygon(Sweep::Translational, {{0, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 3}, {0, 4}});
  const Rational t = Rational(number::Integer(1) << 60) + 1;
  const auto found =
      prism.crossings({{Rational(5, 2) - 3 * t, Rational(5, 2) - 4 * t, 0}, {3, 4, 0}});
  ASSERT_EQ(found.crossings.size(), 4U);
  EXPECT_TRUE(compare(found.crossings[2].t, t) == 0);
  EXPECT_EQ(found.crossings[2].piece, 3U);
}

TEST(SweptSurfaceTest, ConeOfBothNappes) {
  const SweptSurface pyramid = polygon(Sweep::Conic, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  expect_times(pyramid, {{-8, 0, 2}, {1, 0, 0}}, {6, 10});
  expect_times(pyramid, {{-8, 0, -2}, {1, 0, 0}}, {6, 10});
  // Inside before the apex and behind it.
  const auto through_apex = pyramid.crossings({{0, 0, -5}, {0, 0, 1}});
  EXPECT_TRUE(through_apex.starts_inside);
  EXPECT_TRUE(through_apex.crossings.empty());
  EXPECT_EQ(pyramid.side({0, 0, 0}), 0);
  EXPECT_EQ(pyramid.side({1, 0, 0}), 1);
}

class SweptCylinderTest : public testing::TestWithParam<bool> {
 protected:
  // The same solid by a contour that goes along the axis, or is open there.
  SweptSurface cylinder = polygon(Sweep::Rotational, kSquare, GetParam());
};

INSTANTIATE_TEST_SUITE_P(ClosedAndOpen, SweptCylinderTest, testing::Bool());

TEST_P(SweptCylinderTest, AxisIsInside) {
  EXPECT_EQ(cylinder.side({0, 0, Rational(1, 2)}), -1);
  EXPECT_EQ(cylinder.side({0, 0, 0}), 0);
  EXPECT_EQ(cylinder.side({0, 0, 2}), 1);
}

TEST_P(SweptCylinderTest, RayAlongTheAxis) {
  expect_times(cylinder, {{0, 0, -5}, {0, 0, 1}}, {5, 6});
}

TEST_P(SweptCylinderTest, RayParallelToTheAxis) {
  expect_times(cylinder, {{Rational(1, 2), 0, -5}, {0, 0, 1}}, {5, 6});
}

TEST_P(SweptCylinderTest, LevelRay) {
  expect_times(cylinder, {{-5, 0, Rational(1, 2)}, {1, 0, 0}}, {4, 6});
  expect_times(cylinder, {{-5, 1, Rational(1, 2)}, {1, 0, 0}}, {});  // tangent
}

TEST_P(SweptCylinderTest, LevelRayInACap) {
  const ExactRay in_cap{{-5, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(cylinder.crossings(in_cap).in_boundary);
  EXPECT_TRUE(times_in_double(cylinder, in_cap).empty());
  expect_times(cylinder, {{-5, 2, 0}, {1, 0, 0}}, {});  // beyond its rim
}

TEST_P(SweptCylinderTest, RayThroughTheAxisInBothCaps) {
  expect_times(cylinder, {{-1, 0, -4}, {Rational(1, 4), 0, 1}}, {4, 5});
}

TEST(SweptSurfaceTest, RayThroughAPole) {
  const SweptSurface double_cone = polygon(Sweep::Rotational, {{0, -1}, {1, 0}, {0, 1}}, false);
  // At z = -1 on the axis, and on the upper cone: x = t - 1, z = 3 t - 4, x + z = 1 at t = 3/2.
  expect_times(double_cone, {{-1, 0, -4}, {1, 0, 3}}, {1, Rational(3, 2)});
  // At z = 1 on the axis: the same, upside down.
  expect_times(double_cone, {{-1, 0, 4}, {1, 0, -3}}, {1, Rational(3, 2)});
}

SweptSurface scaled(Scaling scaling, Points points) {
  return {std::move(scaling),
          std::make_shared<const Contour>(std::move(points), ContourKind::Line, true)};
}

const Points kCentredSquare{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

TEST(GeneralisedConicTest, IsAPlainerSweepWhereItsPolynomialsSay) {
  const auto same = [](const SweptSurface& a, const SweptSurface& b) { return a <=> b == 0; };
  EXPECT_TRUE(same(scaled({{1}, {1, 0}}, kSquare), polygon(Sweep::Translational, kSquare)));
  EXPECT_TRUE(same(scaled({{0, 1}, {0, 1}}, kSquare), polygon(Sweep::Conic, kSquare)));
  EXPECT_TRUE(same(scaled({{2, 1}, {1}}, kSquare), scaled({{2, 1, 0}, {1, 0}}, kSquare)));
  EXPECT_FALSE(same(scaled({{2, 1}, {1}}, kSquare), scaled({{1}, {2, 1}}, kSquare)));
}

TEST(GeneralisedConicTest, HasWallsThatBend) {
  // |x| <= 1 + z^2 / 4, |y| <= 2.
  const SweptSurface waist = scaled({{1, 0, Rational(1, 4)}, {2}}, kCentredSquare);
  EXPECT_EQ(waist.sweep(), Sweep::GeneralisedConic);
  // On 4 x = 5 z, x meets a wall where x = 1 + 4 x^2 / 25 or -x is that: at 5/4 and 5, both signs.
  const ExactRay across{{0, 0, 0}, {5, 0, 4}};
  expect_times(waist, across, {-1, Rational(-1, 4), Rational(1, 4), 1});
  EXPECT_TRUE(waist.crossings(across).starts_inside);
  // Level at z = 2, and along the axis in a wall's height, which it leaves at |z| < 2.
  expect_times(waist, {{-8, 1, 2}, {1, 0, 0}}, {6, 10});
  expect_times(waist, {{2, 0, -5}, {0, 0, 1}}, {3, 7});
  EXPECT_EQ(waist.side({Rational(3, 2), 0, 0}), 1);
  EXPECT_EQ(waist.side({Rational(3, 2), 0, 2}), -1);
  EXPECT_EQ(waist.side({2, 0, 2}), 0);
  // x - 1 - z^2 / 4 = 0 has the gradient (1, 0, -1) there.
  const ExactPoint normal = waist.normal_near({2, 0, 2});
  EXPECT_GT(normal.x, 0);
  EXPECT_EQ(normal.y, 0);
  EXPECT_EQ(normal.z, -normal.x);
}

TEST(GeneralisedConicTest, IsDrawnTogetherWhereAPolynomialIsZero) {
  // |x| <= |z|, |y| <= 1: two prisms that meet in a segment of the y axis.
  const SweptSurface wedges = scaled({{0, 1}, {1}}, kCentredSquare);
  EXPECT_EQ(wedges.side({0, Rational(1, 2), 0}), 0);
  EXPECT_EQ(wedges.side({0, 1, 0}), 0);
  EXPECT_EQ(wedges.side({0, 2, 0}), 1);
  EXPECT_EQ(wedges.side({1, 0, 0}), 1);
  EXPECT_EQ(wedges.normal_near({0, 0, 0}), ExactPoint{});
  // Through the segment from one prism to the other, which is no crossing.
  expect_times(wedges, {{0, 0, -3}, {0, 0, 1}}, {});
  EXPECT_TRUE(wedges.crossings({{0, 0, -3}, {0, 0, 1}}).starts_inside);
  expect_times(wedges, {{1, 0, -3}, {0, 0, 1}}, {2, 4});
  // Both are zero at z = 0: only the apex is there.
  const SweptSurface pinched = scaled({{0, 1}, {0, 0, 1}}, kCentredSquare);
  EXPECT_EQ(pinched.side({0, 0, 0}), 0);
  EXPECT_EQ(pinched.side({0, Rational(1, 9), 0}), 1);
}

TEST(GeneralisedConicTest, RefusesPolynomialsThatAreZeroOrOfHighDegree) {
  EXPECT_THROW(scaled({{0, 0}, {1}}, kSquare), base::InputError);
  EXPECT_THROW(scaled({{1}, {}}, kSquare), base::InputError);
  EXPECT_THROW(scaled({{1, 0, 0, 1}, {1, 0, 0, 2}}, kSquare), base::InputError);
  EXPECT_NO_THROW(scaled({{1, 0, 0, 1}, {1, 0, 0, 1}}, kSquare));
  EXPECT_NO_THROW(scaled({{1, 0, 0, 1}, {1, 0, 2}}, kSquare));
}

TEST(SweptSurfaceTest, RefusesContoursThatBoundNothing) {
  const Points on_axis{{0, 0}, {0, 1}};
  EXPECT_THROW(polygon(Sweep::Rotational, on_axis, false), base::InputError);
  EXPECT_THROW(polygon(Sweep::Rotational, {{0, 0}, {-1, 1}, {0, 2}}, false), base::InputError);
  EXPECT_THROW(polygon(Sweep::Conic, {{0, 0}, {1, 1}, {0, 2}}, false), base::InputError);
}

}  // namespace
}  // namespace lamina::surface
