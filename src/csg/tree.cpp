#include "csg/tree.hpp"

#include <utility>

#include "base/contract.hpp"

namespace lamina::csg {

Expression Expression::of_leaf(LeafIndex leaf) {
  Expression result;
  result.kind = Kind::Leaf;
  result.leaf = leaf;
  return result;
}

Expression Expression::of(Operator op, std::vector<Expression> operands) {
  const bool first_counts = op != Operator::Add;
  std::vector<Expression> kept;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].kind == Kind::Empty) {
      if (op == Operator::Intersection || (first_counts && i == 0)) {
        return empty();
      }
      continue;
    }
    kept.push_back(std::move(operands[i]));
  }
  if (kept.empty()) {
    return empty();
  }
  if (kept.size() == 1) {
    return std::move(kept.front());
  }
  Expression result;
  result.kind = Kind::Operation;
  result.op = op;
  result.operands = std::move(kept);
  return result;
}

std::vector<LeafIndex> renumber_leaves(Expression& expression) {
  std::vector<LeafIndex> old_index;
  const auto visit = [&old_index](auto& self, Expression& node) -> void {
    if (node.kind == Expression::Kind::Leaf) {
      old_index.push_back(node.leaf);
      node.leaf = static_cast<LeafIndex>(old_index.size() - 1);
    }
    for (Expression& operand : node.operands) {
      self(self, operand);
    }
  };
  visit(visit, expression);
  return old_index;
}

Tree::Tree(const Expression& expression, std::vector<Medium> media) : media_(std::move(media)) {
  nodes_.resize(media_.size());
  if (expression.kind != Expression::Kind::Empty) {
    const NodeIndex last = add(expression);
    LAMINA_REQUIRE(last == root(), "the root is the last node");
  }
}

NodeIndex Tree::add(const Expression& expression) {
  if (expression.kind == Expression::Kind::Leaf) {
    LAMINA_REQUIRE(expression.leaf < media_.size(), "leaves are numbered 0, 1, ...");
    return expression.leaf;
  }
  LAMINA_REQUIRE(expression.operands.size() >= 2, "an operation has two operands or more");
  if (expression.op == Operator::Difference) {
    const NodeIndex minuend = add(expression.operands.front());
    const NodeIndex subtrahend =
        balanced(Operator::Add, expression.operands, 1, expression.operands.size());
    return join(Operator::Difference, minuend, subtrahend);
  }
  return balanced(expression.op, expression.operands, 0, expression.operands.size());
}

NodeIndex Tree::balanced(Operator op, const std::vector<Expression>& operands, std::size_t first,
                         std::size_t last) {
  if (last - first == 1) {
    return add(operands[first]);
  }
  const std::size_t middle = first + (last - first) / 2;
  const NodeIndex left = balanced(op, operands, first, middle);
  return join(op, left, balanced(op, operands, middle, last));
}

NodeIndex Tree::join(Operator op, NodeIndex left, NodeIndex right) {
  const auto index = static_cast<NodeIndex>(nodes_.size());
  nodes_.push_back({op, left, right, kNoNode});
  nodes_[left].parent = index;
  nodes_[right].parent = index;
  return index;
}

}  // namespace lamina::csg
