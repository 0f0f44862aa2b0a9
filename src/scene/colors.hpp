// Colours by name, as in CSS and OpenSCAD.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "number/rational.hpp"

namespace lamina::scene {

/// Red, green, blue, alpha; from 0 to 1.
using Color = std::array<number::Rational, 4>;

/// The colour of a CSS name in any case, or of `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa`.
std::optional<Color> color_of_name(std::string_view name);

/// `[1, 0, 1/2, 1]`: equal texts for equal colours.
std::string canonical_text(const Color& color);

}  // namespace lamina::scene
