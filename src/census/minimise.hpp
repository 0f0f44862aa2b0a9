// Shrinking a scene and a ray on which something is wrong, while the same stays wrong.
#pragma once

#include <functional>
#include <string>

#include "census/census.hpp"

namespace lamina::census {

/// A scene, as its text reads, and a ray.
struct Case {
  std::string text;  ///< as scene::text_of writes it
  scene::Scene scene;
  geometry::ExactRay ray;
};

using Shows = std::function<bool(const scene::Scene&, const geometry::ExactRay&)>;

/// Returns a case as small as steps of one kind at a time make it, on which `shows` holds still:
/// with few leaves, then with a short text and ray. Each is tested as it reads back from its
/// text. The steps drop operands, maps and materials; state leaves without their frames; shorten
/// numbers, wherever the same one stands, sums together with what they add, and one by one;
/// shorten the ray's coordinates to fewer bits; and aim it anew; until none makes it smaller.
/// No new difficulty comes in: number types that hold a number or the ray hold what stands for
/// it, and the ray does not start on a surface, touch one or go through an edge unless the
/// given one does. Deterministic, if `shows` is. `progress` is told how many leaves are gone, of
/// all; where it stops, the smallest case so far is returned.
/// Contract: shows(scene, ray).
Case minimise(const scene::Scene& scene, const geometry::ExactRay& ray, const Shows& shows,
              const Progress& progress);

}  // namespace lamina::census
