// Scenes from text, the messages of those that are wrong, and exact membership of points.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "base/contract.hpp"
#include "scene/scene.hpp"

namespace lamina::support {

/// The scene of a text that has no fault.
inline scene::Scene scene_of(const std::string& text, bool facets = false) {
  return scene::parse_scene(text, "scene", {.facets = facets});
}

/// What reading the text says is wrong; empty if nothing is.
inline std::string error_of(const std::string& text, bool facets = false) {
  try {
    scene_of(text, facets);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

/// Whether the text is refused at `line:column` with a message that contains `message`.
inline ::testing::AssertionResult fails_at(const std::string& text, const std::string& place,
                                           const std::string& message) {
  const std::string error = error_of(text);
  if (error.starts_with("scene:" + place + ": ") && error.find(message) != std::string::npos) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << text << "\nsays: " << error;
}

/// The material's name at a point, "" for none; nothing if the point lies on a carrier
/// that is asked for.
inline std::optional<std::string> material_at(const scene::Scene& scene,
                                              const geometry::ExactPoint& point) {
  bool on_carrier = false;
  const csg::Medium medium = csg::evaluate(scene.tree, [&](csg::LeafIndex index) {
    const scene::Leaf& leaf = scene.leaves[index];
    const int sign = leaf.side * surface::sign_at(scene.carriers[leaf.carrier], point);
    on_carrier = on_carrier || sign == 0;
    return sign < 0 ? leaf.medium : csg::kEmpty;
  });
  return on_carrier ? std::nullopt : std::optional(scene.materials[medium].name);
}

}  // namespace lamina::support
