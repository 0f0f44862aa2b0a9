#include "scene/materials.hpp"

#include <algorithm>
#include <limits>

namespace lamina::scene {

MaterialTable::MaterialTable() : materials_{{"", {0, 0, 0, 0}}}, has_color_{false} {}

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
  materials_.push_back({name});
  has_color_.push_back(false);
  return medium;
}

bool MaterialTable::set_color(csg::Medium medium, const Color& color) {
  std::array<double, 4> rounded{};
  std::transform(color.begin(), color.end(), rounded.begin(),
                 [](const number::Rational& c) { return number::nearest_double(c); });
  Material& material = materials_[medium];
  if (has_color_[medium] && material.color != rounded) {
    return false;
  }
  material.color = rounded;
  has_color_[medium] = true;
  return true;
}

}  // namespace lamina::scene
