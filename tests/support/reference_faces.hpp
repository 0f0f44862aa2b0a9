// The second oracle's formulae of the primitives, for points and for polynomials along rays.
#pragma once

#include "support/reference_scene.hpp"

namespace lamina::reference {

/// f of each half-space of the primitive, inside where f < 0. A Scalar is a rational, or a
/// polynomial with rational coefficients that a rational converts to.
template <typename Scalar>
std::vector<Scalar> faces_at(const Primitive& primitive, const std::array<Scalar, 3>& p) {
  const auto& n = primitive.numbers;
  const auto& [x, y, z] = p;
  const auto constant = [](const Rational& value) { return Scalar(value); };
  switch (primitive.kind) {
    case Primitive::Kind::Box: {
      std::vector<Scalar> faces;
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational low = primitive.center ? Rational(-n[i] / 2) : Rational(0);
        faces.push_back(constant(low) - p[i]);
        faces.push_back(p[i] - constant(low + n[i]));
      }
      return faces;
    }
    case Primitive::Kind::Cylinder: {
      const Rational low = primitive.center ? Rational(-n[0] / 2) : Rational(0);
      const Scalar radius =
          constant(n[1]) + constant(Rational((n[2] - n[1]) / n[0])) * (z - constant(low));
      return {x * x + y * y - radius * radius, constant(low) - z, z - constant(low + n[0])};
    }
    case Primitive::Kind::Sphere:
      return {x * x + y * y + z * z - constant(n[0] * n[0])};
    case Primitive::Kind::Torus: {
      const Scalar across = x * x + y * y;
      const Scalar sum = across + z * z + constant(n[0] * n[0] - n[1] * n[1]);
      return {sum * sum - constant(4 * n[0] * n[0]) * across};
    }
    case Primitive::Kind::HalfSpace:
      return {constant(n[0]) * x + constant(n[1]) * y + constant(n[2]) * z - constant(n[3])};
    case Primitive::Kind::Quadric: {
      const std::array<Scalar, 4> v{x, y, z, constant(1)};
      Scalar sum = constant(0);
      for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
          sum = sum + constant(n[4 * row + column]) * v[row] * v[column];
        }
      }
      return {sum};
    }
  }
  return {};
}

}  // namespace lamina::reference
