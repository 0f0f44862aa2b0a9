#include "census/spawned_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lamina::census {

SpawnedTruth::SpawnedTruth(const scene::Scene& scene)
    : scene_(scene), events_(scene), state_(scene.tree), by_leaf_(scene.leaves.size()) {}

bool SpawnedTruth::find(const method::ExactStart& start, const geometry::ExactPoint& direction) {
  classes_.clear();
  coincident_.clear();
  for (auto& classes : by_leaf_) {
    classes.clear();
  }
  if (!events_.find(start, direction)) {
    return false;
  }
  start_carriers_ = start.carriers;
  state_.reset([this](csg::LeafIndex leaf) { return events_.starts_inside(leaf); });
  start_ = state_.medium();
  for (const method::SpawnedClass& at : events_.classes()) {
    const std::vector<csg::LeafIndex>& leaves = scene_.leaves_of_carrier[at.carrier];
    std::vector<trace::CoincidentEvent> events;
    for (const csg::LeafIndex leaf : leaves) {
      events.push_back({leaf, !state_.inside(leaf)});
      by_leaf_[leaf].push_back(static_cast<std::uint32_t>(classes_.size()));
    }
    coincident_.push_back(std::move(events));
    classes_.push_back({csg::classify_class(scene_.tree, state_, leaves), at.s});
  }
  return true;
}

bool SpawnedTruth::starts_on(csg::LeafIndex leaf) const {
  return std::binary_search(start_carriers_.begin(), start_carriers_.end(),
                            scene_.leaves[leaf].carrier);
}

std::vector<trace::CoincidentEvent> events_of(const Truth& truth, const TruthClass& cls) {
  std::vector<trace::CoincidentEvent> events;
  for (std::size_t i = 0; i < cls.leaves.size(); ++i) {
    const auto& crossing = truth.crossings()[cls.first_crossing + i];
    events.push_back({crossing.leaf, crossing.enters_by_parity});
  }
  return events;
}

namespace {

// What a crossing of a leaf is in truth: a class, or the surface that the ray starts on.
struct Match {
  std::optional<std::uint32_t> cls;
  bool is_start = false;
};

Match match(const SpawnedTruth& truth, csg::LeafIndex leaf, double t) {
  Match nearest;
  double least = INFINITY;
  if (truth.starts_on(leaf)) {
    nearest.is_start = true;
    least = std::abs(t);
  }
  for (const std::uint32_t cls : truth.classes_of(leaf)) {
    if (const double distance = std::abs(t - truth.classes()[cls].s); distance < least) {
      nearest = {cls, false};
      least = distance;
    }
  }
  return nearest;
}

// Why is an interface of the truth not reported?
Artifact why_missed(const SpawnedTruth& truth, const trace::RayPath& path, std::uint32_t cls) {
  bool behind = false;
  const auto& owners = truth.classes()[cls].effect.owners;
  for (std::size_t i = 0; i < path.crossings().size(); ++i) {
    const method::CrossingId& crossing = path.crossings()[i];
    if (std::find(owners.begin(), owners.end(), crossing.leaf) == owners.end() ||
        match(truth, crossing.leaf, path.t(i)).cls != cls) {
      continue;
    }
    if (crossing.ahead) {
      return Artifact::MissedLogic;
    }
    behind = true;
  }
  return behind ? Artifact::MissedRange : Artifact::MissedSolver;
}

Artifact wrong_medium(csg::Medium truth, csg::Medium said) {
  return truth == csg::kEmpty  ? Artifact::GhostMaterial
         : said == csg::kEmpty ? Artifact::Void
                               : Artifact::WrongMedium;
}

}  // namespace

Verdict judge_spawned(const SpawnedTruth& truth, const trace::RayPath& path,
                      const method::Report& report, double range) {
  Verdict verdict;
  const auto& classes = truth.classes();
  const auto first = std::find_if(classes.begin(), classes.end(),
                                  [](const SpawnedTruthClass& c) { return c.is_interface(); });
  const bool there = first != classes.end() && first->s < range;
  const auto true_class = static_cast<std::uint32_t>(first - classes.begin());

  if (report.start != truth.start()) {
    ++verdict[wrong_medium(truth.start(), report.start)];
  }
  const bool reported =
      !report.interfaces.empty() && path.t(report.interfaces.front().crossing) < range;
  bool found = false;
  if (reported) {
    const method::Interface& interface = report.interfaces.front();
    const csg::LeafIndex leaf = path.crossings()[interface.crossing].leaf;
    const Match matched = match(truth, leaf, path.t(interface.crossing));
    found = there && matched.cls == true_class;
    if (matched.is_start) {
      ++verdict[Artifact::SelfIntersection];
    } else if (!matched.cls || !classes[*matched.cls].is_interface()) {
      ++verdict[Artifact::GhostHit];
    } else if (found) {
      const auto& effect = first->effect;
      if (std::find(effect.owners.begin(), effect.owners.end(), leaf) == effect.owners.end()) {
        ++verdict[Artifact::GhostSurface];
      } else if (interface.transition != effect.transition) {
        ++verdict[Artifact::WrongInterface];
      }
    }
  }
  if (there && !found) {
    ++verdict[why_missed(truth, path, true_class)];
  }
  const bool first_right = reported == there && (!there || found) &&
                           verdict[Artifact::GhostSurface] == 0 &&
                           verdict[Artifact::WrongInterface] == 0;
  verdict[Artifact::FirstWrong] = first_right ? 0 : 1;
  return verdict;
}

}  // namespace lamina::census
