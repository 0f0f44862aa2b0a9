#include "scene/primitives.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace lamina::scene {

using csg::Operator;
using geometry::ExactPoint;
using number::Rational;

namespace {

Solid single(surface::LocalSurface surface) { return {.parts = {{"", std::move(surface)}}}; }

Bounds box_around(const Rational& radius, const Rational& lower, const Rational& upper) {
  return {{-radius, -radius, lower}, {radius, radius, upper}};
}

void check_facets(const Arguments& arguments, std::int64_t count) {
  if (count > kMaxFacets) {
    arguments.fail(fmt::format("it has more than {} facets: lower $fn", kMaxFacets));
  }
}

// A radius, or half a diameter.
std::optional<Rational> radius(const Arguments& arguments, std::string_view radius,
                               std::string_view diameter) {
  const std::optional<Rational> d = arguments.size(diameter);
  if (d && arguments.has(radius)) {
    arguments.fail_at(diameter,
                      fmt::format("`{}` and `{}` cannot both be given", radius, diameter));
  }
  return d ? std::optional<Rational>(*d / 2) : arguments.size(radius);
}

Solid cube(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const ExactPoint size = arguments.vector_or_number("size").value_or(ExactPoint{1, 1, 1});
  if (size.x < 0 || size.y < 0 || size.z < 0) {
    arguments.fail_at("size", "`size` must not be negative");
  }
  if (size.x == 0 || size.y == 0 || size.z == 0) {
    return {};
  }
  const bool center = arguments.boolean("center").value_or(false);
  const ExactPoint lower = center ? Rational(-1) / 2 * size : ExactPoint{0, 0, 0};
  const ExactPoint upper = lower + size;
  return {Operator::Intersection,
          {{"-x", surface::plane({-1, 0, 0}, -lower.x)},
           {"+x", surface::plane({1, 0, 0}, upper.x)},
           {"-y", surface::plane({0, -1, 0}, -lower.y)},
           {"+y", surface::plane({0, 1, 0}, upper.y)},
           {"-z", surface::plane({0, 0, -1}, -lower.z)},
           {"+z", surface::plane({0, 0, 1}, upper.z)}},
          {},
          Bounds{lower, upper}};
}

Solid sphere(const Arguments& arguments, const FacetSettings* facets) {
  const Rational r = radius(arguments, "r", "d").value_or(1);
  if (r == 0) {
    return {};
  }
  Solid solid;
  if (facets != nullptr) {
    const int vertices = vertices_of_circle(r, *facets);
    check_facets(arguments, std::int64_t{vertices} * rings_of_sphere(vertices));
    solid = faceted_sphere(r, vertices);
  } else {
    solid = single(surface::sphere(r));
  }
  solid.box = box_around(r, -r, r);
  return solid;
}

// The infinite cylinder or cone through both rims, less what is below and above. The cone's
// other nappe is beyond its apex, and so below or above too.
Solid curved_cylinder(const Rim& bottom, const Rim& top) {
  const Rational slope = (top.radius - bottom.radius) / (top.z - bottom.z);
  return {Operator::Difference,
          {{"side", slope == 0 ? surface::infinite_cylinder(bottom.radius)
                               : surface::infinite_cone(slope, bottom.z - bottom.radius / slope)},
           {"bottom", surface::plane({0, 0, 1}, bottom.z)},
           {"top", surface::plane({0, 0, -1}, -top.z)}}};
}

Solid cylinder(const Arguments& arguments, const FacetSettings* facets) {
  const Rational h = arguments.size("h").value_or(1);
  const Rational both = radius(arguments, "r", "d").value_or(1);
  const Rational r1 = radius(arguments, "r1", "d1").value_or(both);
  const Rational r2 = radius(arguments, "r2", "d2").value_or(both);
  const Rational widest = std::max(r1, r2);
  if (h == 0 || widest == 0) {
    return {};
  }
  const bool center = arguments.boolean("center").value_or(false);
  const Rim bottom{r1, center ? Rational(-h / 2) : Rational(0)};
  const Rim top{r2, bottom.z + h};
  Solid solid;
  if (facets != nullptr) {
    const int vertices = vertices_of_circle(widest, *facets);
    check_facets(arguments, vertices + 2);
    solid = faceted_cylinder(bottom, top, vertices);
  } else {
    solid = curved_cylinder(bottom, top);
  }
  solid.box = box_around(widest, bottom.z, top.z);
  return solid;
}

Solid half_space(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const ExactPoint normal = *arguments.vector("normal");
  if (normal == ExactPoint{}) {
    arguments.fail_at("normal", "`normal` must not be zero");
  }
  return single(surface::plane(normal, *arguments.number("offset")));
}

Solid quadric(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const std::vector<std::vector<Rational>> rows = *arguments.matrix("matrix", 4);
  if (rows.size() != 4) {
    arguments.fail_at("matrix", "`matrix` must have four rows");
  }
  std::array<std::array<Rational, 4>, 4> matrix;
  for (std::size_t row = 0; row < 4; ++row) {
    std::copy(rows[row].begin(), rows[row].end(), matrix[row].begin());
  }
  const surface::LocalSurface surface = surface::quadric(matrix);
  const auto& f = surface.coefficients;
  if (std::all_of(f.begin(), f.end() - 1, [](const Rational& c) { return c == 0; })) {
    arguments.fail_at("matrix", "`matrix` must not give a constant");
  }
  return single(surface);
}

Solid infinite_cylinder(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const Rational r = *arguments.size("r");
  return r == 0 ? Solid{} : single(surface::infinite_cylinder(r));
}

Solid cone(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const Rational slope = *arguments.size("slope");
  return slope == 0 ? Solid{} : single(surface::infinite_cone(slope, 0));
}

Solid torus(const Arguments& arguments, const FacetSettings* /*facets*/) {
  const Rational major = *arguments.number("R");
  const Rational minor = *arguments.number("r");
  for (const std::string_view name : {"R", "r"}) {
    if (*arguments.number(name) <= 0) {
      arguments.fail_at(name, fmt::format("`{}` must be positive", name));
    }
  }
  Solid solid = single(surface::torus(major, minor));
  solid.box = box_around(major + minor, -minor, minor);
  return solid;
}

const std::array kPrimitives{
    Primitive{"cube", {"cube(size = [x, y, z], center = false)", {"size", "center"}}, cube},
    Primitive{"sphere", {"sphere(r = radius) or sphere(d = diameter)", {"r"}, 0, {"d"}}, sphere},
    Primitive{"cylinder",
              {"cylinder(h = height, r1 = bottom, r2 = top, center = false), or with r, d, d1, d2",
               {"h", "r1", "r2", "center"},
               0,
               {"r", "d", "d1", "d2"}},
              cylinder},
    Primitive{"halfspace",
              {"halfspace(normal = [x, y, z], offset = number)", {"normal", "offset"}, 2},
              half_space},
    Primitive{"quadric",
              {"quadric(matrix = [[a, b, c, d], ...]) with four rows", {"matrix"}, 1},
              quadric},
    Primitive{"infinite_cylinder", {"infinite_cylinder(r = radius)", {"r"}, 1}, infinite_cylinder},
    Primitive{"cone", {"cone(slope = number)", {"slope"}, 1}, cone},
    Primitive{"torus", {"torus(R = major radius, r = minor radius)", {"R", "r"}, 2}, torus},
};

}  // namespace

const Primitive* find_primitive(std::string_view name) {
  for (const Primitive& primitive : kPrimitives) {
    if (primitive.name == name) {
      return &primitive;
    }
  }
  return nullptr;
}

}  // namespace lamina::scene
