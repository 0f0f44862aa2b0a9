// Shrinking a scene and a ray on which something is wrong, while the same stays wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "census/census.hpp"

namespace lamina::census {

/// What is wrong with one ray, in one word.
struct Symptom {
  bool first_wrong = false;                ///< what a picture shows is wrong
  Artifact artifact = Artifact::GhostHit;  ///< of the wrong interface nearest to the start
  bool in_exact = false;  ///< the method shows the same in exact numbers: it is not rounding

  friend bool operator==(const Symptom&, const Symptom&) = default;
};

/// Returns what is wrong with a ray; nothing if it is right, or lies in a carrier. Where no
/// interface is wrong, the artifact is the first of those counted, in their order.
std::optional<Symptom> symptom(const scene::Scene& scene, const geometry::ExactRay& ray,
                               const method::Method& method, const method::NumberChoice& number,
                               const poly::Solvers& solvers);

/// A scene, as its text reads, and a ray.
struct Case {
  std::string text;  ///< as scene::text_of writes it
  scene::Scene scene;
  geometry::ExactRay ray;
};

using Shows = std::function<bool(const scene::Scene&, const geometry::ExactRay&)>;

/// Returns a case as small as steps of one kind at a time make it, on which `shows` holds still:
/// with few leaves, then with a short text and ray. It is tested as it reads back from the
/// text. The steps drop operands, maps and materials, state planes in world coordinates,
/// shorten numbers, both wherever the same number stands and one by one, shorten the ray's
/// coordinates to fewer bits, and aim it anew; until none of them makes it smaller.
/// Deterministic, if `shows` is. `progress` is told how many leaves are gone, of all.
/// Contract: shows(scene, ray).
Case minimise(const scene::Scene& scene, const geometry::ExactRay& ray, const Shows& shows,
              const Progress& progress);

}  // namespace lamina::census
