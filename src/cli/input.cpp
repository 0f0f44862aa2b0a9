#include "cli/input.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "base/contract.hpp"
#include "geometry/ray_text.hpp"

namespace lamina::cli {
namespace {

template <typename Parse>
auto read_lines(const std::string& path, Parse parse) {
  std::vector<decltype(parse(std::string_view{}))> items;
  std::ifstream file(path);
  if (!file) {
    throw base::InputError(fmt::format("'{}' cannot be read", path));
  }
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::string_view content = std::string_view(line).substr(0, line.find('#'));
    if (content.find_first_not_of(" \t\r") == std::string_view::npos) {
      continue;
    }
    try {
      items.push_back(parse(content));
    } catch (const base::InputError& error) {
      throw base::InputError(fmt::format("{}:{}: {}\n{}", path, number, error.what(), line));
    }
  }
  return items;
}

}  // namespace

std::vector<geometry::ExactRay> read_rays(const std::string& path) {
  return read_lines(path, geometry::parse_ray);
}

std::vector<geometry::ExactPoint> read_points(const std::string& path) {
  return read_lines(path, geometry::parse_point);
}

geometry::ExactRay parse_ray(std::string_view text) {
  try {
    return geometry::parse_ray(text);
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("--ray \"{}\": {}", text, error.what()));
  }
}

trace::ImageSize parse_size(const std::string& text) {
  trace::ImageSize size;
  char rest = 0;
  constexpr int kMost = 16384;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
      size.width < 1 || size.height < 1 || size.width > kMost || size.height > kMost) {
    throw base::InputError(
        fmt::format("--size '{}': write it as WxH, as in 640x480, each up to {}", text, kMost));
  }
  return size;
}

}  // namespace lamina::cli
