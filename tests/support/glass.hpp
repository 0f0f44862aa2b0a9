// The wine glass of data/scenes/hashimoto_figure2.csg, as points and arcs.
#pragma once

#include <array>
#include <vector>

#include "geometry/conic_spline.hpp"

namespace lamina::geometry {

/// Fourteen points: up the foot, the stem and the bowl to the rim, and down inside to the axis.
inline std::vector<PlanePoint> glass_points() {
  std::vector<PlanePoint> points;
  for (const auto& [x, y] : std::array<std::array<int, 2>, 14>{{{360, 0},
                                                                {340, 20},
                                                                {120, 60},
                                                                {50, 140},
                                                                {40, 400},
                                                                {50, 700},
                                                                {220, 820},
                                                                {330, 1000},
                                                                {380, 1250},
                                                                {390, 1600},
                                                                {355, 1250},
                                                                {300, 1000},
                                                                {190, 840},
                                                                {0, 760}}}) {
    points.push_back({number::Rational(x, 100), number::Rational(y, 100)});
  }
  return points;
}

/// Half a circle at the rim.
inline std::vector<ArcAt> glass_arcs() { return {{10, number::Rational(1, 10), 0}}; }

}  // namespace lamina::geometry
