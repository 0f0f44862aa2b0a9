#include "cli/input.hpp"

#include <fmt/format.h>

#include <fstream>

#include "base/contract.hpp"

namespace lamina::cli {
namespace {

using number::Rational;

std::vector<Rational> parse_numbers_of_line(std::string_view line, std::size_t expected,
                                            const char* what) {
  constexpr std::string_view kBlanks = " \t\r,";
  std::vector<Rational> numbers;
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    numbers.push_back(number::parse_rational(line.substr(begin, end - begin)));
    begin = line.find_first_not_of(kBlanks, end);
  }
  if (numbers.size() != expected) {
    throw base::InputError(
        fmt::format("{} is {} numbers, here are {}", what, expected, numbers.size()));
  }
  return numbers;
}

geometry::ExactRay ray_of_line(std::string_view line) {
  const auto n = parse_numbers_of_line(line, 6, "a ray (ox oy oz dx dy dz)");
  geometry::ExactRay ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  if (ray.direction == geometry::ExactPoint{0, 0, 0}) {
    throw base::InputError("the direction of a ray is not zero");
  }
  return ray;
}

geometry::ExactPoint point_of_line(std::string_view line) {
  const auto n = parse_numbers_of_line(line, 3, "a point (x y z)");
  return {n[0], n[1], n[2]};
}

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
  return read_lines(path, ray_of_line);
}

std::vector<geometry::ExactPoint> read_points(const std::string& path) {
  return read_lines(path, point_of_line);
}

geometry::ExactRay parse_ray(std::string_view text) {
  try {
    return ray_of_line(text);
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("--ray \"{}\": {}", text, error.what()));
  }
}

}  // namespace lamina::cli
