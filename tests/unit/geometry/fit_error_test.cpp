#include "geometry/fit_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/conic_spline.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::vector<PlanePoint>;

// Of sampled tangents and a few dozen operations, far above the roundings of double.
constexpr double kRounding = 1e-12;

TEST(FitErrorTest, IsZeroForLinesThemselves) {
  const Contour contour(Points{{0, 0}, {2, 0}, {3, 1}, {1, 5}, {0, 5}}, ContourKind::Line, false);
  const FitError error = fit_error(inscribed_cones(contour, 8), contour);
  EXPECT_LT(error.distance, kRounding);
  EXPECT_LT(error.angle_rad, kRounding);
}

TEST(FitErrorTest, IsThatOfAChord) {
  // The corner (4, 1) is cut off by the line from (3, 0) to (3, 2).
  const Contour contour(Points{{0, 0}, {3, 0}, {4, 1}, {3, 2}, {0, 2}}, ContourKind::Line, false);
  const RevolvedProfile flat(std::vector<ProfilePiece>{Conic{0, 0, 9, 0, 2, 1, 1}});
  const FitError error = fit_error(flat, contour);
  EXPECT_NEAR(error.distance, 1, kRounding);
  EXPECT_NEAR(error.angle_rad, std::numbers::pi / 4, kRounding);
}

TEST(FitErrorTest, SeesASphereAgainstItsOctagon) {
  // x^2 + y^2 = 25 against the polygon of its points: sagitta of the longest chord, and half its
  // angle at the centre.
  const Points points{{0, -5}, {3, -4}, {4, -3}, {4, 3}, {3, 4}, {0, 5}};
  std::vector<SlopeAt> slopes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    slopes.push_back({i + 1, -2 * points[i].v});
  }
  const RevolvedProfile sphere = fit_conic_spline(points, {}, slopes);
  const Contour polygon(points, ContourKind::Line, false);
  const FitError error = fit_error(sphere, polygon, 256);
  const double half_angle = std::asin(3.0 / 5);  // of the chord from (4, -3) to (4, 3)
  EXPECT_NEAR(error.distance, 5 * (1 - std::cos(half_angle)), 1e-3);
  EXPECT_NEAR(error.angle_rad, half_angle, 1e-2);
}

TEST(FitErrorTest, SeesEveryKindOfArc) {
  // Cylinders of height 2 and radii 3 and 5 that half circles of radius 1 join: the ring whose
  // section is a stadium, against the stadium's box.
  const Conic outer{0, 0, 25, 0, 2, 1, 1};
  const Arc above{4, 1, 2, 2, 3, ArcPart::Above, 1, 1};
  const Conic inner{0, 0, 9, 0, 2, -1, 2};
  const Arc below{4, 1, 0, -1, 0, ArcPart::Below, 1, 2};
  const RevolvedProfile stadium({outer, above, inner, below});
  const Contour box(Points{{5, -1}, {5, 3}, {3, 3}, {3, -1}}, ContourKind::Line, true);
  const FitError error = fit_error(stadium, box, 64);
  EXPECT_NEAR(error.distance, std::sqrt(2) - 1, kRounding);  // at the corners
  EXPECT_NEAR(error.angle_rad, std::numbers::pi / 4, 1e-2);
}

TEST(FitErrorTest, ShrinksWithTheSquareOfTheConesSize) {
  const Contour contour(Points{{0, 0}, {2, 1}, {2, 3}, {1, 5}, {0, 6}}, ContourKind::BSpline,
                        false);
  const FitError coarse = fit_error(inscribed_cones(contour, 32), contour, 128);
  const FitError fine = fit_error(inscribed_cones(contour, 128), contour, 128);
  EXPECT_NEAR(coarse.distance / fine.distance, 16, 4);
  EXPECT_NEAR(coarse.angle_rad / fine.angle_rad, 4, 1);
}

Rational derivative_at(const std::vector<Rational>& c, const Rational& s) {
  return c[1] + 2 * c[2] * s + 3 * c[3] * s * s;
}

TEST(FitErrorTest, FindsConicsWithTheCurvesSlopesSmootherThanAsManyCones) {
  // Monotone in v, and crosses the axis at right angles.
  const Contour contour(Points{{0, 0}, {2, 1}, {2, 3}, {1, 5}, {0, 6}}, ContourKind::BSpline,
                        false);
  for (const int steps : {2, 4, 8}) {
    Points points;
    std::vector<SlopeAt> slopes;
    for (int i = 0; i < 4 * steps; ++i) {
      const ContourPiece& piece = contour.pieces()[static_cast<std::size_t>(i / steps)];
      const Rational s(i % steps, steps);
      points.push_back({value_at(piece.u, s), value_at(piece.v, s)});
      if (i > 0) {
        slopes.push_back({points.size(), 2 * points.back().u * derivative_at(piece.u, s) /
                                             derivative_at(piece.v, s)});
      }
    }
    points.push_back({0, value_at(contour.pieces()[3].v, 1)});
    const RevolvedProfile spline = fit_conic_spline(points, {}, slopes);
    const FitError conics = fit_error(spline, contour);
    const FitError cones = fit_error(inscribed_cones(contour, spline.pieces().size()), contour);
    EXPECT_LT(conics.distance, cones.distance / 2);
    EXPECT_LT(conics.angle_rad, cones.angle_rad / 4);
  }
}

}  // namespace
}  // namespace lamina::geometry
