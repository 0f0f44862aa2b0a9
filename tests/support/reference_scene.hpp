// A second oracle, part one: scenes as data, their text, and what is at a point.
//
// It shares no code with the number type `exact`: from the project it takes GMP's rationals as
// a bare type. Maps are undone step by step, primitives have their own formulae, and media
// their own operators.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "number/rational.hpp"

namespace lamina::reference {

using number::Rational;
using Vector = std::array<Rational, 3>;

/// One map of a chain, as the scene language writes it.
struct Step {
  enum class Kind { Translate, Scale, Rotate, Mirror };
  Kind kind = Kind::Translate;
  /// Three numbers; for Rotate the four of a quaternion w, x, y, z.
  std::vector<Rational> by;
};
using Chain = std::vector<Step>;  ///< the first is outermost: it is applied last

struct Primitive {
  enum class Kind { Box, Cylinder, Sphere, Torus, HalfSpace, Quadric };
  Kind kind = Kind::Sphere;
  /// Box       size x, y, z          Torus      R, r
  /// Cylinder  h, r1, r2             HalfSpace  normal x, y, z, offset
  /// Sphere    r                     Quadric    the 16 entries of its matrix, by rows
  std::vector<Rational> numbers;
  bool center = false;  ///< of boxes and cylinders
};

/// Empty, or the material that is named "m" and this number.
using Medium = int;
inline constexpr Medium kNothing = 0;
std::string name_of(Medium medium);

enum class Operation { Add, Difference, Intersection };
Medium operate(Operation operation, Medium left, Medium right);

/// A solid, or an operation on two or more operands from left to right.
struct Node {
  Chain chain;  ///< of a solid
  Primitive primitive;
  Medium material = 1;
  Operation operation = Operation::Add;
  std::vector<Node> operands;  ///< none: a solid

  [[nodiscard]] bool is_solid() const { return operands.empty(); }
};

/// A point, or a direction, that neither translations move.
enum class Kind { Point, Direction };
Vector to_world(const Chain& chain, Vector local, Kind kind);
Vector to_local(const Chain& chain, Vector world, Kind kind);

/// How many half-spaces a primitive is the intersection of: their order is the scene's.
std::size_t face_count(const Primitive& primitive);
std::size_t face_count(const Node& node);
bool has_torus(const Node& node);
/// Is the solid side of this half-space what is left when its complement is taken away? The
/// scene language cuts cylinders so. It matters to what lies in the boundary: by convention it
/// is outside of the leaf, and so on the solid side where the leaf is taken away.
bool is_cut(const Primitive& primitive, std::size_t face);

/// In the scene language.
std::string text_of(const Node& node);
std::string text_of(const Chain& chain);

/// What is at a point, where surfaces belong to the outside of leaves.
struct Membership {
  Medium medium = kNothing;
  std::size_t surfaces = 0;  ///< so many half-spaces have the point on their boundary
};
Membership membership(const Node& node, const Vector& point);

}  // namespace lamina::reference
