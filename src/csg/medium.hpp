// Media, the three operators on them, and their lift to what a ray sees.
#pragma once

#include <cstdint>

namespace lamina::csg {

/// A material of a scene by its index, or kEmpty. Materials are equal by name: the
/// scene gives one index to one name.
using Medium = std::uint16_t;
inline constexpr Medium kEmpty = 0;

enum class Operator : std::uint8_t {
  Add,           ///< Wyvill and Trotman's asymmetric addition (a - b) + b: the right one wins
  Difference,    ///< a - b
  Intersection,  ///< a where b is, with a's medium
};

/// Returns the medium of `a op b` at a point where a has `left` and b has `right`.
/// Source: Wyvill and Trotman 1990, sections 3.1 and 3.2.
constexpr Medium combine(Operator op, Medium left, Medium right) {
  switch (op) {
    case Operator::Add:
      return right != kEmpty ? right : left;
    case Operator::Difference:
      return right != kEmpty ? kEmpty : left;
    case Operator::Intersection:
      return right != kEmpty ? left : kEmpty;
  }
  return kEmpty;
}

/// What a ray goes from and to at an event: OUT is (empty, empty), IN m is (m, m),
/// BORDER a,b is (a, b).
struct Transition {
  Medium from = kEmpty;
  Medium to = kEmpty;

  friend constexpr bool operator==(const Transition&, const Transition&) = default;
};

/// The lift of an operator to transitions. It equals every printed cell of tables 1
/// and 2 of Wyvill and Trotman 1990, and fills the cell BORDER x BORDER that a single
/// leaf's event cannot reach: so it also combines events of several leaves at once.
constexpr Transition lift(Operator op, Transition left, Transition right) {
  return {combine(op, left.from, right.from), combine(op, left.to, right.to)};
}

}  // namespace lamina::csg
