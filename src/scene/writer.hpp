// From a scene back to a text of the scene language.
#pragma once

#include <string>

#include "scene/scene.hpp"
#include "scene/syntax.hpp"

namespace lamina::scene {

/// Returns the tree of nodes of a text that reads back as the same solid: the same leaves in
/// the same order, with exactly the same surfaces, frames, carriers and names of materials, and
/// the same binary tree; so every ray is rounded alike. Each leaf is one half-space. What
/// several of them share, a map or a material, is stated once around them. Camera, lights and
/// colours are left out, and paths follow the new text.
Node syntax_of(const Scene& scene);

/// Returns the nodes that state the scene's materials that have a look, its camera, lights and
/// background, under one root: before those of syntax_of, they make up the whole scene.
Node declarations_of(const Scene& scene);

/// Returns the text of the nodes under `root`, indented, each ending in a newline. Exact.
std::string text_of(const Node& root);

}  // namespace lamina::scene
