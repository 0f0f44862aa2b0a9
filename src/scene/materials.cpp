#include "scene/materials.hpp"

#include <limits>
#include <utility>

namespace lamina::scene {

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
