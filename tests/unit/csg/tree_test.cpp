#include "csg/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/contract.hpp"
#include "support/class_tally.hpp"
#include "support/random_csg.hpp"

namespace lamina::csg {
namespace {

using support::plain_medium;

constexpr std::uint64_t kCases = 3000;
constexpr std::uint64_t kSeed = 1;

std::vector<bool> random_flags(base::SeededStream& stream, std::size_t count) {
  std::vector<bool> flags(count);
  for (std::size_t i = 0; i < count; ++i) {
    flags[i] = stream.chance(0.5);
  }
  return flags;
}

// The leaves of an expression from left to right.
void collect_leaves(const Expression& expression, std::vector<LeafIndex>& leaves) {
  if (expression.kind == Expression::Kind::Leaf) {
    leaves.push_back(expression.leaf);
  }
  for (const Expression& operand : expression.operands) {
    collect_leaves(operand, leaves);
  }
}

std::vector<LeafIndex> leaves_of(const Expression& expression) {
  std::vector<LeafIndex> leaves;
  collect_leaves(expression, leaves);
  return leaves;
}

// The expression built again through Expression::of.
Expression simplified(const Expression& expression) {
  if (expression.kind != Expression::Kind::Operation) {
    return expression;
  }
  std::vector<Expression> operands;
  for (const Expression& operand : expression.operands) {
    operands.push_back(simplified(operand));
  }
  return Expression::of(expression.op, std::move(operands));
}

bool has_empty_operand_or_single_operand(const Expression& expression) {
  if (expression.kind != Expression::Kind::Operation) {
    return false;
  }
  return expression.operands.size() < 2 ||
         std::any_of(expression.operands.begin(), expression.operands.end(),
                     [](const Expression& operand) {
                       return operand.kind == Expression::Kind::Empty ||
                              has_empty_operand_or_single_operand(operand);
                     });
}

Expression wide(Operator op, LeafIndex count) {
  std::vector<Expression> operands;
  for (LeafIndex leaf = 0; leaf < count; ++leaf) {
    operands.push_back(Expression::of_leaf(leaf));
  }
  return Expression::of(op, std::move(operands));
}

TEST(TreeTest, BalancedTreeMeansTheExpressionFromLeftToRight) {
  support::ClassTally reached({"inside", "outside", "wide"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/tree/balanced", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(12));
    const Expression expression = support::random_expression(stream, 0, leaf_count);
    const std::vector<Medium> media = support::random_media(stream, leaf_count, 3);
    const Tree tree(expression, media);
    reached.add("wide", expression.operands.size() >= 4);
    for (int point = 0; point < 16; ++point) {
      const std::vector<bool> inside = random_flags(stream, leaf_count);
      const auto at = [&](LeafIndex leaf) { return inside[leaf] ? media[leaf] : kEmpty; };
      const Medium expected = plain_medium(expression, at);
      ASSERT_EQ(evaluate(tree, at), expected) << "case " << case_id << ": " << expression;
      reached.add(expected != kEmpty ? "inside" : "outside");
    }
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 10)) << reached;
}

TEST(TreeTest, ClassifiesTransitionsAsTheTwoMediaAroundThem) {
  support::ClassTally reached({"border", "discarded"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/tree/transitions", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(12));
    const Expression expression = support::random_expression(stream, 0, leaf_count);
    const std::vector<Medium> media = support::random_media(stream, leaf_count, 3);
    const std::vector<bool> before = random_flags(stream, leaf_count);
    const std::vector<bool> after = random_flags(stream, leaf_count);
    const auto medium = [&](LeafIndex leaf, const std::vector<bool>& inside) {
      return inside[leaf] ? media[leaf] : kEmpty;
    };
    const Transition expected{
        plain_medium(expression, [&](LeafIndex leaf) { return medium(leaf, before); }),
        plain_medium(expression, [&](LeafIndex leaf) { return medium(leaf, after); })};
    const Transition actual = evaluate(Tree(expression, media), [&](LeafIndex leaf) {
      return Transition{medium(leaf, before), medium(leaf, after)};
    });
    ASSERT_EQ(actual, expected) << "case " << case_id << ": " << expression;
    reached.add(expected.from != expected.to ? "border" : "discarded");
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 10)) << reached;
}

TEST(TreeTest, NodesComeAfterTheirChildrenAndKnowTheirParents) {
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/tree/nodes", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(12));
    const Tree tree(support::random_expression(stream, 0, leaf_count),
                    std::vector<Medium>(leaf_count, 1));
    ASSERT_EQ(tree.leaf_count(), leaf_count);
    ASSERT_EQ(tree.nodes().size(), 2 * leaf_count - 1);
    ASSERT_EQ(tree.nodes()[tree.root()].parent, kNoNode);
    for (NodeIndex index = leaf_count; index < tree.nodes().size(); ++index) {
      const Tree::Node& node = tree.nodes()[index];
      ASSERT_LT(node.left, index);
      ASSERT_LT(node.right, index);
      ASSERT_EQ(tree.nodes()[node.left].parent, index);
      ASSERT_EQ(tree.nodes()[node.right].parent, index);
    }
  }
}

TEST(TreeTest, WideOperationsHaveLogarithmicDepth) {
  constexpr LeafIndex kCount = 1024;
  for (const auto& [op, depth] :
       {std::pair{Operator::Add, 10}, {Operator::Intersection, 10}, {Operator::Difference, 11}}) {
    const Tree tree(wide(op, kCount), std::vector<Medium>(kCount, 1));
    for (LeafIndex leaf = 0; leaf < kCount; ++leaf) {
      int steps = 0;
      for (NodeIndex node = leaf; node != tree.root(); node = tree.nodes()[node].parent) {
        ++steps;
      }
      ASSERT_LE(steps, depth) << "leaf " << leaf;
    }
  }
}

TEST(TreeTest, EmptyTreeIsEmptyEverywhere) {
  const Tree tree(Expression::empty(), {});
  EXPECT_TRUE(tree.empty());
  EXPECT_EQ(evaluate(tree, [](LeafIndex) { return Medium{1}; }), kEmpty);
  EXPECT_TRUE(Tree().empty());
}

TEST(TreeTest, RefusesWrongLeavesAndLoneOperands) {
  EXPECT_THROW(Tree(Expression::of_leaf(1), {1}), base::ContractError);
  EXPECT_THROW(Tree(Expression::of_leaf(0), {1, 2}), base::ContractError);
  Expression lone;
  lone.kind = Expression::Kind::Operation;
  lone.operands = {Expression::of_leaf(0)};
  EXPECT_THROW(Tree(lone, {1}), base::ContractError);
}

TEST(ExpressionTest, LeavingOutEmptyOperandsKeepsTheMeaning) {
  support::ClassTally reached({"nothing_left", "one_leaf_left", "leaves_lost", "operation"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/expression/empties", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(8));
    const Expression written = support::random_expression(stream, 0, leaf_count, 0.25);
    const Expression kept = simplified(written);
    const std::vector<Medium> media = support::random_media(stream, leaf_count, 3);
    ASSERT_FALSE(has_empty_operand_or_single_operand(kept)) << written << " became " << kept;
    reached.add("nothing_left", kept.kind == Expression::Kind::Empty);
    reached.add("one_leaf_left", kept.kind == Expression::Kind::Leaf);
    reached.add("operation", kept.kind == Expression::Kind::Operation);
    reached.add("leaves_lost", leaves_of(kept).size() < leaf_count);
    for (unsigned inside = 0; inside < 1U << leaf_count; ++inside) {
      const auto at = [&](LeafIndex leaf) {
        return (inside >> leaf & 1U) != 0 ? media[leaf] : kEmpty;
      };
      ASSERT_EQ(plain_medium(kept, at), plain_medium(written, at))
          << "case " << case_id << ": " << written << " became " << kept;
    }
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 20)) << reached;
}

TEST(ExpressionTest, EmptyOperandsActByTheirPlace) {
  const auto leaf = Expression::of_leaf;
  const Expression empty = Expression::empty();
  const auto kind = [](Operator op, std::vector<Expression> operands) {
    return Expression::of(op, std::move(operands)).kind;
  };
  EXPECT_EQ(kind(Operator::Add, {empty, leaf(0)}), Expression::Kind::Leaf);
  EXPECT_EQ(kind(Operator::Add, {empty, empty}), Expression::Kind::Empty);
  EXPECT_EQ(kind(Operator::Difference, {empty, leaf(0)}), Expression::Kind::Empty);
  EXPECT_EQ(kind(Operator::Difference, {leaf(0), empty}), Expression::Kind::Leaf);
  EXPECT_EQ(kind(Operator::Difference, {leaf(0), empty, leaf(1)}), Expression::Kind::Operation);
  EXPECT_EQ(kind(Operator::Intersection, {leaf(0), leaf(1), empty}), Expression::Kind::Empty);
  EXPECT_EQ(kind(Operator::Add, {}), Expression::Kind::Empty);
}

TEST(ExpressionTest, RenumbersLeavesFromLeftToRight) {
  Expression expression = Expression::of(
      Operator::Difference,
      {Expression::of_leaf(5),
       Expression::of(Operator::Add, {Expression::of_leaf(7), Expression::of_leaf(2)})});
  EXPECT_EQ(renumber_leaves(expression), (std::vector<LeafIndex>{5, 7, 2}));
  EXPECT_EQ(leaves_of(expression), (std::vector<LeafIndex>{0, 1, 2}));
  Expression nothing = Expression::empty();
  EXPECT_TRUE(renumber_leaves(nothing).empty());
}

TEST(ExpressionTest, RenumberedLeavesKeepTheirMaterials) {
  support::ClassTally reached({"leaves_lost", "all_kept"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/expression/renumber", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(8));
    const Expression written = support::random_expression(stream, 0, leaf_count, 0.1);
    const std::vector<Medium> media = support::random_media(stream, leaf_count, 3);
    Expression kept = simplified(written);
    const std::vector<LeafIndex> expected_old = leaves_of(kept);
    const std::vector<LeafIndex> old_index = renumber_leaves(kept);
    ASSERT_EQ(old_index, expected_old);
    reached.add(old_index.size() < leaf_count ? "leaves_lost" : "all_kept");

    std::vector<Medium> kept_media;
    for (const LeafIndex old : old_index) {
      kept_media.push_back(media[old]);
    }
    const Tree tree(kept, kept_media);
    const std::vector<bool> inside = random_flags(stream, leaf_count);
    const auto at = [&](LeafIndex leaf) { return inside[leaf] ? media[leaf] : kEmpty; };
    ASSERT_EQ(evaluate(tree, [&](LeafIndex leaf) { return at(old_index[leaf]); }),
              plain_medium(written, at))
        << "case " << case_id << ": " << written << " became " << kept;
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 20)) << reached;
}

}  // namespace
}  // namespace lamina::csg
