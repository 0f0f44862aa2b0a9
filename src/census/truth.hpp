// The truth along a ray: exact classes of events, their interfaces, owners and laminae.
#pragma once

#include <vector>

#include "csg/coincidence.hpp"
#include "method/ray_events.hpp"

namespace lamina::census {

/// All crossings of exactly equal t, t > 0.
struct TruthClass {
  std::vector<csg::LeafIndex> leaves;  ///< ascending
  csg::CoincidentClass effect;
  std::uint32_t first_crossing = 0;  ///< index into Truth::crossings() of its first event
  bool all_enter = false;
  bool all_leave = false;

  [[nodiscard]] bool is_interface() const { return effect.transition.from != effect.transition.to; }
};

/// One exact crossing of a leaf.
struct TruthCrossing {
  int cls = -1;  ///< index into Truth::classes(), -1 for t <= 0
  bool enters = false;
  std::uint32_t crossing = 0;  ///< index into Truth::crossings()
};

/// What is true of one ray after the other. The method `regularized` on the number type
/// `exact` gives the same interfaces; this keeps besides them what the census asks: which
/// events are in which class, who owns an interface, where laminae are.
class Truth {
 public:
  explicit Truth(const scene::Scene& scene);

  void find(const geometry::ExactRay& ray);

  [[nodiscard]] csg::Medium start() const { return start_; }
  [[nodiscard]] csg::Medium end() const { return end_; }
  [[nodiscard]] const std::vector<TruthClass>& classes() const { return classes_; }
  /// The leaf's state for t towards -infinity.
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf) const {
    return events_.starts_inside(leaf);
  }
  /// The leaf's crossings in order along the ray, t <= 0 included.
  [[nodiscard]] const std::vector<TruthCrossing>& crossings_of(csg::LeafIndex leaf) const {
    return by_leaf_[leaf];
  }
  [[nodiscard]] bool in_some_carrier() const { return events_.in_some_carrier(); }
  /// All exact crossings, t <= 0 included.
  [[nodiscard]] std::span<const method::Crossing<number::exact>> crossings() const {
    return events_.crossings();
  }
  /// Where a class is.
  [[nodiscard]] const number::Root& t(const TruthClass& cls) const {
    return events_.crossings()[cls.first_crossing].t;
  }

 private:
  const scene::Scene& scene_;
  method::RayEvents<number::exact> events_;
  csg::RayState state_;
  std::vector<TruthClass> classes_;
  std::vector<std::vector<TruthCrossing>> by_leaf_;
  csg::Medium start_ = csg::kEmpty;
  csg::Medium end_ = csg::kEmpty;
};

}  // namespace lamina::census
