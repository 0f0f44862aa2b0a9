// Where a point is: the exact medium around it.
#pragma once

#include "geometry/vector.hpp"
#include "scene/scene.hpp"

namespace lamina::method {

/// The medium at a point, by what is around it in all directions: the regularized solid has
/// no faces without volume, and no walls inside.
struct Location {
  /// What all directions around the point share. On the boundary it is empty. Between
  /// materials it is the one that closed half-spaces give, so that the right operand of `add`
  /// wins; where they give none of those around, the one that the scene names last.
  csg::Medium medium = csg::kEmpty;
  /// Some directions lead into the solid and some out of it: certain where it is said.
  bool boundary = false;
  /// No boundary was found, but not all directions could be told apart.
  bool undecided = false;
};

/// Returns the location of a point in the ideal scene.
///
/// Exact. A point on no carrier has the medium of the tree. Around a point on carriers the
/// tangent planes cut space into cells, which are all looked at. They are not all where
/// curved carriers touch, where three surfaces meet along one tangent line, and where a
/// gradient is zero (the apex of a cone). There, cells to the second order in many directions
/// are looked at too: what they show is true, but if they agree, `undecided` is set. So it is where
/// a swept contour and another carrier that matters go through the point, but for flat sides.
/// Cost: the leaves that the tree asks for; O(k^3) for k tangent planes, less on the boundary.
Location locate_exact(const scene::Scene& scene, const geometry::ExactPoint& point);

}  // namespace lamina::method
