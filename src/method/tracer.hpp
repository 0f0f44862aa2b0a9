// Traces rays through a scene in one number type, by any method.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "method/method.hpp"
#include "method/report.hpp"
#include "number/algebraic.hpp"
#include "number/concepts.hpp"
#include "poly/solver.hpp"
#include "scene/scene.hpp"

namespace lamina::method {

/// How far a computed hit is from the exact one.
struct HitError {
  double t_ulps = 0;      ///< |t - t*| in units in the last place of t* in this number type
  double point_rel = 0;   ///< largest coordinate error over the largest coordinate
  double normal_rad = 0;  ///< angle between the normals
};

/// One scene in one number type. Not for two threads at once: each thread has its own.
class Tracer {
 public:
  virtual ~Tracer() = default;

  /// Finds the crossings of a ray; run and explain then use them.
  virtual void find(const geometry::ExactRay& ray) = 0;
  /// What the method sees of the ray last found.
  virtual void run(const Method& method, Report& report) = 0;
  /// The same, with every event as it is processed.
  virtual std::vector<EventRecord> explain(const Method& method, Report& report) = 0;

  /// The crossings in the order of this number type: by t, ties by leaf index, those of one leaf as
  /// its root finder gives them.
  [[nodiscard]] virtual std::span<const CrossingId> crossings() const = 0;
  /// The state that the method starts the leaf in, if it carries states.
  [[nodiscard]] virtual bool starts_inside(const Method& method, csg::LeafIndex leaf) const = 0;
  [[nodiscard]] virtual bool in_some_carrier() const = 0;
  /// Is f <= 0 for the leaf at the rounded point of a crossing, or of kStart?
  [[nodiscard]] virtual bool inside_at(csg::LeafIndex leaf, std::size_t crossing) const = 0;
  /// Stands for the start of the ray where a crossing is asked for.
  static constexpr std::size_t kStart = SIZE_MAX;
  /// The double nearest to the crossing's t.
  [[nodiscard]] virtual double t(std::size_t crossing) const = 0;
  /// Sorts the crossings of the ray last found anew, ties of t by rank[leaf] instead of by leaf
  /// index: what the scene would give with its leaves in another order.
  virtual void reorder(std::span<const csg::LeafIndex> rank) = 0;
  /// Are two crossings at the same t in this number type?
  [[nodiscard]] virtual bool equal_t(std::size_t a, std::size_t b) const = 0;
  /// The error of a crossing whose exact t is known; zero for exact numbers.
  [[nodiscard]] virtual HitError error(std::size_t crossing, const number::Root& truth) const = 0;

  /// The medium at a point, each leaf by f <= 0 at the rounded point; on exact numbers that of
  /// locate_exact. Needs no ray.
  [[nodiscard]] virtual csg::Medium medium_at(const geometry::ExactPoint& point) const = 0;
};

template <number::RealNumber Number>
std::unique_ptr<Tracer> make_tracer(const scene::Scene& scene, const poly::Solvers& solvers);

}  // namespace lamina::method
