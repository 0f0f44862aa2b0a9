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
/// with few leaves, then with a short text and ray. It is tested as it reads back from the
/// text. The steps drop operands, maps and materials, state planes in world coordinates and cones by their apex,
/// shorten numbers, both wherever the same number stands and one by one, shorten the ray's
/// coordinates to fewer bits, and aim it anew; until none of them makes it smaller.
/// Deterministic, if `shows` is. `progress` is told how many leaves are gone, of all.
/// Contract: shows(scene, ray).
Case minimise(const scene::Scene& scene, const geometry::ExactRay& ray, const Shows& shows,
              const Progress& progress);

}  // namespace lamina::census
