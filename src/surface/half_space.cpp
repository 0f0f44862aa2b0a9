#include "surface/half_space.hpp"

#include <utility>

namespace lamina::surface {

using number::Rational;

bool operator==(const LocalSurface& a, const LocalSurface& b) {
  const auto equal = [](const auto& x, const auto& y) { return x == y || (x && y && *x == *y); };
  return a.kind == b.kind && a.coefficients == b.coefficients && equal(a.sweep, b.sweep) &&
         equal(a.sphere_sweep, b.sphere_sweep);
}

LocalSurface plane(const geometry::ExactPoint& normal, const Rational& offset) {
  return {Kind::Plane, {normal.x, normal.y, normal.z, -offset}};
}

LocalSurface sphere(const Rational& radius) {
  return {Kind::Quadric, {1, 1, 1, 0, 0, 0, 0, 0, 0, -radius * radius}};
}

LocalSurface infinite_cylinder(const Rational& radius) {
  return {Kind::Quadric, {1, 1, 0, 0, 0, 0, 0, 0, 0, -radius * radius}};
}

LocalSurface infinite_cone(const Rational& slope, const Rational& apex) {
  const Rational s = slope * slope;
  return {Kind::Quadric, {1, 1, -s, 0, 0, 0, 0, 0, 2 * s * apex, -s * apex * apex}};
}

LocalSurface quadric(const std::array<std::array<Rational, 4>, 4>& m) {
  return {Kind::Quadric,
          {m[0][0], m[1][1], m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1],
           m[0][3] + m[3][0], m[1][3] + m[3][1], m[2][3] + m[3][2], m[3][3]}};
}

LocalSurface torus(const Rational& major, const Rational& minor) {
  return {Kind::Torus, {major, minor}};
}

LocalSurface swept(SweptSurface sweep) {
  return {Kind::Sweep, {}, std::make_shared<const SweptSurface>(std::move(sweep))};
}

LocalSurface swept(SphereSweep sweep) {
  return {Kind::Sweep, {}, nullptr, std::make_shared<const SphereSweep>(std::move(sweep))};
}

}  // namespace lamina::surface
