#include "geometry/trajectory.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lamina::geometry {

using number::Rational;

namespace {

// One point more at the front, and one or two at the back: piece i depends on entries i to i + 3.
std::vector<ExactPoint> continued(const std::vector<ExactPoint>& points, bool closed) {
  const std::size_t n = points.size();
  const auto reflected = [](const ExactPoint& end, const ExactPoint& neighbour) {
    return Rational(2) * end - neighbour;
  };
  std::vector<ExactPoint> result{closed ? points[n - 1] : reflected(points[0], points[1])};
  result.insert(result.end(), points.begin(), points.end());
  if (closed) {
    result.insert(result.end(), {points[0], points[1]});
  } else {
    result.push_back(reflected(points[n - 1], points[n - 2]));
  }
  return result;
}

// Without leading zeros that all coordinates have. A piece never is a point: its ends are two
// different ones of a polygon or a Catmull-Rom spline, and where a B-spline's first and second
// derivative are zero its points are equal.
TrajectoryPiece piece_of(ContourKind kind, std::span<const ExactPoint, 4> p) {
  TrajectoryPiece piece{spline_piece(kind, {p[0].x, p[1].x, p[2].x, p[3].x}),
                        spline_piece(kind, {p[0].y, p[1].y, p[2].y, p[3].y}),
                        spline_piece(kind, {p[0].z, p[1].z, p[2].z, p[3].z})};
  while (
      std::all_of(piece.begin(), piece.end(), [](const auto& c) { return c.back().is_zero(); })) {
    for (auto& c : piece) {
      c.pop_back();
    }
  }
  return piece;
}

Box box_of(const TrajectoryPiece& piece) {
  std::array<std::pair<Rational, Rational>, 3> range;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::vector<Rational> values = bezier(piece[i]);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    range[i] = {*least, *most};
  }
  return {{range[0].first, range[1].first, range[2].first},
          {range[0].second, range[1].second, range[2].second}};
}

}  // namespace

ExactPoint point_at(const TrajectoryPiece& piece, const Rational& u) {
  return {value_at(piece[0], u), value_at(piece[1], u), value_at(piece[2], u)};
}

Trajectory::Trajectory(std::vector<ExactPoint> points, ContourKind kind, bool closed)
    : points_(std::move(points)), kind_(kind), closed_(closed) {
  require_distinct_points(points_.size(), closed, [this](std::size_t i, std::size_t j) {
    return points_[i] == points_[j];
  });
  const std::vector<ExactPoint> all = continued(points_, closed);
  for (std::size_t i = 0; i + 3 < all.size(); ++i) {
    pieces_.push_back(piece_of(kind, std::span(all).subspan(i).first<4>()));
    boxes_.push_back(box_of(pieces_.back()));
  }
}

std::strong_ordering operator<=>(const Trajectory& a, const Trajectory& b) {
  const auto key = [](const Trajectory& x) {
    return std::tuple(x.kind(), x.closed(), x.points().size());
  };
  if (const auto order = key(a) <=> key(b); order != 0) {
    return order;
  }
  for (std::size_t i = 0; i < a.points().size(); ++i) {
    const ExactPoint& p = a.points()[i];
    const ExactPoint& q = b.points()[i];
    if (p != q) {
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) ? std::strong_ordering::less
                                                               : std::strong_ordering::greater;
    }
  }
  return std::strong_ordering::equal;
}

}  // namespace lamina::geometry
