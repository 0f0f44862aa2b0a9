// Random scenes in which surfaces coincide, touch and meet in edges, and rays at them.
//
// All solids of a scene stand on one lattice of a rational step, with so few choices of place
// and size that shared faces, common edges, tangent spheres and cylinders and equal surfaces
// come up by themselves. Each reaches its place by its own detour of maps that cancel, and the
// whole lattice is turned, scaled, moved and mirrored.
#pragma once

#include "base/seeded_stream.hpp"
#include "support/reference_ray.hpp"

namespace lamina::reference {

struct RandomScene {
  Node root;
  Chain frame;  ///< from lattice to world: part of the chain of every solid
  Rational step = 1;
};

struct SceneChoices {
  bool tori = false;
  bool one_material = false;
  bool touching = false;  ///< among the solids are a sphere and a cylinder that touch in a circle
};
RandomScene random_scene(base::SeededStream& stream, const SceneChoices& choices);

/// Two or more random operands in random operators, nested as comes.
Node random_tree(base::SeededStream& stream, const std::vector<Node>& solids);

/// A map of the whole space that is no identity: any kind of step.
Chain random_frame(base::SeededStream& stream);

/// A ray of float coordinates through the lattice, from inside or outside.
Ray float_ray(base::SeededStream& stream, const RandomScene& scene);

/// A rational ray through a vertex, an edge or a point of the lattice or of one of its
/// circles: along a line of the lattice, or to another such point; or one through the middle
/// of a solid.
Ray special_ray(base::SeededStream& stream, const RandomScene& scene);

/// The same ray after a map of the world.
Ray mapped(const Chain& chain, const Ray& ray);

}  // namespace lamina::reference
