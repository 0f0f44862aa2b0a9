#include "experiments/surface_aim.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace lamina::experiments {
namespace {

using geometry::normalised;
using Point = geometry::Vector3<double>;

struct SurfacePoint {
  Point point;
  Point normal;  // outwards, unit
};

// A uniformly random point of a disc of radius 1.
std::array<double, 2> in_disc(base::SeededStream& stream) {
  const double radius = std::sqrt(stream.unit());
  const double angle = stream.uniform(0, 2 * M_PI);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

SurfacePoint on_box(base::SeededStream& stream) {
  std::array<double, 3> p{};
  std::array<double, 3> n{};
  for (double& coordinate : p) {
    coordinate = stream.uniform(-1, 1);
  }
  const std::size_t axis = stream.below(3);
  p[axis] = n[axis] = stream.chance(0.5) ? 1 : -1;
  return {{p[0], p[1], p[2]}, {n[0], n[1], n[2]}};
}

// Around the z axis from z = -1, of radius 1, to z = 1, of radius `top`.
SurfacePoint on_cylinder(double top, base::SeededStream& stream) {
  const std::size_t face = stream.below(top > 0 ? 3 : 2);
  if (face == 0) {
    const double angle = stream.uniform(0, 2 * M_PI);
    const double z = stream.uniform(-1, 1);
    const double radius = 1 + (top - 1) * (z + 1) / 2;
    return {{radius * std::cos(angle), radius * std::sin(angle), z},
            normalised({2 * std::cos(angle), 2 * std::sin(angle), 1 - top})};
  }
  const auto [x, y] = in_disc(stream);
  const double side = face == 1 ? -1 : 1;
  return {{x, y, side}, {0, 0, side}};
}

SurfacePoint on_solid(const std::string& solid, base::SeededStream& stream) {
  if (solid == "box") {
    return on_box(stream);
  }
  if (solid == "cylinder" || solid == "cone") {
    return on_cylinder(solid == "cylinder" ? 1 : 0, stream);
  }
  const Point normal = scene::random_direction(stream);
  if (solid == "ball") {
    return {normal, normal};
  }
  const double across = std::hypot(normal.x, normal.y);
  return {Point{normal.x / across, normal.y / across, 0} + 0.25 * normal, normal};
}

}  // namespace

Aim surface_aim(const std::string& solid, std::optional<double> angle, double distance,
                scene::Held held) {
  const auto draw = [=](const scene::FamilyMember& member, const scene::Scene&,
                        base::SeededStream& stream) {
    const SurfacePoint local = on_solid(solid, stream);
    const Point at = member.place(local.point);
    const Point outwards = member.place(local.point + local.normal) - at;
    const double size = std::sqrt(dot(outwards, outwards));
    const Point normal = (1 / size) * outwards;
    Point towards = scene::random_direction(stream);
    if (angle) {
      const Point along = normalised(cross(normal, towards));
      towards = std::sin(*angle) * normal + std::cos(*angle) * along;
    } else if (dot(towards, normal) < 0) {
      towards = -1.0 * towards;
    }
    return scene::ray_from(at + distance * size * towards, at, held);
  };
  return {fmt::format("surface/{}/{}/{}", solid, angle.value_or(0), distance), draw};
}

}  // namespace lamina::experiments
