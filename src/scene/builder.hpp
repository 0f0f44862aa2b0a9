// From the tree of nodes to the scene it means.
#pragma once

#include "scene/scene.hpp"
#include "scene/syntax.hpp"

namespace lamina::scene {

/// Returns the scene of a parsed text, without its name. Throws base::InputError.
Scene build_scene(const Source& source, const Node& root, const ReadOptions& options);

}  // namespace lamina::scene
