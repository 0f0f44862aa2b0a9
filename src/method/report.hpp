// What a method says of one ray, whatever the number type.
#pragma once

#include <vector>

#include "csg/tree.hpp"

namespace lamina::method {

/// A surface that the method says the ray goes through, from one medium to another.
struct Interface {
  std::uint32_t crossing = 0;  ///< index into Tracer::crossings(), of the reported leaf
  csg::Transition transition;
};

/// The answer for t > 0. Reused from ray to ray.
struct Report {
  csg::Medium start = csg::kEmpty;    ///< at t = 0+
  std::vector<Interface> interfaces;  ///< t > 0, in the method's order
  csg::Medium end = csg::kEmpty;      ///< behind the last event
  std::uint32_t rejected = 0;         ///< events with t > 0 that the validity check refused
  std::uint32_t inconsistent = 0;     ///< enters while IN and leaves while OUT, t > 0

  void clear() {
    interfaces.clear();
    start = end = csg::kEmpty;
    rejected = inconsistent = 0;
  }
};

/// A crossing without its number type.
struct CrossingId {
  csg::LeafIndex leaf = 0;
  std::uint16_t index = 0;  ///< among the leaf's crossings as this number type found them
  bool ahead = false;       ///< t > 0
  bool enters = false;      ///< by root parity
};

/// One event as a method processed it; for explanations.
struct EventRecord {
  std::uint32_t crossing = 0;
  std::uint32_t group = 0;           ///< events of one group are processed at once
  bool enters = false;               ///< in the sense that the method uses
  bool accepted = true;              ///< false where the validity check rejected it
  bool inside = false;               ///< of its leaf, after the event
  csg::Medium medium = csg::kEmpty;  ///< of the whole tree after the event
};

}  // namespace lamina::method
