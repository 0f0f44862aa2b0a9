// Paths down the ray tree, from the eye on, in one number type.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "method/method.hpp"
#include "method/report.hpp"
#include "number/concepts.hpp"
#include "poly/solver.hpp"
#include "scene/scene.hpp"
#include "trace/spawn.hpp"

namespace lamina::trace {

/// How far along a ray a method looks.
enum class Extent : std::uint8_t {
  FirstInterface,  ///< so that rays can be spawned there
  WholeRay,
};

/// Where a ray first meets an interface, as the number type holds it, each number rounded to
/// double.
struct PathHit {
  geometry::Vector3<double> point;
  geometry::Vector3<double> gradient;  ///< of the hit leaf's f, not normalised, not zero
};

/// A path down the ray tree: the present ray, and those that it is spawned from, each at its
/// first interface. Leaf states are the path's, not the CSG tree's. Not for two threads at once.
class RayPath {
 public:
  virtual ~RayPath() = default;

  /// Begins a path.
  virtual void start(const geometry::ExactRay& primary) = 0;

  /// What the method sees of the present ray.
  virtual void run(const method::Method& method, method::Report& report,
                   Extent extent = Extent::FirstInterface) = 0;
  /// The crossings of the ray last started or spawned, by t; those behind its start too.
  [[nodiscard]] virtual std::span<const method::CrossingId> crossings() const = 0;
  /// The double nearest to a crossing's t.
  [[nodiscard]] virtual double t(std::size_t crossing) const = 0;
  /// The first interface of the present ray's last run; none where it has none, or where its
  /// point or its gradient is beyond the number type's range.
  [[nodiscard]] virtual std::optional<PathHit> hit() const = 0;

  /// Makes the ray spawned at the present one's first interface the present one. Returns its
  /// direction as this number type holds it; none, and the present ray stays, if there is no
  /// hit, if the ray is beyond the number type's range, at total internal reflection of a
  /// transmitted ray, or where a shadow ray's light is behind the surface.
  virtual std::optional<geometry::ExactPoint> spawn(const method::Method& method,
                                                    const Spawn& spawn) = 0;
  /// Makes the ray that spawned the present one the present one again: only to spawn others.
  virtual void back() = 0;
};

template <number::RoundedNumber Number>
std::unique_ptr<RayPath> make_ray_path(const scene::Scene& scene, const poly::Solvers& solvers);

}  // namespace lamina::trace
