// Trajectories: curves in space, in polynomial pieces; exact.
#pragma once

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "geometry/spline.hpp"
#include "geometry/vector.hpp"

namespace lamina::geometry {

/// c(u) for 0 <= u <= 1: the coefficients of 1, u, u^2, u^3 of x, y and z; as many of each, two to
/// four, of which the last are not all zero.
using TrajectoryPiece = std::array<std::vector<number::Rational>, 3>;

ExactPoint point_at(const TrajectoryPiece& piece, const number::Rational& u);

struct Box {
  ExactPoint lower;
  ExactPoint upper;
};

/// A curve that a body is moved along. It may cross and touch itself.
class Trajectory {
 public:
  /// A closed trajectory goes from the last point back to the first. An open one begins at the
  /// first point and ends at the last, of all kinds: splines are continued there by the reflection
  /// of the neighbour, 2 p_0 - p_1, as if the polygon went on straight.
  ///
  /// Throws base::InputError as require_distinct_points does.
  Trajectory(std::vector<ExactPoint> points, ContourKind kind, bool closed);

  [[nodiscard]] const std::vector<ExactPoint>& points() const { return points_; }
  [[nodiscard]] ContourKind kind() const { return kind_; }
  [[nodiscard]] bool closed() const { return closed_; }

  /// In order; each begins where the one before it ends.
  [[nodiscard]] std::span<const TrajectoryPiece> pieces() const { return pieces_; }
  /// That of each piece's Bezier control points: the piece lies in it.
  [[nodiscard]] std::span<const Box> boxes() const { return boxes_; }

  /// Equal if the points are, which must begin at the same one.
  friend std::strong_ordering operator<=>(const Trajectory& a, const Trajectory& b);

 private:
  std::vector<ExactPoint> points_;
  ContourKind kind_;
  bool closed_;
  std::vector<TrajectoryPiece> pieces_;
  std::vector<Box> boxes_;
};

}  // namespace lamina::geometry
