#include "scene/transforms.hpp"

#include <algorithm>

namespace lamina::scene {

using geometry::AffineMap;
using geometry::ExactPoint;
using number::Rational;

namespace {

AffineMap translate(const Arguments& arguments) {
  return geometry::translation(*arguments.vector("v", 0));
}

AffineMap scale(const Arguments& arguments) {
  const ExactPoint v = *arguments.vector_or_number("v", 1);
  if (v.x == 0 || v.y == 0 || v.z == 0) {
    arguments.fail_at("v", "a scale must not be zero");
  }
  return geometry::scaling(v);
}

AffineMap mirror(const Arguments& arguments) {
  const ExactPoint normal = *arguments.vector("v", 0);
  if (normal == ExactPoint{}) {
    arguments.fail_at("v", "the normal of the mirror must not be zero");
  }
  return geometry::reflection(normal);
}

AffineMap rotate_by_quaternion(const Arguments& arguments) {
  const std::vector<Rational> q = *arguments.numbers("quaternion");
  if (q.size() != 4 || std::all_of(q.begin(), q.end(), [](const Rational& c) { return c == 0; })) {
    arguments.fail_at("quaternion", "`quaternion` must be [w, x, y, z], not all zero");
  }
  return geometry::rotation(q[0], {q[1], q[2], q[3]});
}

AffineMap rotate(const Arguments& arguments) {
  if (arguments.has("quaternion")) {
    if (arguments.has("a") || arguments.has("v")) {
      arguments.fail_at("quaternion", "`quaternion` goes without other arguments");
    }
    return rotate_by_quaternion(arguments);
  }
  if (!arguments.has("a")) {
    arguments.fail("the argument `a` is missing");
  }
  if (arguments.is_number("a")) {
    const ExactPoint axis = arguments.vector("v", 0).value_or(ExactPoint{0, 0, 1});
    if (axis == ExactPoint{}) {
      arguments.fail_at("v", "the axis must not be zero");
    }
    return geometry::rotation_about(axis, *arguments.number("a"));
  }
  if (arguments.has("v")) {
    arguments.fail_at("v", "an axis goes with one angle, not with three");
  }
  const ExactPoint degrees = *arguments.vector("a", 0);
  return compose(geometry::rotation_about({0, 0, 1}, degrees.z),
                 compose(geometry::rotation_about({0, 1, 0}, degrees.y),
                         geometry::rotation_about({1, 0, 0}, degrees.x)));
}

AffineMap multmatrix(const Arguments& arguments) {
  const std::vector<std::vector<Rational>> rows = *arguments.matrix("m", 4);
  if (rows.size() != 3 && rows.size() != 4) {
    arguments.fail_at("m", "`m` must have three or four rows");
  }
  if (rows.size() == 4 && rows[3] != std::vector<Rational>{0, 0, 0, 1}) {
    arguments.fail_at("m", "the last row of `m` must be [0, 0, 0, 1]");
  }
  AffineMap map;
  for (std::size_t row = 0; row < 3; ++row) {
    std::copy(rows[row].begin(), rows[row].end(), map.rows[row].begin());
  }
  if (determinant(map) == 0) {
    arguments.fail_at("m", "`m` must not be singular");
  }
  return map;
}

const std::array kTransforms{
    Transform{"translate", {"translate(v = [x, y, z])", {"v"}, 1}, translate},
    Transform{"scale", {"scale(v = [x, y, z])", {"v"}, 1}, scale},
    Transform{"mirror", {"mirror(v = [x, y, z])", {"v"}, 1}, mirror},
    Transform{"rotate",
              {"rotate(a = [x, y, z]), rotate(a = degrees, v = [x, y, z]) or "
               "rotate(quaternion = [w, x, y, z])",
               {"a", "v"},
               0,
               {"quaternion"}},
              rotate},
    Transform{"multmatrix",
              {"multmatrix(m = [[a, b, c, d], ...]) with three or four rows", {"m"}, 1},
              multmatrix},
};

}  // namespace

const Transform* find_transform(std::string_view name) {
  for (const Transform& transform : kTransforms) {
    if (transform.name == name) {
      return &transform;
    }
  }
  return nullptr;
}

}  // namespace lamina::scene
