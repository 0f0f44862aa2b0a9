// Many rays by many methods in many number types against the truth: counts.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "census/attribution.hpp"
#include "census/verdict.hpp"
#include "method/tracer.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {

/// What is run: every method in every number type on the same rays.
struct Plan {
  std::vector<method::Method> methods;
  std::vector<trace::NumberChoice> numbers;
  poly::Solvers solvers;
  int threads = 0;                   ///< 0: as many as the machine has
  std::uint32_t random_orders = 24;  ///< of the leaves, where too many tie to try all orders
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
  std::uint64_t rays = 0;         ///< judged: those in no carrier
  std::uint64_t not_spawned = 0;  ///< paths that were wrong, or ended, before the ray to judge
  std::uint64_t undecided = 0;    ///< spawned rays whose truth no precision tried has decided
  std::array<std::uint64_t, kArtifactCount> with{};  ///< rays with at least one of each artifact
  std::array<std::uint64_t, kCauseCount> caused{};   ///< rays that are first wrong, by cause
  std::uint64_t order_sensitive = 0;                 ///< rays whose answer hangs on leaf order
  std::uint32_t most_outcomes = 1;                   ///< different answers to one ray, at most
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

/// Two methods on the same rays in one number type: the rays on which only one of them has
/// its first visible interface wrong.
struct Pair {
  std::string number;
  std::string first;
  std::string second;
  std::uint64_t only_first_wrong = 0;
  std::uint64_t only_second_wrong = 0;
};

/// The result: a cell for each method and number type, methods outermost; and a pair for each
/// number type and two methods.
struct Census {
  std::vector<Cell> cells;
  std::vector<Pair> pairs;
  std::uint64_t rays = 0;              ///< all rays
  std::uint64_t in_carrier = 0;        ///< of them in a carrier: counted apart, not judged
  std::uint64_t with_coincidence = 0;  ///< judged, with an exact class of two leaves or more ahead
  bool interrupted = false;            ///< stopped early; the counts are of whole tasks

  /// Adds the counts of later rays, by the same methods in the same number types.
  void merge(const Census& later);
};

/// What sets a census apart from others of its run: a word, a whole number or a real one.
using Label = std::variant<std::string, std::uint64_t, double>;

/// One unit of work: a scene and rays through it. A task depends on nothing but its number.
struct Task {
  scene::Scene scene;
  std::vector<geometry::ExactRay> rays;
  /// What each ray spawns in turn, at first interfaces. The last one spawned is judged, if the
  /// first interfaces of those before it are where the truth's are; if there are none, the ray
  /// itself.
  std::vector<trace::Spawn> spawns{};
};
using TaskMaker = std::function<Task(std::size_t)>;

/// Counts one ray's pairs in number type `number`: wrong[m] says whether method m has its first
/// visible interface wrong. Methods that are not judged on the ray are in no pair.
void count_pairs(Census& census, std::size_t number, const std::vector<std::optional<bool>>& wrong);

/// No rays yet: the cells and pairs of the plan.
Census empty_census(const Plan& plan);

/// Runs tasks first .. last-1 in parallel and adds up. The result does not depend on the
/// threads: tasks are independent and their counts are merged in order.
Census run_tasks(const Plan& plan, std::size_t first, std::size_t last, const TaskMaker& task);

/// Tasks are run by so many: that bounds the memory, and is where progress shows, a run can
/// stop, and what is done is kept.
inline constexpr std::size_t kTasksPerBlock = 32;

/// Called between blocks of tasks: tasks done and in all; returns false to stop.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// Runs tasks 0 .. task_count-1, block after block, and adds up.
Census run_census(const Plan& plan, std::size_t task_count, const TaskMaker& task,
                  const Progress& progress);

}  // namespace lamina::census
