#include "surface/contour_curve.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace lamina::surface {
namespace {

using geometry::ContourPiece;
using number::Integer;
using number::Rational;

ContourCurve curve(int degree, std::vector<ContourCurve::Term> terms) {
  return {degree, std::move(terms)};
}

// u = 1 + 2 s, v = 3 - s: u + 2 v = 7.
TEST(ContourCurveTest, ASideLiesOnALine) {
  const ContourPiece side{{1, 2}, {3, -1}};
  const auto line = curve(1, {{{0, 0, 1}, 7}, {{0, 1, 0}, -2}, {{1, 0, 0}, -1}});
  EXPECT_EQ(curve_of(Sweep::Translational, side), line);
  EXPECT_EQ(curve_of(Sweep::Conic, side), line);
}

// (7 - 2 v)^2 = u^2, which its mirror image at the axis is a part of too; on the axis v = 7/2.
TEST(ContourCurveTest, ATurnedSideLiesOnACone) {
  const auto cone = curve(2, {{{0, 0, 2}, 49}, {{0, 1, 1}, -28}, {{0, 2, 0}, 4}, {{1, 0, 0}, -1}});
  const ContourPiece side{{1, 2}, {3, -1}};
  EXPECT_EQ(curve_of(Sweep::Rotational, side), cone);
  EXPECT_EQ(curve_of(Sweep::Rotational, {{1, -2}, {4, 1}}),
            curve_of(Sweep::Rotational, {{-1, 2}, {4, 1}}));
  EXPECT_EQ(curve_on_axis(side), curve(1, {{{0, 0, 1}, 7}, {{0, 1, 0}, -2}}));
}

// A plane at right angles to the axis, and not its square.
TEST(ContourCurveTest, ATurnedLevelSideLiesOnAPlane) {
  EXPECT_EQ(curve_of(Sweep::Rotational, {{1, 2}, {3, 0}}),
            curve(1, {{{0, 0, 1}, 3}, {{0, 1, 0}, -1}}));
}

// v = u^2, and turned v = u^2 again, its own mirror image.
TEST(ContourCurveTest, AParabola) {
  const ContourPiece piece{{0, 1, 0, 0}, {0, 0, 1, 0}};
  EXPECT_EQ(curve_of(Sweep::Translational, piece), curve(2, {{{0, 1, 1}, 1}, {{2, 0, 0}, -1}}));
  EXPECT_EQ(curve_of(Sweep::Rotational, piece), curve(2, {{{0, 1, 1}, 1}, {{1, 0, 0}, -1}}));
}

// v^2 = u^3
TEST(ContourCurveTest, ACubicOfItsParameter) {
  EXPECT_EQ(curve_of(Sweep::Translational, {{0, 0, 1, 0}, {0, 0, 0, 1}}),
            curve(3, {{{0, 2, 1}, 1}, {{3, 0, 0}, -1}}));
}

// From (0, 1) to (3, 7) at a speed that changes.
TEST(ContourCurveTest, AStraightPieceIsALineHoweverItRuns) {
  EXPECT_EQ(curve_of(Sweep::Translational, {{0, 1, 1, 1}, {1, 2, 2, 2}}),
            curve_of(Sweep::Translational, {{0, 3}, {1, 6}}));
}

// At t, the ray from (1, 2) in direction (1, -1) has u + 2 v - 7 = -2 - t.
TEST(ContourCurveTest, RestrictsToARay) {
  const SweptSurface prism(Sweep::Translational,
                           std::make_shared<const geometry::Contour>(
                               std::vector<geometry::PlanePoint>{{0, 0}, {1, 0}, {0, 1}},
                               geometry::ContourKind::Line, true));
  PlaneMonomials<Rational> ray(plane_ray(prism, {{1, 2, 5}, {1, -1, 3}}));
  const auto g = ray.restrict(curve_of(Sweep::Translational, {{1, 2}, {3, -1}}));
  EXPECT_EQ(g, (std::vector<Rational>{2, 1}));
}

}  // namespace
}  // namespace lamina::surface
