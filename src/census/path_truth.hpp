// The truth along a path down the ray tree: each spawned ray's is conditional on the exact hit
// that it starts at.
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "census/truth.hpp"
#include "census/verdict.hpp"
#include "csg/coincidence.hpp"
#include "method/spawned_events.hpp"
#include "trace/ray_path.hpp"

namespace lamina::census {

/// Leaves that cross at one point of a ray, s > 0: all of exactly equal t on a primary ray; on a
/// spawned one all of one carrier, since different carriers are never found to be at equal s.
struct PathClass {
  csg::CoincidentClass effect;
  double s = 0;  ///< within 2^-60 max(1, s) of the exact place
  std::uint32_t events = 0;

  [[nodiscard]] bool is_interface() const { return effect.transition.from != effect.transition.to; }
};

/// What is true of one path after the other (design 1, secondary rays): the present ray, and
/// those that it is spawned from, each at its first interface.
class PathTruth {
 public:
  explicit PathTruth(const scene::Scene& scene);

  /// Begins a path.
  void start(const geometry::ExactRay& primary);
  /// Does the primary ray lie in a carrier?
  [[nodiscard]] bool in_some_carrier() const { return primary_.in_some_carrier(); }

  /// Makes the ray spawned at the present one's first interface the present one. Returns whether
  /// the whole of it is decided; if not, the present ray stays. Contract: there is an interface.
  bool spawn(const geometry::ExactPoint& direction);
  /// Makes the ray that spawned the present one the present one again.
  void back();
  /// Makes the primary ray the present one again.
  void rewind() { depth_ = 0; }

  /// The medium at s = 0+.
  [[nodiscard]] csg::Medium start_medium() const { return present().start; }
  /// Ascending s.
  [[nodiscard]] const std::vector<PathClass>& classes() const { return present().classes; }
  /// The first interface.
  [[nodiscard]] const PathClass* first() const;
  /// By the leaf: which classes it has an event in, ascending.
  [[nodiscard]] std::span<const std::uint32_t> classes_of(csg::LeafIndex leaf) const {
    return present().by_leaf[leaf];
  }
  /// Does the ray start on the leaf's surface?
  [[nodiscard]] bool starts_on(csg::LeafIndex leaf) const;

 private:
  struct Level {
    explicit Level(const scene::Scene& scene) : events(scene), by_leaf(scene.leaves.size()) {}

    method::SpawnedEvents events;                   // but for the primary ray
    std::optional<geometry::ExactPoint> direction;  // of the ray last spawned from its parent
    bool decided = false;
    csg::Medium start = csg::kEmpty;
    std::vector<PathClass> classes;
    std::vector<std::vector<std::uint32_t>> by_leaf;
    std::vector<surface::CarrierIndex> start_carriers;
    std::optional<method::ExactStart> next;  // where it spawns
  };

  [[nodiscard]] const Level& present() const { return levels_[depth_]; }
  Level& clear_level(std::size_t depth);
  const method::ExactStart& next_start();

  const scene::Scene& scene_;
  Truth primary_;
  geometry::ExactRay ray_;
  csg::RayState state_;
  std::deque<Level> levels_;  // from the primary ray down; those below depth_ are spare
  std::size_t depth_ = 0;
};

/// What a method in a number type says of the present ray up to its first interface, against the
/// truth. Artifacts of what lies before and at the first interface only; crossings are matched
/// with the leaf's exact ones, in order where there are as many ahead, or one more where the ray
/// starts on the leaf's surface, which is then the first, s = 0; else by the least distance in s.
///
/// Arguments: range  interfaces with s >= range do not count: 1 for a shadow ray, else infinity.
Verdict judge_first(const PathTruth& truth, const trace::RayPath& path,
                    const method::Report& report,
                    double range = std::numeric_limits<double>::infinity());

/// By such a verdict: is the interface at which the method spawns rays the truth's first one?
/// Its surface or its media may be wrong.
bool spawns_at_truth(const Verdict& verdict);

/// How far a ray of a branch counts: up to the light, or for ever.
double range_of(trace::Branch branch);

}  // namespace lamina::census
