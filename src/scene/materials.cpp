#include "scene/materials.hpp"

#include <limits>
#include <utility>

namespace lamina::scene {

std::string_view name_of(Texture texture) {
  switch (texture) {
    case Texture::Wood:
      return "wood";
    case Texture::Marble:
      return "marble";
    case Texture::Checker:
      return "checker";
    case Texture::None:
      break;
  }
  return "";
}

std::optional<Texture> texture_named(std::string_view name) {
  for (const Texture texture : {Texture::Wood, Texture::Marble, Texture::Checker}) {
    if (name_of(texture) == name) {
      return texture;
    }
  }
  return std::nullopt;
}

MaterialTable::MaterialTable() : materials_(1), has_look_{false} {
  materials_[csg::kEmpty].color = {0, 0, 0, 0};
}

std::optional<csg::Medium> MaterialTable::named(const std::string& name) {
  const auto known = medium_of_name_.find(name);
  if (known != medium_of_name_.end()) {
    return known->second;
  }
  if (materials_.size() > std::numeric_limits<csg::Medium>::max()) {
    return std::nullopt;
  }
  const auto medium = static_cast<csg::Medium>(materials_.size());
  medium_of_name_.emplace(name, medium);
  materials_.emplace_back().name = name;
  has_look_.push_back(false);
  return medium;
}

bool MaterialTable::set_look(csg::Medium medium, Material look) {
  look.name = materials_[medium].name;
  if (has_look_[medium] && materials_[medium] != look) {
    return false;
  }
  materials_[medium] = std::move(look);
  has_look_[medium] = true;
  return true;
}

}  // namespace lamina::scene
