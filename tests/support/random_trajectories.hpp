// Random trajectories for tests, with coordinates on a grid of 1/64.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/trajectory.hpp"
#include "support/random_sweeps.hpp"

namespace lamina::support {

/// Points in a cube of side 4, each another. Of one in eight the first two are on a parallel to the
/// x axis; of another one in eight all points are, in any order; and of a third they are on a
/// parabola, as then are a spline's pieces between them.
inline std::shared_ptr<const geometry::Trajectory> any_trajectory(base::SeededStream& stream,
                                                                  geometry::ContourKind kind) {
  const bool closed = stream.chance(0.5);
  std::int64_t count = stream.integer(closed ? 3 : 2, 6);
  const std::uint64_t form = stream.below(8);
  count = form == 2 ? 4 : count;
  std::vector<geometry::ExactPoint> points;
  for (std::int64_t i = 0; i < count; ++i) {
    // No two have one x.
    points.push_back({any_dyadic(stream, -2, 2) + number::Rational(i, 1024),
                      any_dyadic(stream, -2, 2), any_dyadic(stream, -2, 2)});
  }
  for (std::size_t i = 1; i < points.size() && (form == 0 || (form == 1 && i == 1)); ++i) {
    points[i].y = points[0].y;
    points[i].z = points[0].z;
  }
  if (form == 2) {
    points[3] = points[0] + number::Rational(3) * (points[2] - points[1]);
  }
  return std::make_shared<const geometry::Trajectory>(std::move(points), kind, closed);
}

}  // namespace lamina::support
