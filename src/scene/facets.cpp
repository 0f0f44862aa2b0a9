#include "scene/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lamina::scene {

using geometry::CosSin;
using number::Rational;

namespace {

std::vector<CosSin> unit_circle(int vertices) {
  std::vector<CosSin> circle;
  for (int k = 0; k < vertices; ++k) {
    circle.push_back(geometry::cos_sin_degrees(Rational(360 * k) / vertices));
  }
  return circle;
}

// The facets between two rims, one for each edge of the circle. With m the outward normal of
// the edge and p = m.vertex its distance times |m|, the facet is m.(x, y) <= p * radius(z).
void add_facets(const std::string& name, const Rim& lower, const Rim& upper,
                const std::vector<CosSin>& circle, Solid& solid) {
  const Rational slope = (upper.radius - lower.radius) / (upper.z - lower.z);
  const Rational radius_at_0 = lower.radius - slope * lower.z;
  for (std::size_t k = 0; k < circle.size(); ++k) {
    const CosSin& a = circle[k];
    const CosSin& b = circle[(k + 1) % circle.size()];
    const Rational x = b.sin - a.sin;
    const Rational y = a.cos - b.cos;
    const Rational p = x * a.cos + y * a.sin;
    solid.parts.push_back(
        {fmt::format("{}[{}]", name, k + 1), surface::plane({x, y, -p * slope}, p * radius_at_0)});
  }
}

void add_bottom(const Rational& z, Solid& solid) {
  solid.parts.push_back({"bottom", surface::plane({0, 0, -1}, -z)});
}

void add_top(const Rational& z, Solid& solid) {
  solid.parts.push_back({"top", surface::plane({0, 0, 1}, z)});
}

}  // namespace

int vertices_of_circle(const Rational& radius, const FacetSettings& settings) {
  // OpenSCAD's GRID_FINE and F_MINIMUM.
  constexpr double kSmallestRadius = 0.00000095367431640625;
  constexpr double kSmallestSetting = 0.01;
  const double r = number::nearest_double(radius);
  const double fn = number::nearest_double(settings.fn);
  const double fa = std::max(number::nearest_double(settings.fa), kSmallestSetting);
  const double fs = std::max(number::nearest_double(settings.fs), kSmallestSetting);
  if (r < kSmallestRadius) {
    return 3;
  }
  const double count =
      fn > 0 ? std::max(fn, 3.0)
             : std::ceil(std::max(std::min(360.0 / fa, r * 2 * std::numbers::pi / fs), 5.0));
  return static_cast<int>(std::min(count, double{kMaxFacets}));
}

int rings_of_sphere(int vertices) { return (vertices + 1) / 2; }

Solid faceted_sphere(const Rational& radius, int vertices) {
  const std::vector<CosSin> circle = unit_circle(vertices);
  const int rings = rings_of_sphere(vertices);
  std::vector<Rim> rims;
  for (int i = 0; i < rings; ++i) {
    const CosSin polar = geometry::cos_sin_degrees(Rational(180 * i + 90) / rings);
    rims.push_back({radius * polar.sin, radius * polar.cos});
  }
  Solid solid;
  add_top(rims.front().z, solid);
  for (std::size_t i = 0; i + 1 < rims.size(); ++i) {
    add_facets(fmt::format("ring[{}]", i + 1), rims[i + 1], rims[i], circle, solid);
  }
  add_bottom(rims.back().z, solid);
  return solid;
}

Solid faceted_cylinder(const Rim& bottom, const Rim& top, int vertices) {
  Solid solid;
  add_facets("side", bottom, top, unit_circle(vertices), solid);
  if (bottom.radius != 0) {
    add_bottom(bottom.z, solid);
  }
  if (top.radius != 0) {
    add_top(top.z, solid);
  }
  return solid;
}

}  // namespace lamina::scene
