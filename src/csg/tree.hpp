// CSG expressions, and the binary tree that rays are classified with.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/medium.hpp"

namespace lamina::csg {

using LeafIndex = std::uint32_t;
using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = UINT32_MAX;

/// A CSG expression as it is written: a leaf, the empty set, or an operator applied to
/// any number of operands from left to right (difference: the first minus all others).
struct Expression {
  enum class Kind : std::uint8_t { Empty, Leaf, Operation };

  Kind kind = Kind::Empty;
  Operator op = Operator::Add;
  LeafIndex leaf = 0;
  std::vector<Expression> operands;

  static Expression empty() { return {}; }
  static Expression of_leaf(LeafIndex leaf);
  /// Drops operands that change nothing: empty ones of `add`, empty subtrahends; an
  /// empty minuend or an empty operand of an intersection makes the whole empty.
  static Expression of(Operator op, std::vector<Expression> operands);
};

/// Renumbers the leaves of the expression 0, 1, ... from left to right and returns, for
/// each new index, the old one: leaves that an empty operand removed are not in it.
std::vector<LeafIndex> renumber_leaves(Expression& expression);

/// A binary tree over leaves 0 .. leaf_count-1, each used once. Nodes 0 .. leaf_count-1
/// are the leaves, children come before parents, the root is last. n-ary operators are
/// balanced, which leaves the meaning as it is since all three are associative in the
/// sense needed (a - b - c = a - (b add c)). Immutable: the state of a ray is elsewhere.
class Tree {
 public:
  struct Node {
    Operator op = Operator::Add;
    NodeIndex left = kNoNode;
    NodeIndex right = kNoNode;
    NodeIndex parent = kNoNode;
  };

  Tree() = default;
  /// `media[i]` is the material of leaf i; leaves must be numbered 0, 1, ... from left
  /// to right (renumber_leaves).
  Tree(const Expression& expression, std::vector<Medium> media);

  [[nodiscard]] std::size_t leaf_count() const { return media_.size(); }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] NodeIndex root() const { return static_cast<NodeIndex>(nodes_.size() - 1); }
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] Medium medium_of(LeafIndex leaf) const { return media_[leaf]; }

 private:
  NodeIndex add(const Expression& expression);
  NodeIndex balanced(Operator op, const std::vector<Expression>& operands, std::size_t first,
                     std::size_t last);
  NodeIndex join(Operator op, NodeIndex left, NodeIndex right);

  std::vector<Medium> media_;
  std::vector<Node> nodes_;
};

/// Returns the tree's value where `value(leaf)` is each leaf's: the medium at a point for
/// Medium values, the classification of an event for Transition values.
template <typename LeafValue>
auto evaluate(const Tree& tree, LeafValue&& value);

}  // namespace lamina::csg

#include "csg/tree.ipp"
