#include "scene/scene.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/contract.hpp"
#include "scene/builder.hpp"

namespace lamina::scene {

Scene parse_scene(const std::string& text, const std::string& name, const ReadOptions& options) {
  const Source source(name, text);
  Scene scene = build_scene(source, parse_syntax(source), options);
  scene.name = name;
  return scene;
}

Scene read_scene(const std::string& path, const ReadOptions& options) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text) {
    throw base::InputError(fmt::format("{}: the file cannot be read", path));
  }
  return parse_scene(text.str(), path, options);
}

}  // namespace lamina::scene
