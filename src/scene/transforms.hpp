// The nodes of the scene language that move, turn and scale their children.
#pragma once

#include <string_view>

#include "geometry/affine.hpp"
#include "scene/arguments.hpp"

namespace lamina::scene {

struct Transform {
  std::string_view name;
  Signature signature;
  /// Not singular: that is an input error.
  geometry::AffineMap (*read)(const Arguments& arguments);
};

/// The transform of that name, or null.
const Transform* find_transform(std::string_view name);

}  // namespace lamina::scene
