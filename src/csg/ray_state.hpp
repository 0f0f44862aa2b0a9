// Where one ray is inside: kept per ray, never in the tree.
#pragma once

#include <vector>

#include "csg/tree.hpp"

namespace lamina::csg {

/// The medium of every node of a tree for one ray, updated along the path from a leaf
/// to the root when the leaf changes (the improvement that Wyvill and Trotman 1990,
/// section 5.0, hope for). Reused from ray to ray: no allocation after the first.
class RayState {
 public:
  explicit RayState(const Tree& tree) : tree_(&tree), media_(tree.nodes().size(), kEmpty) {}

  /// Sets all leaves at once; `inside(leaf)` says where each is.
  template <typename Inside>
  void reset(Inside&& inside) {
    const auto leaf_count = static_cast<LeafIndex>(tree_->leaf_count());
    for (LeafIndex leaf = 0; leaf < leaf_count; ++leaf) {
      media_[leaf] = inside(leaf) ? tree_->medium_of(leaf) : kEmpty;
    }
    for (std::size_t node = leaf_count; node < media_.size(); ++node) {
      update(node);
    }
  }

  [[nodiscard]] bool inside(LeafIndex leaf) const { return media_[leaf] != kEmpty; }

  void set(LeafIndex leaf, bool inside) {
    media_[leaf] = inside ? tree_->medium_of(leaf) : kEmpty;
    for (NodeIndex node = tree_->nodes()[leaf].parent; node != kNoNode;
         node = tree_->nodes()[node].parent) {
      if (!update(node)) {
        return;
      }
    }
  }

  void toggle(LeafIndex leaf) { set(leaf, !inside(leaf)); }

  /// The medium of the whole tree; empty for the empty tree.
  [[nodiscard]] Medium medium() const { return media_.empty() ? kEmpty : media_.back(); }

  /// The medium of one node's subtree.
  [[nodiscard]] Medium medium_at(NodeIndex node) const { return media_[node]; }

 private:
  bool update(std::size_t node) {
    const Tree::Node& n = tree_->nodes()[node];
    const Medium now = combine(n.op, media_[n.left], media_[n.right]);
    const bool changed = now != media_[node];
    media_[node] = now;
    return changed;
  }

  const Tree* tree_;
  std::vector<Medium> media_;
};

}  // namespace lamina::csg
