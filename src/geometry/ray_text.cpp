#include "geometry/ray_text.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;

std::vector<Rational> parse_numbers(std::string_view text, std::size_t expected, const char* what) {
  constexpr std::string_view kBlanks = " \t\r,";
  std::vector<Rational> numbers;
  for (std::size_t begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    numbers.push_back(number::parse_rational(text.substr(begin, end - begin)));
    begin = text.find_first_not_of(kBlanks, end);
  }
  if (numbers.size() != expected) {
    throw base::InputError(
        fmt::format("{} is {} numbers, here are {}", what, expected, numbers.size()));
  }
  return numbers;
}

}  // namespace

ExactRay parse_ray(std::string_view text) {
  const auto n = parse_numbers(text, 6, "a ray (ox oy oz dx dy dz)");
  ExactRay ray{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  if (ray.direction == ExactPoint{0, 0, 0}) {
    throw base::InputError("the direction of a ray is not zero");
  }
  return ray;
}

ExactPoint parse_point(std::string_view text) {
  const auto n = parse_numbers(text, 3, "a point (x y z)");
  return {n[0], n[1], n[2]};
}

std::string to_text(const ExactRay& ray) {
  const auto& [o, d] = ray;
  using number::to_text;
  return fmt::format("{} {} {} {} {} {}", to_text(o.x), to_text(o.y), to_text(o.z), to_text(d.x),
                     to_text(d.y), to_text(d.z));
}

}  // namespace lamina::geometry
