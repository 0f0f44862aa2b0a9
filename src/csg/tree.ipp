#pragma once

#include <type_traits>

namespace lamina::csg {
namespace detail {

inline Medium apply(Operator op, Medium left, Medium right) { return combine(op, left, right); }
inline Transition apply(Operator op, Transition left, Transition right) {
  return lift(op, left, right);
}

template <typename LeafValue>
auto evaluate_node(const Tree& tree, NodeIndex index, LeafValue& value)
    -> std::decay_t<decltype(value(LeafIndex{}))> {
  using Value = std::decay_t<decltype(value(LeafIndex{}))>;
  if (index < tree.leaf_count()) {
    return value(static_cast<LeafIndex>(index));
  }
  const Tree::Node& node = tree.nodes()[index];
  const Value left = evaluate_node(tree, node.left, value);
  if (node.op != Operator::Add && left == Value{}) {
    return left;  // nothing minus or intersected with anything is nothing
  }
  return apply(node.op, left, evaluate_node(tree, node.right, value));
}

}  // namespace detail

template <typename LeafValue>
auto evaluate(const Tree& tree, LeafValue&& value) {
  using Value = std::decay_t<decltype(value(LeafIndex{}))>;
  return tree.empty() ? Value{} : detail::evaluate_node(tree, tree.root(), value);
}

}  // namespace lamina::csg
