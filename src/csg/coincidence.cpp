#include "csg/coincidence.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/contract.hpp"

namespace lamina::csg {
namespace {

// Sets of media and of transitions: tiny, sorted, without duplicates.
template <typename Value>
void insert(std::vector<Value>& set, Value value) {
  if (std::find(set.begin(), set.end(), value) == set.end()) {
    set.push_back(value);
  }
}

// The media that nodes can show after any subset of the class's events. Only nodes above
// a leaf of the class are stored; every other node shows the one medium it has.
class Reachable {
 public:
  Reachable(const Tree& tree, const RayState& state, std::span<const LeafIndex> leaves)
      : tree_(tree), state_(state) {
    for (const LeafIndex leaf : leaves) {
      media_[leaf] = {kEmpty, tree.medium_of(leaf)};
    }
    for (const LeafIndex leaf : leaves) {
      for (NodeIndex node = tree.nodes()[leaf].parent; node != kNoNode;
           node = tree.nodes()[node].parent) {
        media_[node];  // children have lower indices than parents: visited in order below
      }
    }
    for (auto& [node, set] : media_) {
      if (node < tree.leaf_count()) {
        continue;
      }
      const Tree::Node& n = tree.nodes()[node];
      for (const Medium left : of(n.left)) {
        for (const Medium right : of(n.right)) {
          insert(set, combine(n.op, left, right));
        }
      }
    }
  }

  [[nodiscard]] std::vector<Medium> of(NodeIndex node) const {
    const auto found = media_.find(node);
    return found != media_.end() ? found->second : std::vector<Medium>{state_.medium_at(node)};
  }

  // Does the leaf's event change the medium of the whole after some subset of the others?
  [[nodiscard]] bool owns(LeafIndex leaf) const {
    std::vector<Transition> changes{{kEmpty, tree_.medium_of(leaf)}};
    for (NodeIndex child = leaf, node = tree_.nodes()[leaf].parent; node != kNoNode;
         child = node, node = tree_.nodes()[node].parent) {
      const Tree::Node& n = tree_.nodes()[node];
      const bool from_left = n.left == child;
      std::vector<Transition> lifted;
      for (const Medium sibling : of(from_left ? n.right : n.left)) {
        for (const Transition& change : changes) {
          const Transition still{sibling, sibling};
          const Transition here = from_left ? lift(n.op, change, still) : lift(n.op, still, change);
          if (here.from != here.to) {
            insert(lifted, here);
          }
        }
      }
      changes = std::move(lifted);
    }
    return !changes.empty();
  }

 private:
  const Tree& tree_;
  const RayState& state_;
  std::map<NodeIndex, std::vector<Medium>> media_;
};

}  // namespace

CoincidentClass classify_class(const Tree& tree, RayState& state,
                               std::span<const LeafIndex> leaves) {
  LAMINA_REQUIRE(!leaves.empty(), "a class has at least one event");
  CoincidentClass result;
  result.transition.from = state.medium();
  if (leaves.size() > 1) {
    const Reachable reachable(tree, state, leaves);
    std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result.owners),
                 [&reachable](LeafIndex leaf) { return reachable.owns(leaf); });
    result.lamina = reachable.of(tree.root()).size() > 1;
  }
  for (const LeafIndex leaf : leaves) {
    state.toggle(leaf);
  }
  result.transition.to = state.medium();
  if (leaves.size() == 1 && result.transition.from != result.transition.to) {
    result.owners.assign(leaves.begin(), leaves.end());
  }
  result.lamina = result.lamina && result.transition.from == result.transition.to;
  return result;
}

}  // namespace lamina::csg
