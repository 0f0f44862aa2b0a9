#include "census/truth.hpp"

#include <algorithm>

namespace lamina::census {

Truth::Truth(const scene::Scene& scene)
    : scene_(scene), events_(scene, {}), state_(scene.tree), by_leaf_(scene.leaves.size()) {}

void Truth::find(const geometry::ExactRay& ray) {
  using Events = method::RayEvents<number::exact>;
  events_.find(ray);
  classes_.clear();
  for (auto& crossings : by_leaf_) {
    crossings.clear();
  }
  state_.reset([this](csg::LeafIndex leaf) { return events_.starts_inside(leaf); });
  start_ = state_.medium();

  const auto crossings = events_.crossings();
  for (std::size_t first = 0; first < crossings.size();) {
    const bool ahead = Events::positive(crossings[first].t);
    const int index = ahead ? static_cast<int>(classes_.size()) : -1;
    TruthClass cls;
    cls.first_crossing = static_cast<std::uint32_t>(first);
    cls.all_enter = cls.all_leave = true;
    std::size_t end = first;
    for (; end < crossings.size() && !Events::less(crossings[first].t, crossings[end].t); ++end) {
      const auto& crossing = crossings[end];
      cls.leaves.push_back(crossing.leaf);
      cls.all_enter = cls.all_enter && crossing.enters_by_parity;
      cls.all_leave = cls.all_leave && !crossing.enters_by_parity;
      by_leaf_[crossing.leaf].push_back(
          {index, crossing.enters_by_parity, static_cast<std::uint32_t>(end)});
    }
    cls.effect = csg::classify_class(scene_.tree, state_, cls.leaves);
    if (ahead) {
      classes_.push_back(std::move(cls));
    } else {
      start_ = state_.medium();
    }
    first = end;
  }
  end_ = state_.medium();
}

}  // namespace lamina::census
