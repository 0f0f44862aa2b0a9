#include "support/reference_scene.hpp"

#include <algorithm>

#include "support/reference_faces.hpp"

namespace lamina::reference {
namespace {

using Quaternion = std::array<Rational, 4>;

Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

// q v q* / |q|^2.
Vector turned(const Quaternion& q, const Vector& v) {
  const Quaternion conjugate{q[0], -q[1], -q[2], -q[3]};
  const Rational length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const Quaternion result = multiply(multiply(q, {0, v[0], v[1], v[2]}), conjugate);
  return {result[1] / length, result[2] / length, result[3] / length};
}

Vector mirrored(const std::vector<Rational>& normal, const Vector& v) {
  Rational along = 0;
  Rational length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += normal[i] * v[i];
    length += normal[i] * normal[i];
  }
  Vector result = v;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] -= 2 * along / length * normal[i];
  }
  return result;
}

Vector mapped(const Step& step, Vector v, Kind kind, bool back) {
  const auto& by = step.by;
  switch (step.kind) {
    case Step::Kind::Translate:
      for (std::size_t i = 0; i < 3 && kind == Kind::Point; ++i) {
        v[i] += back ? Rational(-by[i]) : by[i];
      }
      return v;
    case Step::Kind::Scale:
      for (std::size_t i = 0; i < 3; ++i) {
        v[i] *= back ? Rational(1 / by[i]) : by[i];
      }
      return v;
    case Step::Kind::Rotate:
      return back ? turned({by[0], -by[1], -by[2], -by[3]}, v)
                  : turned({by[0], by[1], by[2], by[3]}, v);
    case Step::Kind::Mirror:
      return mirrored(by, v);
  }
  return v;
}

std::string list(const std::vector<Rational>& numbers, std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    text += (i == first ? "[" : ", ") + numbers[i].str();
  }
  return text + "]";
}

std::string text_of(const Primitive& primitive) {
  const auto& n = primitive.numbers;
  const std::string center = primitive.center ? ", center=true);" : ");";
  switch (primitive.kind) {
    case Primitive::Kind::Box:
      return "cube(" + list(n, 0, 3) + center;
    case Primitive::Kind::Cylinder:
      return "cylinder(h=" + n[0].str() + ", r1=" + n[1].str() + ", r2=" + n[2].str() + center;
    case Primitive::Kind::Sphere:
      return "sphere(" + n[0].str() + ");";
    case Primitive::Kind::Torus:
      return "torus(" + n[0].str() + ", " + n[1].str() + ");";
    case Primitive::Kind::HalfSpace:
      return "halfspace(" + list(n, 0, 3) + ", " + n[3].str() + ");";
    case Primitive::Kind::Quadric:
      return "quadric([" + list(n, 0, 4) + ", " + list(n, 4, 8) + ", " + list(n, 8, 12) + ", " +
             list(n, 12, 16) + "]);";
  }
  return {};
}

}  // namespace

std::string name_of(Medium medium) {
  return medium == kNothing ? "" : "m" + std::to_string(medium);
}

Medium operate(Operation operation, Medium left, Medium right) {
  const bool in_left = left != kNothing;
  const bool in_right = right != kNothing;
  if (operation == Operation::Difference) {
    return in_left && !in_right ? left : kNothing;
  }
  if (operation == Operation::Intersection) {
    return in_left && in_right ? left : kNothing;
  }
  return in_right ? right : left;
}

Vector to_world(const Chain& chain, Vector local, Kind kind) {
  for (auto step = chain.rbegin(); step != chain.rend(); ++step) {
    local = mapped(*step, local, kind, false);
  }
  return local;
}

Vector to_local(const Chain& chain, Vector world, Kind kind) {
  for (const Step& step : chain) {
    world = mapped(step, world, kind, true);
  }
  return world;
}

std::size_t face_count(const Primitive& primitive) {
  return primitive.kind == Primitive::Kind::Box        ? 6
         : primitive.kind == Primitive::Kind::Cylinder ? 3
                                                       : 1;
}

std::size_t face_count(const Node& node) {
  std::size_t count = node.is_solid() ? face_count(node.primitive) : 0;
  for (const Node& operand : node.operands) {
    count += face_count(operand);
  }
  return count;
}

bool is_cut(const Primitive& primitive, std::size_t face) {
  return primitive.kind == Primitive::Kind::Cylinder && face > 0;
}

bool has_torus(const Node& node) {
  return node.is_solid() ? node.primitive.kind == Primitive::Kind::Torus
                         : std::any_of(node.operands.begin(), node.operands.end(), has_torus);
}

std::string text_of(const Chain& chain) {
  std::string text;
  for (const Step& step : chain) {
    const std::string by = list(step.by, 0, step.by.size());
    text += step.kind == Step::Kind::Translate ? "translate(" + by + ") "
            : step.kind == Step::Kind::Scale   ? "scale(" + by + ") "
            : step.kind == Step::Kind::Rotate  ? "rotate(quaternion=" + by + ") "
                                               : "mirror(" + by + ") ";
  }
  return text;
}

std::string text_of(const Node& node) {
  if (node.is_solid()) {
    return "material(\"" + name_of(node.material) + "\") " + text_of(node.chain) +
           text_of(node.primitive) + "\n";
  }
  constexpr std::array<const char*, 3> kNames{"add", "difference", "intersection"};
  std::string text = std::string(kNames[static_cast<std::size_t>(node.operation)]) + "() {\n";
  for (const Node& operand : node.operands) {
    text += text_of(operand);
  }
  return text + "}\n";
}

Membership membership(const Node& node, const Vector& point) {
  Membership result;
  if (node.is_solid()) {
    bool inside = true;
    const auto faces = faces_at<Rational>(node.primitive, to_local(node.chain, point, Kind::Point));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      inside = inside && (faces[i] == 0 ? is_cut(node.primitive, i) : faces[i] < 0);
      result.surfaces += faces[i] == 0 ? 1 : 0;
    }
    result.medium = inside ? node.material : kNothing;
    return result;
  }
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    const Membership operand = membership(node.operands[i], point);
    result.surfaces += operand.surfaces;
    result.medium =
        i == 0 ? operand.medium : operate(node.operation, result.medium, operand.medium);
  }
  return result;
}

}  // namespace lamina::reference
