#include "geometry/revolved_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "base/contract.hpp"
#include "geometry/conic_spline.hpp"
#include "support/glass.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::vector<PlanePoint>;

// A conic x^2 = radius^2.
Conic wall(int radius, int y_low, int y_high, int side, std::size_t interval) {
  return {0, 0, radius * radius, y_low, y_high, side, interval};
}

std::vector<int> sides_from_outside_in(const RevolvedProfile& profile) {
  std::vector<int> result;
  for (const RevolvedProfile::Layer& layer : profile.layers()) {
    result.push_back(layer.side);
  }
  return result;
}

std::string message_of(const std::vector<ProfilePiece>& pieces) {
  try {
    const RevolvedProfile profile(pieces);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_message(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "says: " << message;
}

TEST(RevolvedProfileTest, OrdersNestedWallsFromOutsideIn) {
  // A disc with a groove from below: its inner wall comes first, its outer one last.
  const RevolvedProfile profile({wall(1, 1, 3, 1, 1), wall(2, 1, 3, -1, 2), wall(3, 0, 4, 1, 3)});
  ASSERT_EQ(sides_from_outside_in(profile), (std::vector<int>{1, -1, 1}));
  EXPECT_EQ(std::get<Conic>(profile.layers()[0].pieces[0]).gamma, 9);
  EXPECT_EQ(std::get<Conic>(profile.layers()[1].pieces[0]).gamma, 4);
  EXPECT_EQ(std::get<Conic>(profile.layers()[2].pieces[0]).gamma, 1);
}

TEST(RevolvedProfileTest, RefusesWallsOnTheWrongSide) {
  expect_message(message_of({wall(1, 0, 1, -1, 4)}), "between points 4 and 5");
  expect_message(message_of({wall(2, 0, 3, 1, 1), wall(1, -1, 3, -1, 2)}), "wrong side");
  EXPECT_EQ(message_of({wall(2, 0, 3, 1, 1), wall(1, 0, 3, -1, 2)}), "");
}

TEST(RevolvedProfileTest, RefusesCrossingsByTheirPoints) {
  // x = y crosses x = 1 at y = 1; x^2 = y^2 - 2y + 2 touches it there.
  const Conic cone{1, 0, 0, 0, 2, 1, 1};
  const Conic bowl{1, -2, 2, 0, 2, 1, 1};
  expect_message(message_of({cone, wall(1, 0, 2, -1, 2)}), "between points 1 and 2");
  expect_message(message_of({cone, wall(1, 0, 2, -1, 2)}), "between points 2 and 3");
  expect_message(message_of({bowl, wall(1, 0, 2, -1, 2)}), "crosses or touches");
  expect_message(message_of({wall(1, 0, 2, 1, 1), wall(1, 0, 2, -1, 2)}), "crosses or touches");
  // x^2 = 2 - (y - 1)^2 crosses x = 1 twice, at y = 0 and y = 2; between them it is outside.
  const Conic ball{-1, 2, 1, -1, 2, 1, 1};
  expect_message(message_of({ball, wall(1, -1, 2, -1, 2)}), "crosses or touches");
  const Conic upper{-1, 2, 1, 0, 2, 1, 1};
  EXPECT_EQ(message_of({upper, wall(1, 0, 2, -1, 2)}), "");
  // A wall that is outside at first and inside later.
  expect_message(message_of({wall(2, 0, 1, 1, 1), wall(4, 1, 2, 1, 2), wall(3, 0, 2, -1, 3)}),
                 "between point 2 and point 4");
}

TEST(InscribedConesTest, AreTheLinesThemselves) {
  // A cone on a cylinder: each line of the contour in two steps.
  const Contour contour(Points{{0, 0}, {2, 0}, {2, 1}, {0, 5}}, ContourKind::Line, false);
  const RevolvedProfile profile = inscribed_cones(contour, 6);
  ASSERT_EQ(profile.pieces().size(), 4U);  // two steps are level
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(std::get<Conic>(profile.pieces()[0]), (Conic{0, 0, 4, 0, half, 1, 3}));
  EXPECT_EQ(std::get<Conic>(profile.pieces()[1]), (Conic{0, 0, 4, half, 1, 1, 4}));
  // x = (5 - y) / 2.
  const Rational quarter = Rational(1) / 4;
  EXPECT_EQ(std::get<Conic>(profile.pieces()[2]),
            (Conic{quarter, -10 * quarter, 25 * quarter, 1, 3, 1, 5}));
  EXPECT_EQ(std::get<Conic>(profile.pieces()[3]),
            (Conic{quarter, -10 * quarter, 25 * quarter, 3, 5, 1, 6}));
}

TEST(InscribedConesTest, GoRoundClosedContoursOfEitherDirection) {
  Points ring{{3, 0}, {5, 0}, {5, 2}, {3, 2}};
  for (int direction = 0; direction < 2; ++direction) {
    const Contour contour(ring, ContourKind::Line, true);
    const RevolvedProfile profile = inscribed_cones(contour, 4);
    ASSERT_EQ(sides_from_outside_in(profile), (std::vector<int>{1, -1}));
    EXPECT_EQ(std::get<Conic>(profile.layers()[0].pieces[0]).gamma, 25);
    EXPECT_EQ(std::get<Conic>(profile.layers()[1].pieces[0]).gamma, 9);
    std::reverse(ring.begin(), ring.end());
  }
}

TEST(InscribedConesTest, RefuseContoursThatLeaveNothing) {
  const Contour contour(Points{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, ContourKind::Line, false);
  EXPECT_THROW(inscribed_cones(contour, 0), base::InputError);
  EXPECT_THROW(inscribed_cones(contour, 1), base::InputError);
}

TEST(RevolvedProfileTest, TakesTheInsideOfTheGlassAwayLast) {
  const RevolvedProfile glass = fit_conic_spline(glass_points(), glass_arcs());
  ASSERT_EQ(sides_from_outside_in(glass), (std::vector<int>{1, 1, -1}));
  EXPECT_EQ(glass.layers()[0].pieces.size(), 18U);
  EXPECT_EQ(glass.layers()[1].pieces.size(), 1U);
  EXPECT_EQ(glass.layers()[2].pieces.size(), 7U);
}

}  // namespace
}  // namespace lamina::geometry
