#include "geometry/trajectory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::vector<ExactPoint>;

constexpr std::array kKinds{ContourKind::Line, ContourKind::BSpline, ContourKind::CatmullRom};

std::string message_of(Points points, ContourKind kind, bool closed) {
  try {
    const Trajectory trajectory(std::move(points), kind, closed);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

ExactPoint velocity_at(const TrajectoryPiece& piece, const Rational& u) {
  const auto slope = [&u](const std::vector<Rational>& c) {
    Rational sum = 0;
    Rational power = 1;
    for (std::size_t i = 1; i < c.size(); ++i) {
      sum += static_cast<long>(i) * c[i] * power;
      power *= u;
    }
    return sum;
  };
  return {slope(piece[0]), slope(piece[1]), slope(piece[2])};
}

const Points kPoints{{0, 0, 0}, {3, 1, 2}, {4, -1, 5}, {1, 1, 7}};

TEST(TrajectoryTest, PiecesGoOnWhereTheOneBeforeEnds) {
  for (const ContourKind kind : kKinds) {
    for (const bool closed : {false, true}) {
      const Trajectory trajectory(kPoints, kind, closed);
      const auto pieces = trajectory.pieces();
      ASSERT_EQ(pieces.size(), closed ? 4U : 3U);
      for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
        const auto& before = pieces[(i + pieces.size() - 1) % pieces.size()];
        EXPECT_EQ(point_at(before, 1), point_at(pieces[i], 0));
        if (kind != ContourKind::Line) {
          EXPECT_EQ(velocity_at(before, 1), velocity_at(pieces[i], 0));
        }
      }
    }
  }
}

TEST(TrajectoryTest, AnOpenOneBeginsAndEndsAtItsPoints) {
  for (const ContourKind kind : kKinds) {
    const Trajectory trajectory(kPoints, kind, false);
    EXPECT_EQ(point_at(trajectory.pieces().front(), 0), kPoints.front());
    EXPECT_EQ(point_at(trajectory.pieces().back(), 1), kPoints.back());
    // Towards the neighbour, as if the polygon went on straight.
    const ExactPoint along = velocity_at(trajectory.pieces().front(), 0);
    EXPECT_EQ(cross(along, kPoints[1] - kPoints[0]), (ExactPoint{0, 0, 0}));
  }
}

TEST(TrajectoryTest, ACatmullRomSplineGoesThroughItsPoints) {
  const Trajectory trajectory(kPoints, ContourKind::CatmullRom, false);
  for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
    EXPECT_EQ(point_at(trajectory.pieces()[i], 0), kPoints[i]);
  }
}

TEST(TrajectoryTest, TwoPointsAreAStraightPieceOfAnyKind) {
  for (const ContourKind kind : kKinds) {
    const Trajectory trajectory({{1, 2, 3}, {3, 2, 7}}, kind, false);
    ASSERT_EQ(trajectory.pieces().size(), 1U);
    const TrajectoryPiece straight{std::vector<Rational>{1, 2}, {2, 0}, {3, 4}};
    EXPECT_EQ(trajectory.pieces()[0], straight);
  }
}

TEST(TrajectoryTest, BoxesHoldTheirPieces) {
  for (const ContourKind kind : kKinds) {
    const Trajectory trajectory(kPoints, kind, true);
    for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
      const auto& [lower, upper] = trajectory.boxes()[i];
      for (int k = 0; k <= 16; ++k) {
        const ExactPoint p = point_at(trajectory.pieces()[i], Rational(k, 16));
        EXPECT_TRUE(lower.x <= p.x && p.x <= upper.x);
        EXPECT_TRUE(lower.y <= p.y && p.y <= upper.y);
        EXPECT_TRUE(lower.z <= p.z && p.z <= upper.z);
      }
    }
  }
}

TEST(TrajectoryTest, EqualOnesHaveEqualPointsInTheSameOrder) {
  const Trajectory one(kPoints, ContourKind::BSpline, true);
  EXPECT_TRUE((one <=> Trajectory(kPoints, ContourKind::BSpline, true)) == 0);
  EXPECT_TRUE((one <=> Trajectory(kPoints, ContourKind::BSpline, false)) != 0);
  EXPECT_TRUE((one <=> Trajectory(kPoints, ContourKind::Line, true)) != 0);
  EXPECT_TRUE(
      (one <=> Trajectory({kPoints.rbegin(), kPoints.rend()}, ContourKind::BSpline, true)) != 0);
}

TEST(TrajectoryTest, MessagesNameThePoint) {
  EXPECT_NE(message_of({{0, 0, 0}, {1, 0, 0}}, ContourKind::Line, true).find("needs 3 points"),
            std::string::npos);
  EXPECT_NE(message_of({{0, 0, 0}}, ContourKind::Line, false).find("needs 2 points"),
            std::string::npos);
  EXPECT_NE(message_of({{0, 0, 0}, {0, 0, 1}, {0, 0, 1}}, ContourKind::Line, false)
                .find("point 3 of the contour repeats point 2"),
            std::string::npos);
  EXPECT_NE(message_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0, 0}}, ContourKind::BSpline, true)
                .find("point 4 of the contour, its last one, repeats point 1"),
            std::string::npos);
  // It may cross itself, and go back the way it came.
  EXPECT_EQ(message_of({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}}, ContourKind::Line, false), "");
}

}  // namespace
}  // namespace lamina::geometry
