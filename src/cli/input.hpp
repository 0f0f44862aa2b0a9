// Ray and point files, and rays and sizes on the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"
#include "trace/camera.hpp"

namespace lamina::cli {

/// One ray a line: six numbers (decimal or a/b) separated by blanks or commas; `#` begins a
/// comment. Exact. Throws base::InputError with file and line.
std::vector<geometry::ExactRay> read_rays(const std::string& path);

/// Likewise points, three numbers a line.
std::vector<geometry::ExactPoint> read_points(const std::string& path);

/// "ox oy oz dx dy dz".
geometry::ExactRay parse_ray(std::string_view text);

/// "WxH", as in 640x480.
trace::ImageSize parse_size(const std::string& text);

}  // namespace lamina::cli
