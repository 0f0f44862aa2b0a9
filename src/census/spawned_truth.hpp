// The truth along a spawned ray, conditional on the exact hit that it starts at.
#pragma once

#include <span>
#include <vector>

#include "census/truth.hpp"
#include "census/verdict.hpp"
#include "csg/coincidence.hpp"
#include "method/spawned_events.hpp"
#include "trace/ray_path.hpp"

namespace lamina::census {

/// All leaves of one carrier at one of its roots, s > 0.
struct SpawnedTruthClass {
  csg::CoincidentClass effect;
  double s = 0;  ///< nearest to the root but for its last bits

  [[nodiscard]] bool is_interface() const { return effect.transition.from != effect.transition.to; }
};

/// What is true of one spawned ray after the other (design 1, secondary rays).
class SpawnedTruth {
 public:
  explicit SpawnedTruth(const scene::Scene& scene);

  /// Returns whether the whole ray is decided; if not, there is nothing to ask for.
  bool find(const method::ExactStart& start, const geometry::ExactPoint& direction);

  [[nodiscard]] csg::Medium start() const { return start_; }
  /// Ascending s.
  [[nodiscard]] const std::vector<SpawnedTruthClass>& classes() const { return classes_; }
  /// By the leaf: which classes it has an event in, ascending.
  [[nodiscard]] std::span<const std::uint32_t> classes_of(csg::LeafIndex leaf) const {
    return by_leaf_[leaf];
  }
  /// Does the ray start on the leaf's surface?
  [[nodiscard]] bool starts_on(csg::LeafIndex leaf) const;

  /// For the ray that is spawned at a class of this one.
  [[nodiscard]] method::ExactStart start_on(std::size_t cls) const { return events_.start_on(cls); }
  [[nodiscard]] const std::vector<trace::CoincidentEvent>& events_of(std::size_t cls) const {
    return coincident_[cls];
  }

 private:
  const scene::Scene& scene_;
  method::SpawnedEvents events_;
  csg::RayState state_;
  std::vector<surface::CarrierIndex> start_carriers_;
  std::vector<SpawnedTruthClass> classes_;
  std::vector<std::vector<trace::CoincidentEvent>> coincident_;  // by class
  std::vector<std::vector<std::uint32_t>> by_leaf_;
  csg::Medium start_ = csg::kEmpty;
};

/// The events of a class of a primary ray.
std::vector<trace::CoincidentEvent> events_of(const Truth& truth, const TruthClass& cls);

/// What a method in a number type says of a spawned ray up to its first interface, against the
/// truth. Artifacts of what lies before and at the first interface only; crossings are matched
/// with the leaf's exact ones, or with s = 0 where the ray starts on its surface, by the least
/// distance in s.
///
/// Arguments: range  interfaces with s >= range do not count: 1 for a shadow ray, else infinity.
Verdict judge_spawned(const SpawnedTruth& truth, const trace::RayPath& path,
                      const method::Report& report, double range);

}  // namespace lamina::census
