// Random CSG expressions, what they mean by definition, and how failures print them.
#pragma once

#include <ostream>
#include <vector>

#include "base/seeded_stream.hpp"
#include "csg/tree.hpp"

namespace lamina::support {

/// Returns a random expression over the leaves first .. last-1, each used once, from left
/// to right. Every operation has two operands or more, each empty with `empty_chance`;
/// it is written down as it comes, without the simplifications of Expression::of.
inline csg::Expression random_expression(base::SeededStream& stream, csg::LeafIndex first,
                                         csg::LeafIndex last, double empty_chance = 0) {
  if (last - first == 1 && !stream.chance(empty_chance)) {
    return csg::Expression::of_leaf(first);
  }
  csg::Expression result;
  result.kind = csg::Expression::Kind::Operation;
  result.op = static_cast<csg::Operator>(stream.below(3));
  const csg::LeafIndex most_in_first = last - first > 1 ? last - first - 1 : 1;
  for (csg::LeafIndex next = first; next < last || result.operands.size() < 2;) {
    if (next == last || stream.chance(empty_chance)) {
      result.operands.push_back(csg::Expression::empty());
      continue;
    }
    const csg::LeafIndex most = next == first ? most_in_first : last - next;
    const auto size = static_cast<csg::LeafIndex>(1 + stream.below(most));
    result.operands.push_back(random_expression(stream, next, next + size, empty_chance));
    next += size;
  }
  return result;
}

/// Returns `count` materials out of 1 .. materials.
inline std::vector<csg::Medium> random_media(base::SeededStream& stream, std::size_t count,
                                             csg::Medium materials) {
  std::vector<csg::Medium> media(count);
  for (csg::Medium& medium : media) {
    medium = static_cast<csg::Medium>(1 + stream.below(materials));
  }
  return media;
}

/// Returns the medium of an expression by the definition of its operators: all operands,
/// from left to right, nothing left out.
template <typename LeafMedium>
csg::Medium plain_medium(const csg::Expression& expression, const LeafMedium& leaf_medium) {
  if (expression.kind == csg::Expression::Kind::Empty) {
    return csg::kEmpty;
  }
  if (expression.kind == csg::Expression::Kind::Leaf) {
    return leaf_medium(expression.leaf);
  }
  csg::Medium value = plain_medium(expression.operands.front(), leaf_medium);
  for (std::size_t i = 1; i < expression.operands.size(); ++i) {
    value = csg::combine(expression.op, value, plain_medium(expression.operands[i], leaf_medium));
  }
  return value;
}

}  // namespace lamina::support

namespace lamina::csg {

inline std::ostream& operator<<(std::ostream& out, const Transition& transition) {
  return out << '(' << transition.from << " -> " << transition.to << ')';
}

inline std::ostream& operator<<(std::ostream& out, const Expression& expression) {
  if (expression.kind == Expression::Kind::Empty) {
    return out << "empty";
  }
  if (expression.kind == Expression::Kind::Leaf) {
    return out << expression.leaf;
  }
  constexpr const char* kNames[] = {"add", "difference", "intersection"};
  out << kNames[static_cast<std::size_t>(expression.op)];
  const char* separator = "(";
  for (const Expression& operand : expression.operands) {
    out << separator << operand;
    separator = ", ";
  }
  return out << ')';
}

}  // namespace lamina::csg
