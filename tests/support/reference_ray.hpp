// A second oracle, part three: all that a ray meets in a scene of planes and quadrics.
#pragma once

#include <vector>

#include "support/reference_scene.hpp"
#include "support/reference_surd.hpp"

namespace lamina::reference {

struct Ray {
  Vector origin;
  Vector direction;
};

/// All crossings of equal t, t > 0. Half-spaces are counted from left to right.
struct RayClass {
  Surd t;
  std::vector<std::size_t> leaves;
  std::vector<std::size_t> owners;  ///< their crossing changes the medium in some order
  Medium from = kNothing;
  Medium to = kNothing;
  bool lamina = false;  ///< from = to, and some order shows another medium between

  /// Owners and laminae are known for classes no larger than this: all subsets are tried.
  static constexpr std::size_t kMostLeaves = 10;
};

struct RayAnswer {
  Medium before = kNothing;  ///< for t towards -infinity
  Medium start = kNothing;   ///< at t = 0+
  Medium end = kNothing;
  std::vector<RayClass> classes;
  std::size_t in_carriers = 0;  ///< half-spaces whose boundary holds the whole ray
  std::size_t touches = 0;      ///< double roots at t > 0
};

/// Contract: no torus. A half-space whose boundary holds the ray is never entered.
RayAnswer answer(const Node& node, const Ray& ray);

/// How many half-spaces have the whole ray on their boundary; with tori.
std::size_t in_carriers(const Node& node, const Ray& ray);

}  // namespace lamina::reference
