#include "csg/coincidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/contract.hpp"
#include "support/class_tally.hpp"
#include "support/random_csg.hpp"

namespace lamina::csg {
namespace {

// What a class does by the definition: every order of its events, one event at a time.
CoincidentClass over_all_orders(const Expression& expression, const std::vector<Medium>& media,
                                const std::vector<bool>& inside,
                                const std::vector<LeafIndex>& leaves) {
  // The medium of the whole after each subset of the events; bit i is the event of leaves[i].
  std::vector<Medium> after(std::size_t{1} << leaves.size());
  for (std::size_t subset = 0; subset < after.size(); ++subset) {
    std::vector<bool> now = inside;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if ((subset >> i & 1U) != 0) {
        now[leaves[i]].flip();
      }
    }
    after[subset] = support::plain_medium(
        expression, [&](LeafIndex leaf) { return now[leaf] ? media[leaf] : kEmpty; });
  }

  std::vector<bool> owns(leaves.size(), false);
  bool shows_another = false;
  std::vector<std::size_t> order(leaves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    std::size_t done = 0;
    for (const std::size_t event : order) {
      const Medium before = after[done];
      done |= std::size_t{1} << event;
      owns[event] = owns[event] || after[done] != before;
      shows_another = shows_another || after[done] != after.front();
    }
  } while (std::next_permutation(order.begin(), order.end()));

  CoincidentClass result;
  result.transition = {after.front(), after.back()};
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (owns[i]) {
      result.owners.push_back(leaves[i]);
    }
  }
  result.lamina = shows_another && after.front() == after.back();
  return result;
}

// `size` of the leaves 0 .. leaf_count-1, ascending.
std::vector<LeafIndex> random_class(base::SeededStream& stream, LeafIndex leaf_count,
                                    std::size_t size) {
  std::vector<LeafIndex> leaves(leaf_count);
  std::iota(leaves.begin(), leaves.end(), LeafIndex{0});
  while (leaves.size() > size) {
    leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(stream.below(leaves.size())));
  }
  return leaves;
}

TEST(CoincidenceTest, EqualsEveryOrderOfTheEventsTriedInTurn) {
  constexpr std::uint64_t kCases = 6000;
  support::ClassTally reached({"one_event", "six_events", "lamina_in_empty", "lamina_in_material",
                               "one_owner_of_several", "several_owners", "no_owner",
                               "empty_to_material", "material_to_material"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/coincidence", 1, case_id);
    const auto class_size = static_cast<LeafIndex>(1 + stream.below(6));
    const auto leaf_count = static_cast<LeafIndex>(class_size + stream.below(5));
    const auto materials = static_cast<Medium>(1 + stream.below(3));
    const Expression expression = support::random_expression(stream, 0, leaf_count);
    const std::vector<Medium> media = support::random_media(stream, leaf_count, materials);
    std::vector<bool> inside(leaf_count);
    for (LeafIndex leaf = 0; leaf < leaf_count; ++leaf) {
      inside[leaf] = stream.chance(0.5);
    }
    const std::vector<LeafIndex> leaves = random_class(stream, leaf_count, class_size);
    const CoincidentClass expected = over_all_orders(expression, media, inside, leaves);

    const Tree tree(expression, media);
    RayState state(tree);
    state.reset([&](LeafIndex leaf) { return inside[leaf]; });
    const CoincidentClass actual = classify_class(tree, state, leaves);

    SCOPED_TRACE(::testing::Message() << "case " << case_id << ": " << expression << ", leaves "
                                      << ::testing::PrintToString(leaves) << ", inside "
                                      << ::testing::PrintToString(inside) << ", media "
                                      << ::testing::PrintToString(media));
    ASSERT_EQ(actual.transition, expected.transition);
    ASSERT_EQ(actual.owners, expected.owners);
    ASSERT_EQ(actual.lamina, expected.lamina);
    ASSERT_EQ(state.medium(), expected.transition.to);
    for (LeafIndex leaf = 0; leaf < leaf_count; ++leaf) {
      const bool toggled = std::find(leaves.begin(), leaves.end(), leaf) != leaves.end();
      ASSERT_EQ(state.inside(leaf), inside[leaf] != toggled) << "leaf " << leaf;
    }

    const auto [from, to] = expected.transition;
    reached.add("one_event", class_size == 1);
    reached.add("six_events", class_size == 6);
    reached.add("lamina_in_empty", expected.lamina && from == kEmpty);
    reached.add("lamina_in_material", expected.lamina && from != kEmpty);
    reached.add("one_owner_of_several", class_size > 1 && expected.owners.size() == 1);
    reached.add("several_owners", from != to && expected.owners.size() > 1);
    reached.add("no_owner", class_size > 1 && expected.owners.empty());
    reached.add("empty_to_material", from == kEmpty && to != kEmpty);
    reached.add("material_to_material", from != to && from != kEmpty && to != kEmpty);
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 50)) << reached;
}

// Two closed cylinders, each a cylinder minus the half-space above its top, added. The
// tops lie in one plane, and the ray comes down inside the second cylinder.
TEST(CoincidenceTest, GhostSurfaceOfFigure4OwnsNothing) {
  constexpr LeafIndex kSideA = 0;
  constexpr LeafIndex kTopA = 1;
  constexpr LeafIndex kSideB = 2;
  constexpr LeafIndex kTopB = 3;
  constexpr Medium kRed = 1;
  constexpr Medium kBlue = 2;
  const auto cylinder = [](LeafIndex side, LeafIndex top) {
    return Expression::of(Operator::Difference,
                          {Expression::of_leaf(side), Expression::of_leaf(top)});
  };
  const Tree tree(Expression::of(Operator::Add, {cylinder(kSideA, kTopA), cylinder(kSideB, kTopB)}),
                  {kRed, kRed, kBlue, kBlue});
  RayState state(tree);
  state.reset([](LeafIndex leaf) { return leaf != kSideA; });
  const CoincidentClass tops = classify_class(tree, state, std::vector{kTopA, kTopB});
  EXPECT_EQ(tops.transition, (Transition{kEmpty, kBlue}));
  EXPECT_EQ(tops.owners, std::vector{kTopB});
  EXPECT_FALSE(tops.lamina);
}

TEST(CoincidenceTest, ObjectAddedToItselfHasTwoOwners) {
  const Tree tree(Expression::of(Operator::Add, {Expression::of_leaf(0), Expression::of_leaf(1)}),
                  {1, 1});
  RayState state(tree);
  const CoincidentClass entry = classify_class(tree, state, std::vector<LeafIndex>{0, 1});
  EXPECT_EQ(entry.transition, (Transition{kEmpty, 1}));
  EXPECT_EQ(entry.owners, (std::vector<LeafIndex>{0, 1}));
  EXPECT_FALSE(entry.lamina);
}

TEST(CoincidenceTest, ObjectMinusItselfIsALamina) {
  const Tree tree(
      Expression::of(Operator::Difference, {Expression::of_leaf(0), Expression::of_leaf(1)}),
      {1, 1});
  RayState state(tree);
  const CoincidentClass entry = classify_class(tree, state, std::vector<LeafIndex>{0, 1});
  EXPECT_EQ(entry.transition, (Transition{kEmpty, kEmpty}));
  EXPECT_TRUE(entry.lamina);
  const CoincidentClass exit = classify_class(tree, state, std::vector<LeafIndex>{0, 1});
  EXPECT_EQ(exit.transition, (Transition{kEmpty, kEmpty}));
  EXPECT_TRUE(exit.lamina);
}

TEST(CoincidenceTest, RefusesAClassWithoutEvents) {
  const Tree tree(Expression::of_leaf(0), {1});
  RayState state(tree);
  EXPECT_THROW(classify_class(tree, state, {}), base::ContractError);
}

}  // namespace
}  // namespace lamina::csg
