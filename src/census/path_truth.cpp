#include "census/path_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/contract.hpp"

namespace lamina::census {

PathTruth::PathTruth(const scene::Scene& scene)
    : scene_(scene), primary_(scene), state_(scene.tree) {
  levels_.emplace_back(scene);
}

PathTruth::Level& PathTruth::clear_level(std::size_t depth) {
  if (levels_.size() == depth) {
    levels_.emplace_back(scene_);
  }
  Level& level = levels_[depth];
  level.classes.clear();
  level.start_carriers.clear();
  level.next.reset();
  for (auto& classes : level.by_leaf) {
    classes.clear();
  }
  if (levels_.size() > depth + 1) {
    levels_[depth + 1].direction.reset();
  }
  return level;
}

void PathTruth::start(const geometry::ExactRay& primary) {
  ray_ = primary;
  depth_ = 0;
  primary_.find(primary);
  Level& level = clear_level(0);
  level.start = primary_.start();
  for (const TruthClass& cls : primary_.classes()) {
    for (const csg::LeafIndex leaf : cls.leaves) {
      level.by_leaf[leaf].push_back(static_cast<std::uint32_t>(level.classes.size()));
    }
    level.classes.push_back({cls.effect, nearest_double(primary_.t(cls)),
                             static_cast<std::uint32_t>(cls.leaves.size())});
  }
}

const PathClass* PathTruth::first() const {
  const auto& classes = present().classes;
  const auto found = std::find_if(classes.begin(), classes.end(),
                                  [](const PathClass& cls) { return cls.is_interface(); });
  return found == classes.end() ? nullptr : &*found;
}

const method::ExactStart& PathTruth::next_start() {
  Level& level = levels_[depth_];
  if (!level.next) {
    const PathClass* hit = first();
    LAMINA_REQUIRE(hit != nullptr, "rays are spawned at interfaces");
    const auto at = static_cast<std::size_t>(hit - level.classes.data());
    level.next = depth_ == 0 ? level.events.start_on(ray_, primary_.t(primary_.classes()[at]))
                             : level.events.start_on(at);
  }
  return *level.next;
}

bool PathTruth::spawn(const geometry::ExactPoint& direction) {
  const method::ExactStart& start = next_start();
  // Many methods spawn the same ray.
  if (levels_.size() == depth_ + 1 || levels_[depth_ + 1].direction != direction) {
    Level& level = clear_level(depth_ + 1);
    level.direction = direction;
    level.decided = level.events.find(start, direction);
    if (level.decided) {
      level.start_carriers = start.carriers;
      state_.reset([&level](csg::LeafIndex leaf) { return level.events.starts_inside(leaf); });
      level.start = state_.medium();
      for (const method::SpawnedClass& at : level.events.classes()) {
        const std::vector<csg::LeafIndex>& leaves = scene_.leaves_of_carrier[at.carrier];
        for (const csg::LeafIndex leaf : leaves) {
          level.by_leaf[leaf].push_back(static_cast<std::uint32_t>(level.classes.size()));
        }
        level.classes.push_back({csg::classify_class(scene_.tree, state_, leaves), at.s,
                                 static_cast<std::uint32_t>(leaves.size())});
      }
    }
  }
  const bool decided = levels_[depth_ + 1].decided;
  depth_ += decided ? 1 : 0;
  return decided;
}

void PathTruth::back() {
  LAMINA_REQUIRE(depth_ > 0, "a primary ray is spawned from none");
  --depth_;
}

bool PathTruth::starts_on(csg::LeafIndex leaf) const {
  return std::binary_search(present().start_carriers.begin(), present().start_carriers.end(),
                            scene_.leaves[leaf].carrier);
}

namespace {

// What a crossing of a leaf is in truth: a class, or the surface that the ray starts on.
struct Match {
  std::optional<std::uint32_t> cls;
  bool is_start = false;
};

// Through (leaf, which crossing of the leaf) where the ray has as many crossings ahead as in truth,
// or the start's besides; else by the least distance.
Match match(const PathTruth& truth, const trace::RayPath& path, std::size_t crossing) {
  const auto crossings = path.crossings();
  const csg::LeafIndex leaf = crossings[crossing].leaf;
  const auto classes = truth.classes_of(leaf);
  std::size_t ahead = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (crossings[i].leaf == leaf && crossings[i].ahead) {
      before += i < crossing ? 1 : 0;
      ++ahead;
    }
  }
  if (crossings[crossing].ahead) {
    if (ahead == classes.size()) {
      return {classes[before], false};
    }
    if (truth.starts_on(leaf) && ahead == classes.size() + 1) {
      return before == 0 ? Match{std::nullopt, true} : Match{classes[before - 1], false};
    }
  }
  const double t = path.t(crossing);
  Match nearest;
  double least = INFINITY;
  if (truth.starts_on(leaf)) {
    nearest.is_start = true;
    least = std::abs(t);
  }
  for (const std::uint32_t cls : classes) {
    if (const double distance = std::abs(t - truth.classes()[cls].s); distance < least) {
      nearest = {cls, false};
      least = distance;
    }
  }
  return nearest;
}

// Why is an interface of the truth not reported?
Artifact why_missed(const PathTruth& truth, const trace::RayPath& path, std::uint32_t cls) {
  bool behind = false;
  const auto& owners = truth.classes()[cls].effect.owners;
  for (std::size_t i = 0; i < path.crossings().size(); ++i) {
    const method::CrossingId& crossing = path.crossings()[i];
    if (std::find(owners.begin(), owners.end(), crossing.leaf) == owners.end() ||
        match(truth, path, i).cls != cls) {
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

double range_of(trace::Branch branch) {
  return branch == trace::Branch::Shadow ? 1 : std::numeric_limits<double>::infinity();
}

bool spawns_at_truth(const Verdict& verdict) {
  return verdict[Artifact::FirstWrong] == 0 || verdict[Artifact::WrongInterface] > 0 ||
         verdict[Artifact::GhostSurface] > 0;
}

Verdict judge_first(const PathTruth& truth, const trace::RayPath& path,
                    const method::Report& report, double range) {
  Verdict verdict;
  const auto& classes = truth.classes();
  const PathClass* first = truth.first();
  const bool there = first != nullptr && first->s < range;
  const auto true_class =
      there ? static_cast<std::uint32_t>(first - classes.data()) : std::uint32_t{0};

  if (report.start != truth.start_medium()) {
    ++verdict[wrong_medium(truth.start_medium(), report.start)];
  }
  const bool reported =
      !report.interfaces.empty() && path.t(report.interfaces.front().crossing) < range;
  bool found = false;
  if (reported) {
    const method::Interface& interface = report.interfaces.front();
    const csg::LeafIndex leaf = path.crossings()[interface.crossing].leaf;
    const Match matched = match(truth, path, interface.crossing);
    found = there && matched.cls == true_class;
    if (matched.is_start) {
      ++verdict[Artifact::SelfIntersection];
    } else if (!there || !matched.cls || !classes[*matched.cls].is_interface()) {
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
