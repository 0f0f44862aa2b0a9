// A primitive solid in its own coordinates: half-spaces and other solids under one operator.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/medium.hpp"
#include "geometry/affine.hpp"
#include "scene/scene.hpp"
#include "surface/half_space.hpp"

namespace lamina::scene {

struct Solid {
  struct Part {
    std::string name;  ///< `+x`, `side`; empty where there is only one part
    surface::LocalSurface surface;
  };

  csg::Operator op = csg::Operator::Intersection;
  std::vector<Part> parts{};
  std::vector<Solid> solids{};  ///< operands after the parts; without either the solid is empty
  std::optional<Bounds> box{};  ///< none: the solid is unbounded, or empty
  /// To the coordinates of the solid that this one is an operand of; not for the outermost.
  std::optional<geometry::AffineMap> placement{};
};

}  // namespace lamina::scene
