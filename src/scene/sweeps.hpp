// Swept contours in the scene language: a sweep's node has the contour for its child.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "geometry/contour.hpp"
#include "geometry/trajectory.hpp"
#include "scene/arguments.hpp"
#include "scene/solid.hpp"

namespace lamina::scene {

/// The contours of a scene: equal ones are one.
using SharedContours = std::vector<std::shared_ptr<const geometry::Contour>>;

/// What a sweep is applied to: `contour`, or OpenSCAD's `polygon` and `square`. Errors are the
/// figure's node's, with the number of the point that is at fault.
class PlaneFigure {
 public:
  static bool is_one(std::string_view name);

  /// Throws base::InputError if the node is none. Keeps references to all three.
  PlaneFigure(const Source& source, const Node& node, SharedContours& contours);

  [[nodiscard]] std::shared_ptr<const geometry::Contour> contour() const;
  /// For what makes a curve of its own of them: the figure must not state a kind.
  [[nodiscard]] std::vector<geometry::PlanePoint> points() const;
  /// For what goes through space: the figure must be a `contour`, whose points have three
  /// coordinates then.
  [[nodiscard]] std::shared_ptr<const geometry::Trajectory> trajectory() const;

 private:
  const Source& source_;
  const Node& node_;
  SharedContours& contours_;
};

struct SweepNode {
  std::string_view name;
  Signature signature;
  /// Errors of the arguments, and those of a contour that cannot be swept like this, are its own.
  Solid (*read)(const Arguments& arguments, const PlaneFigure& figure);
  bool is_extrusion = false;  ///< OpenSCAD's, which may have nothing to extrude
};

/// The sweep of that name, or null.
const SweepNode* find_sweep(std::string_view name);

}  // namespace lamina::scene
