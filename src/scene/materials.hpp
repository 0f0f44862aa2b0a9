// The materials of a scene while it is read: one for each name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace lamina::scene {

/// What a scene calls a texture: `wood` and so on; nothing for none.
std::string_view name_of(Texture texture);
std::optional<Texture> texture_named(std::string_view name);

class MaterialTable {
 public:
  MaterialTable();

  /// The medium of that name, which is not empty. Nothing if there are too many.
  std::optional<csg::Medium> named(const std::string& name);

  /// Whether the material can have this look, its name apart: it has no other one yet.
  [[nodiscard]] bool set_look(csg::Medium medium, Material look);

  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }

 private:
  std::vector<Material> materials_;
  std::vector<bool> has_look_;  // by medium
  std::map<std::string, csg::Medium> medium_of_name_;
};

}  // namespace lamina::scene
