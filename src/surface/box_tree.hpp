// A binary tree of the rectangles of a contour's pieces.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/ray_image.hpp"

namespace lamina::surface {

/// Over pieces in order: a node's rectangle is that of consecutive pieces, its children have a half
/// of them each, a leaf one.
template <number::RoundedNumber Number>
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const PlaneBox<Number>> pieces) {
    nodes_.reserve(2 * pieces.size());
    if (!pieces.empty()) {
      add(pieces, 0);
    }
  }

  /// Calls visit(piece), in ascending order, for all pieces but those with a parent whose rectangle
  /// is excluded, until it returns false. A piece's own rectangle is left to `visit`. Allocates
  /// nothing: the nodes stand in preorder, and what is excluded is jumped over.
  template <typename Excludes, typename Visit>
  void visit_pieces(const Excludes& excludes, const Visit& visit) const {
    for (std::size_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      const bool is_leaf = node.end == i + 1;
      if (is_leaf && !visit(node.first)) {
        return;
      }
      i = is_leaf || !excludes(node.box) ? i + 1 : node.end;
    }
  }

 private:
  struct Node {
    PlaneBox<Number> box;
    std::uint32_t first;  // of its pieces
    std::uint32_t end;    // the node behind all of its descendants
  };

  void add(std::span<const PlaneBox<Number>> pieces, std::uint32_t first) {
    PlaneBox<Number> box = pieces[0];
    for (const PlaneBox<Number>& piece : pieces) {
      box = {std::min(box.u_min, piece.u_min), std::max(box.u_max, piece.u_max),
             std::min(box.v_min, piece.v_min), std::max(box.v_max, piece.v_max)};
    }
    const std::size_t place = nodes_.size();
    nodes_.push_back({box, first, 0});
    if (const std::size_t half = pieces.size() / 2; half > 0) {
      add(pieces.first(half), first);
      add(pieces.subspan(half), first + static_cast<std::uint32_t>(half));
    }
    nodes_[place].end = static_cast<std::uint32_t>(nodes_.size());
  }

  std::vector<Node> nodes_;
};

}  // namespace lamina::surface
