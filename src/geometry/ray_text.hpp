// Rays and points as text, exact both ways.
#pragma once

#include <string>
#include <string_view>

#include "geometry/vector.hpp"

namespace lamina::geometry {

/// Reads "ox oy oz dx dy dz": six numbers (decimal or a/b) separated by blanks or commas.
/// Throws base::InputError if they are not six, or the direction is zero.
ExactRay parse_ray(std::string_view text);

/// Likewise a point, three numbers.
ExactPoint parse_point(std::string_view text);

/// The six numbers of a ray as parse_ray takes them.
std::string to_text(const ExactRay& ray);

}  // namespace lamina::geometry
