#include "csg/ray_state.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/class_tally.hpp"
#include "support/random_csg.hpp"

namespace lamina::csg {
namespace {

constexpr std::uint64_t kCases = 500;
constexpr std::uint64_t kSeed = 1;

// The media of all nodes, from the leaves up.
std::vector<Medium> from_scratch(const Tree& tree, const std::vector<bool>& inside) {
  std::vector<Medium> media;
  for (LeafIndex leaf = 0; leaf < tree.leaf_count(); ++leaf) {
    media.push_back(inside[leaf] ? tree.medium_of(leaf) : kEmpty);
  }
  for (std::size_t index = tree.leaf_count(); index < tree.nodes().size(); ++index) {
    const Tree::Node& node = tree.nodes()[index];
    media.push_back(combine(node.op, media[node.left], media[node.right]));
  }
  return media;
}

std::vector<Medium> all_media(const Tree& tree, const RayState& state) {
  std::vector<Medium> media;
  for (NodeIndex index = 0; index < tree.nodes().size(); ++index) {
    media.push_back(state.medium_at(index));
  }
  return media;
}

TEST(RayStateTest, AfterAnyTogglesEqualsAnEvaluationFromScratch) {
  support::ClassTally reached({"medium_changed", "change_hidden"});
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/ray_state/toggles", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(15));
    const Expression expression = support::random_expression(stream, 0, leaf_count);
    const Tree tree(expression, support::random_media(stream, leaf_count, 3));
    RayState state(tree);
    std::vector<bool> inside(leaf_count, false);
    EXPECT_EQ(state.medium(), kEmpty);
    for (int step = 0; step < 100; ++step) {
      const auto leaf = static_cast<LeafIndex>(stream.below(leaf_count));
      const Medium before = state.medium();
      if (step % 10 == 9) {
        inside[leaf] = stream.chance(0.5);  // often the state that it already has
        state.set(leaf, inside[leaf]);
      } else {
        inside[leaf] = !inside[leaf];
        state.toggle(leaf);
        reached.add(state.medium() != before ? "medium_changed" : "change_hidden");
      }
      const Medium expected = support::plain_medium(
          expression, [&](LeafIndex i) { return inside[i] ? tree.medium_of(i) : kEmpty; });
      ASSERT_EQ(state.inside(leaf), inside[leaf]);
      ASSERT_EQ(state.medium(), expected) << "case " << case_id << ": " << expression;
      ASSERT_EQ(all_media(tree, state), from_scratch(tree, inside)) << "case " << case_id;
    }
  }
  EXPECT_TRUE(reached.each_at_least(kCases * 10)) << reached;
}

TEST(RayStateTest, ResetForgetsTheRayBefore) {
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("csg/ray_state/reset", kSeed, case_id);
    const auto leaf_count = static_cast<LeafIndex>(1 + stream.below(15));
    const Tree tree(support::random_expression(stream, 0, leaf_count),
                    support::random_media(stream, leaf_count, 3));
    RayState state(tree);
    std::vector<bool> inside(leaf_count);
    for (int ray = 0; ray < 4; ++ray) {
      for (LeafIndex leaf = 0; leaf < leaf_count; ++leaf) {
        inside[leaf] = stream.chance(0.5);
      }
      state.reset([&](LeafIndex leaf) { return inside[leaf]; });
      ASSERT_EQ(all_media(tree, state), from_scratch(tree, inside)) << "case " << case_id;
      state.toggle(static_cast<LeafIndex>(stream.below(leaf_count)));
    }
  }
}

TEST(RayStateTest, EmptyTreeHasTheEmptyMedium) {
  const Tree tree;
  RayState state(tree);
  state.reset([](LeafIndex) { return true; });
  EXPECT_EQ(state.medium(), kEmpty);
}

}  // namespace
}  // namespace lamina::csg
