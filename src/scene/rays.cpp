#include "scene/rays.hpp"

#include <cmath>

namespace lamina::scene {
namespace {

using Point = geometry::Vector3<double>;

}  // namespace

Point point_in(const Bounds& bounds, base::SeededStream& stream) {
  const auto between = [&stream](const number::Rational& low, const number::Rational& high) {
    return stream.uniform(number::nearest_double(low), number::nearest_double(high));
  };
  const auto& [low, high] = bounds;
  const double x = between(low.x, high.x);
  const double y = between(low.y, high.y);
  return {x, y, between(low.z, high.z)};
}

double distance_outside(const Bounds& bounds) {
  const geometry::ExactPoint diagonal = bounds.upper - bounds.lower;
  return 2 * std::sqrt(number::nearest_double(dot(diagonal, diagonal)));
}

geometry::ExactRay ray_through(const geometry::Vector3<double>& target, double distance,
                               base::SeededStream& stream) {
  Point d{};
  double squared = 0;
  do {
    d = {stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    squared = dot(d, d);
  } while (squared > 1 || squared < 1e-4);  // uniform in a shell, so in direction
  d = (1 / std::sqrt(squared)) * d;
  const Point o = target - distance * d;
  using number::Rational;
  const auto exact = [](const Point& v) -> geometry::ExactPoint {
    return {Rational(static_cast<float>(v.x)), Rational(static_cast<float>(v.y)),
            Rational(static_cast<float>(v.z))};
  };
  return {exact(o), exact(d)};
}

std::vector<geometry::ExactRay> uniform_rays(const Bounds& bounds, std::uint64_t count,
                                             base::SeededStream& stream) {
  const double distance = distance_outside(bounds);
  std::vector<geometry::ExactRay> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    rays.push_back(ray_through(point_in(bounds, stream), distance, stream));
  }
  return rays;
}

}  // namespace lamina::scene
