// The primitive solids of the scene language.
#pragma once

#include <string_view>

#include "scene/arguments.hpp"
#include "scene/solid.hpp"

namespace lamina::scene {

struct Primitive {
  std::string_view name;
  Signature signature;
  /// `facets` is null where curved solids stay curved. A solid of size zero has no parts.
  Solid (*read)(const Arguments& arguments, const FacetSettings* facets);
};

/// The primitive of that name, or null.
const Primitive* find_primitive(std::string_view name);

}  // namespace lamina::scene
