// One path through the ray tree, from the eye on, in one number type.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "method/method.hpp"
#include "method/report.hpp"
#include "number/concepts.hpp"
#include "poly/line_roots.hpp"
#include "scene/scene.hpp"
#include "trace/spawn.hpp"

namespace lamina::trace {

/// An event of a class of exactly coincident ones.
struct CoincidentEvent {
  csg::LeafIndex leaf = 0;
  bool enters = false;
};

/// The present ray of a path, and how it goes on. Leaf states are the path's, not the tree's.
/// Not for two threads at once.
class RayPath {
 public:
  virtual ~RayPath() = default;

  /// Begins a path.
  virtual void start(const geometry::ExactRay& primary) = 0;

  /// What the method sees of the present ray up to its first interface.
  virtual void run(const method::Method& method, method::Report& report) = 0;
  /// The present ray's crossings, by t; those behind the start too.
  [[nodiscard]] virtual std::span<const method::CrossingId> crossings() const = 0;
  /// The double nearest to a crossing's t.
  [[nodiscard]] virtual double t(std::size_t crossing) const = 0;

  /// Makes the ray spawned at the first interface of the last run the present one. Returns its
  /// direction as this number type holds it; none if there is no interface, if its point is
  /// beyond the number type's range, or at total internal reflection of a transmitted ray.
  ///
  /// Arguments: coincident  the exact class of events at the hit, for Secondary::Cluster.
  virtual std::optional<geometry::ExactPoint> spawn(
      const method::Method& method, const Spawn& spawn,
      std::span<const CoincidentEvent> coincident) = 0;
};

template <number::RoundedNumber Number>
std::unique_ptr<RayPath> make_ray_path(const scene::Scene& scene, const poly::Solvers& solvers);

}  // namespace lamina::trace
