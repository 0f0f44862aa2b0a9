// What the order of coincident events can change: owners of an interface, laminae.
#pragma once

#include <span>
#include <vector>

#include "csg/ray_state.hpp"

namespace lamina::csg {

/// What a class of events with equal t does, over all orders of its events.
struct CoincidentClass {
  Transition transition;          ///< all events at once
  std::vector<LeafIndex> owners;  ///< leaves whose event changes the medium in some order
  bool lamina = false;            ///< from = to, but some order shows another medium between
};

/// Returns what the class does to a ray in `state`, and leaves `state` after it.
///
/// Arguments: leaves  the leaves with an event in the class, each once, ascending.
/// Exact, without looking at orders one by one: an event e changes the medium in some
/// order if and only if it does so after some subset of the other events, and since
/// every leaf is used once in the tree, the media that a subtree can show after any
/// subset are the combinations of what its two halves can show.
/// Cost: O(nodes * media^2) per class of two or more leaves, O(depth) for one.
CoincidentClass classify_class(const Tree& tree, RayState& state,
                               std::span<const LeafIndex> leaves);

}  // namespace lamina::csg
