#include "scene/rays.hpp"

#include <cmath>

namespace lamina::scene {
namespace {

using Point = geometry::Vector3<double>;

Point rounded(const Point& p, Held held) {
  const auto round = [held](double x) {
    return held == Held::Float ? static_cast<double>(static_cast<float>(x)) : x;
  };
  return {round(p.x), round(p.y), round(p.z)};
}

geometry::ExactPoint exact(const Point& p) {
  using number::Rational;
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

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

Point random_direction(base::SeededStream& stream) {
  Point d{};
  double squared = 0;
  do {
    d = {stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    squared = dot(d, d);
  } while (squared > 1 || squared < 1e-4);  // uniform in a shell, so in direction
  return (1 / std::sqrt(squared)) * d;
}

geometry::ExactRay ray_from(const Point& origin, const Point& target, Held held) {
  const Point from = rounded(origin, held);
  const Point way = target - from;
  return {exact(from), exact(rounded((1 / std::sqrt(dot(way, way))) * way, held))};
}

geometry::ExactRay ray_through(const Point& target, double distance, base::SeededStream& stream) {
  const Point d = random_direction(stream);
  return {exact(rounded(target - distance * d, Held::Float)), exact(rounded(d, Held::Float))};
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
