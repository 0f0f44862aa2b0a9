// Many rays by many methods in many number types against the truth: counts.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "census/verdict.hpp"
#include "method/tracer.hpp"

namespace lamina::census {

/// What is run: every method in every number type on the same rays.
struct Plan {
  std::vector<method::Method> methods;
  std::vector<method::NumberChoice> numbers;
  poly::Solvers solvers;
  int threads = 0;  ///< 0: as many as the machine has
};

/// A ray on which something is wrong, to be replayed.
struct WorstCase {
  std::string scene;  ///< as `lamina explain` takes it
  geometry::ExactRay ray;
  std::uint32_t artifacts = 0;  ///< kinds of artifacts that it shows
  double wrong_length = 0;
};

/// Counts of one method in one number type.
struct Cell {
  std::string method;
  std::string number;
  int significand_bits = 0;
  std::uint64_t rays = 0;                            ///< judged: those in no carrier
  std::array<std::uint64_t, kArtifactCount> with{};  ///< rays with at least one of each artifact
  double wrong_length = 0;
  std::uint32_t persistence = 0;  ///< the largest
  std::uint64_t lamina_fronts = 0;
  std::uint64_t lamina_fronts_seen = 0;
  std::uint64_t lamina_backs = 0;
  std::uint64_t lamina_backs_seen = 0;
  method::HitError largest;  ///< of the first hits that are right
  std::optional<WorstCase> worst;

  [[nodiscard]] std::uint64_t operator[](Artifact a) const {
    return with[static_cast<std::size_t>(a)];
  }
  void add(const Verdict& verdict);
  /// Adds the counts of later rays.
  void merge(const Cell& later);
};

/// The result: a cell for each method and number type, methods outermost.
struct Census {
  std::vector<Cell> cells;
  std::uint64_t rays = 0;              ///< all rays
  std::uint64_t in_carrier = 0;        ///< of them in a carrier: counted apart, not judged
  std::uint64_t with_coincidence = 0;  ///< judged, with an exact class of two leaves or more ahead
  bool interrupted = false;            ///< stopped early; the counts are of whole tasks

  /// Adds the counts of later rays, by the same methods in the same number types.
  void merge(const Census& later);
};

/// One unit of work: a scene and rays through it. A task depends on nothing but its number.
struct Task {
  scene::Scene scene;
  std::vector<geometry::ExactRay> rays;
};

/// Called between batches of tasks: tasks done and in all; returns false to stop.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// Runs tasks 0 .. task_count-1 and adds up. The result does not depend on the threads:
/// tasks are independent and their counts are merged in order.
Census run_census(const Plan& plan, std::size_t task_count,
                  const std::function<Task(std::size_t)>& task, const Progress& progress);

}  // namespace lamina::census
