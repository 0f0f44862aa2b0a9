// The exact events of a ray, as text.
#pragma once

#include <string>

#include "census/truth.hpp"
#include "report/legend.hpp"

namespace lamina::report {

/// The truth of a ray: its events ahead of the start in exact order, those of equal t in
/// brackets, with the media behind them; then touches, carriers that the ray lies in, and what
/// is behind the start. Events of leaves that the legend does not show are counted only.
std::string truth_text(const scene::Scene& scene, const geometry::ExactRay& ray,
                       const census::Truth& truth, const Legend& legend);

/// The left edge of row `row` of `count` rows that belong together.
std::string bracket(std::size_t row, std::size_t count);

}  // namespace lamina::report
