// Scenes of swept polygons, and the same solids of half-spaces, for tests; rays at them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "support/random_sweeps.hpp"

namespace lamina::support {

inline std::string contour_text(const std::vector<geometry::PlanePoint>& points) {
  std::vector<std::string> pairs;
  for (const geometry::PlanePoint& p : points) {
    pairs.push_back(fmt::format("[{}, {}]", number::to_text(p.u), number::to_text(p.v)));
  }
  return fmt::format("[{}]", fmt::join(pairs, ", "));
}

inline std::string sweep_text(surface::Sweep sweep, const std::vector<geometry::PlanePoint>& points,
                              geometry::ContourKind kind, bool closed) {
  return fmt::format("{}() contour({}, kind=\"{}\", closed={});\n", name_of(sweep),
                     contour_text(points), name_of(kind), closed);
}

inline std::string sweep_text(const surface::SweptSurface& sweep) {
  const geometry::Contour& contour = sweep.contour();
  if (sweep.sweep() != surface::Sweep::GeneralisedConic) {
    return sweep_text(sweep.sweep(), contour.points(), contour.kind(), contour.closed());
  }
  const auto list = [](const std::vector<number::Rational>& polynomial) {
    std::vector<std::string> coefficients;
    for (const number::Rational& c : polynomial) {
      coefficients.push_back(number::to_text(c));
    }
    return fmt::format("[{}]", fmt::join(coefficients, ", "));
  };
  return fmt::format("{}({}, {}) contour({}, kind=\"{}\");\n", name_of(sweep.sweep()),
                     list(sweep.scaling().x), list(sweep.scaling().y),
                     contour_text(contour.points()), name_of(contour.kind()));
}

// n.p <= offset.
inline std::string plane_text(const geometry::ExactPoint& n, const number::Rational& offset) {
  return fmt::format("halfspace([{}, {}, {}], {});\n", number::to_text(n.x), number::to_text(n.y),
                     number::to_text(n.z), number::to_text(offset));
}

// The triangles from a centre to the sides of a polygon that goes around it counterclockwise, each
// swept: three planes, and what caps the sweep.
inline std::string in_triangles(surface::Sweep sweep, const geometry::PlanePoint& centre,
                                const std::vector<geometry::PlanePoint>& points) {
  std::string text = "add() {\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const geometry::PlanePoint& a = points[i];
    const geometry::PlanePoint& b = points[(i + 1) % points.size()];
    text += "intersection() {\n" + plane_text({0, 0, -1}, 0) + plane_text({0, 0, 1}, 1);
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, centre), std::pair(centre, a)}) {
      const geometry::ExactPoint outward{q.v - p.v, p.u - q.u, 0};
      const number::Rational offset = outward.x * p.u + outward.y * p.v;
      text += sweep == surface::Sweep::Translational
                  ? plane_text(outward, offset)
                  : plane_text({outward.x, outward.y, -offset}, 0);
    }
    text += "}\n";
  }
  return text + "}\n";
}

// The truncated cones of a profile's sides.
inline std::string in_cones(const std::vector<geometry::PlanePoint>& profile) {
  std::string text = "add() {\n";
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const geometry::PlanePoint& a = profile[i];
    const geometry::PlanePoint& b = profile[i + 1];
    text +=
        fmt::format("translate([0, 0, {}]) cylinder(h={}, r1={}, r2={});\n", number::to_text(a.v),
                    number::to_text(b.v - a.v), number::to_text(a.u), number::to_text(b.u));
  }
  return text + "}\n";
}

inline number::Rational any_coordinate(base::SeededStream& stream) {
  return any_dyadic(stream, -2, 2);
}

// Through a point of the contour, where the sweep has it, or not; some along an axis, some level.
inline geometry::ExactRay any_ray(base::SeededStream& stream, surface::Sweep sweep,
                                  const std::vector<geometry::PlanePoint>& points,
                                  const surface::Scaling& scaling = {{1}, {1}}) {
  geometry::ExactPoint target{any_coordinate(stream), any_coordinate(stream),
                              any_coordinate(stream)};
  if (stream.chance(0.5)) {
    const auto i = static_cast<std::size_t>(stream.below(points.size()));
    const geometry::PlanePoint& p = points[i];
    const geometry::PlanePoint& q = points[(i + 1) % points.size()];
    const number::Rational s(stream.integer(0, 2), 2);  // a vertex, or the middle of a side
    const geometry::PlanePoint at{p.u + s * (q.u - p.u), p.v + s * (q.v - p.v)};
    const number::Rational z(stream.integer(-1, 5), 4);
    switch (sweep) {
      case surface::Sweep::Translational:
        target = {at.u, at.v, z};
        break;
      case surface::Sweep::Conic:
        target = {at.u * z, at.v * z, z};
        break;
      case surface::Sweep::Rotational:
        target = {at.u, 0, at.v};
        break;
      case surface::Sweep::GeneralisedConic:
        target = {at.u * geometry::value_at(scaling.x, z), at.v * geometry::value_at(scaling.y, z),
                  z};
        break;
    }
  }
  geometry::ExactPoint direction{any_coordinate(stream), any_coordinate(stream),
                                 any_coordinate(stream)};
  if (stream.chance(0.1)) {
    direction.z = 0;
  } else if (stream.chance(0.1)) {
    direction = {0, 0, 1};
  }
  if (direction == geometry::ExactPoint{}) {
    direction.x = 1;
  }
  return {target - number::Rational(stream.integer(1, 4)) * direction, direction};
}

}  // namespace lamina::support
