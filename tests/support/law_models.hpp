// Models with rays that laws are tried on: random lattice scenes and the family of coincident
// faces.
#pragma once

#include <string>
#include <vector>

#include "scene/families.hpp"
#include "scene/rays.hpp"
#include "support/reference_random.hpp"
#include "support/truth_bench.hpp"

namespace lamina::support {

struct LawModel {
  std::string name;             ///< replays it
  std::string text;             ///< one object
  reference::RandomScene data;  ///< of a lattice scene
  std::vector<geometry::ExactRay> rays;
};

/// Half of the rays are of floats, half go through vertices, edges and along faces.
inline LawModel lattice_model(std::uint64_t seed, std::uint64_t case_id, std::uint64_t rays,
                              const reference::SceneChoices& choices = {}) {
  base::SeededStream stream("laws/lattice", seed, case_id);
  LawModel model;
  model.name = "lattice " + std::to_string(seed) + " " + std::to_string(case_id);
  model.data = reference::random_scene(stream, choices);
  model.text = reference::text_of(model.data.root);
  for (std::uint64_t i = 0; i < rays; ++i) {
    model.rays.push_back(exact_ray(i % 2 == 0 ? reference::special_ray(stream, model.data)
                                              : reference::float_ray(stream, model.data)));
  }
  return model;
}

/// A member of scene::coincident_faces, with rays at the patches where its faces coincide.
inline LawModel family_model(std::uint64_t seed, std::uint64_t case_id, std::uint64_t rays) {
  base::SeededStream stream("laws/family", seed, case_id);
  const scene::FamilyMember member = scene::coincident_faces(seed, case_id);
  LawModel model;
  model.name = scene::family_spelling("coincident-faces", seed, case_id);
  model.text = member.text;
  for (std::uint64_t i = 0; i < rays; ++i) {
    const auto& patch = member.patches[stream.below(member.patches.size())];
    const double u = stream.unit();
    const double v = stream.unit();
    const double distance = stream.uniform(0, 20);
    model.rays.push_back(
        scene::ray_through(patch.corner + u * patch.side1 + v * patch.side2, distance, stream));
  }
  return model;
}

/// `operation() { operands }`
inline std::string node_text(const std::string& operation,
                             const std::vector<std::string>& operands) {
  std::string text = operation + "() {\n";
  for (const std::string& operand : operands) {
    text += operand;
  }
  return text + "}\n";
}

}  // namespace lamina::support
