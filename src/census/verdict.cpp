#include "census/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina::census {
namespace {

bool owns(csg::LeafIndex leaf, const TruthClass& cls) {
  const auto& owners = cls.effect.owners;
  return std::find(owners.begin(), owners.end(), leaf) != owners.end();
}

void count_lamina(const TruthClass& cls, bool seen, Verdict& verdict) {
  if (cls.effect.lamina) {
    verdict.lamina_fronts += cls.all_enter ? 1 : 0;
    verdict.lamina_fronts_seen += cls.all_enter && seen ? 1 : 0;
    verdict.lamina_backs += cls.all_leave ? 1 : 0;
    verdict.lamina_backs_seen += cls.all_leave && seen ? 1 : 0;
  }
}

double middle(const number::Root& root) { return root.lower() + (root.upper() - root.lower()) / 2; }

}  // namespace

const std::array<ArtifactText, kArtifactCount>& artifact_texts() {
  static const std::array<ArtifactText, kArtifactCount> texts{{
      {"first_wrong", "first wrong",
       "The first visible interface is missing, invented, in another class, of a leaf that does "
       "not own it, or between other media than in truth: what a picture shows."},
      {"missed_solver", "missed: solver",
       "An interface of the truth is not reported, and a root of an owner was not found."},
      {"missed_logic", "missed: logic",
       "An interface of the truth is not reported although all roots of its owners were found."},
      {"missed_range", "missed: range",
       "An interface of the truth is not reported because its roots came out at t <= 0."},
      {"epsilon_hole", "eps-hole",
       "A missed hit that the method misses in exact arithmetic too: epsilon's own error."},
      {"ghost_hit", "ghost hit", "An interface is reported where the truth has none."},
      {"ghost_surface", "ghost surface",
       "The reported leaf is not in the owner set of the interface (W&T Figure 4)."},
      {"wrong_interface", "wrong interface",
       "The interface is there, but between other media than in truth."},
      {"ghost_material", "ghost material",
       "On an exact open interval between classes the method sees a material where nothing is."},
      {"void", "void", "On an exact open interval the method sees nothing where a material is."},
      {"wrong_medium", "wrong medium",
       "On an exact open interval the method sees another material than is there."},
      {"inconsistent", "inconsistent",
       "An enter while IN or a leave while OUT ahead of the start, or a wrong medium at the end "
       "of the ray."},
      {"wrong_count", "wrong count", "Some leaf has another number of crossings than in truth."},
      {"wrong_parity", "wrong parity",
       "Some leaf's number of crossings differs from the truth's by an odd number."},
      {"self_intersection", "self-intersection",
       "The first interface of a spawned ray is the surface that it starts on, where it starts."},
  }};
  return texts;
}

bool Verdict::right() const {
  return std::all_of(count.begin(), count.end(), [](std::uint32_t c) { return c == 0; });
}

bool Verdict::missed() const {
  return (*this)[Artifact::MissedSolver] + (*this)[Artifact::MissedLogic] +
             (*this)[Artifact::MissedRange] >
         0;
}

Judge::Judge(const Truth& truth, const method::Tracer& tracer, std::size_t leaf_count)
    : truth_(truth), tracer_(tracer), by_leaf_(leaf_count) {}

void Judge::match() {
  const auto crossings = tracer_.crossings();
  class_of_.assign(crossings.size(), kUnmatched);
  tracer_crossing_.assign(truth_.crossings().size(), kNoCrossing);
  wrong_counts_ = wrong_parities_ = 0;
  measured_.reset();
  for (auto& indices : by_leaf_) {
    indices.clear();
  }
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    by_leaf_[crossings[i].leaf].push_back(i);
  }
  for (csg::LeafIndex leaf = 0; leaf < by_leaf_.size(); ++leaf) {
    match_leaf(leaf);
  }
}

void Judge::match_leaf(csg::LeafIndex leaf) {
  const std::vector<std::uint32_t>& found = by_leaf_[leaf];
  const std::vector<TruthCrossing>& truth = truth_.crossings_of(leaf);
  const auto pair = [&](std::size_t i, std::size_t j) {
    class_of_[found[i]] = truth[j].cls;
    tracer_crossing_[truth[j].crossing] = found[i];
  };
  if (found.size() == truth.size()) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      pair(i, i);
    }
    return;
  }
  ++wrong_counts_;
  wrong_parities_ += (found.size() + truth.size()) % 2 == 1 ? 1 : 0;

  // best[i][j]: most pairs, then least distance, among the first i found and j true ones.
  struct Score {
    int pairs = 0;
    double distance = 0;
    [[nodiscard]] bool better(const Score& other) const {
      return pairs != other.pairs ? pairs > other.pairs : distance < other.distance;
    }
  };
  std::vector<std::vector<Score>> best(found.size() + 1, std::vector<Score>(truth.size() + 1));
  const auto paired = [&](std::size_t i, std::size_t j) {
    Score score = best[i][j];
    ++score.pairs;
    score.distance +=
        std::abs(tracer_.t(found[i]) - middle(truth_.crossings()[truth[j].crossing].t));
    return score;
  };
  const auto may_pair = [&](std::size_t i, std::size_t j) {
    return tracer_.crossings()[found[i]].enters == truth[j].enters;
  };
  for (std::size_t i = 0; i <= found.size(); ++i) {
    for (std::size_t j = 0; j <= truth.size(); ++j) {
      if (i > 0 && best[i - 1][j].better(best[i][j])) {
        best[i][j] = best[i - 1][j];
      }
      if (j > 0 && best[i][j - 1].better(best[i][j])) {
        best[i][j] = best[i][j - 1];
      }
      if (i > 0 && j > 0 && may_pair(i - 1, j - 1)) {
        if (const Score score = paired(i - 1, j - 1); score.better(best[i][j])) {
          best[i][j] = score;
        }
      }
    }
  }
  for (std::size_t i = found.size(), j = truth.size(); i > 0 && j > 0;) {
    const Score& here = best[i][j];
    if (!here.better(best[i - 1][j])) {
      --i;
    } else if (!here.better(best[i][j - 1])) {
      --j;
    } else {
      pair(--i, --j);
    }
  }
}

Verdict Judge::judge(const method::Report& report, double direction_length) {
  Verdict verdict;
  const std::vector<TruthClass>& classes = truth_.classes();
  reported_.assign(classes.size(), false);
  findings_.clear();
  const auto note = [&](Artifact artifact, std::size_t cls, std::uint32_t crossing) {
    ++verdict[artifact];
    findings_.push_back({artifact, cls, crossing});
  };

  std::size_t next = 0;  // the class behind the last one that was reported
  for (const method::Interface& seen : report.interfaces) {
    const csg::LeafIndex leaf = tracer_.crossings()[seen.crossing].leaf;
    const int cls = class_of_[seen.crossing];
    next = cls == kUnmatched ? next : static_cast<std::size_t>(cls + 1);
    if (cls < 0) {
      note(Artifact::GhostHit, next, seen.crossing);
      continue;
    }
    reported_[cls] = true;
    const TruthClass& truth = classes[cls];
    if (!truth.is_interface()) {
      note(Artifact::GhostHit, cls, seen.crossing);
      continue;
    }
    if (!owns(leaf, truth)) {
      note(Artifact::GhostSurface, cls, seen.crossing);
    }
    if (seen.transition != truth.effect.transition) {
      note(Artifact::WrongInterface, cls, seen.crossing);
    }
  }

  int first_interface = -1;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const TruthClass& truth = classes[c];
    count_lamina(truth, reported_[c], verdict);
    if (!truth.is_interface()) {
      continue;
    }
    if (first_interface < 0) {
      first_interface = static_cast<int>(c);
    }
    if (!reported_[c]) {
      note(why_missed(truth), c, kNoCrossing);
    }
  }

  const bool any_seen = !report.interfaces.empty();
  bool first_right = any_seen == (first_interface >= 0);
  if (any_seen && first_interface >= 0) {
    const method::Interface& seen = report.interfaces.front();
    const TruthClass& truth = classes[first_interface];
    first_right = class_of_[seen.crossing] == first_interface &&
                  seen.transition == truth.effect.transition &&
                  owns(tracer_.crossings()[seen.crossing].leaf, truth);
    if (first_right) {
      verdict.first_hit_measured = true;
      verdict.first_hit = measure(seen.crossing, truth);
    }
  }
  verdict[Artifact::FirstWrong] = first_right ? 0 : 1;

  judge_media(report, direction_length, verdict);
  verdict[Artifact::Inconsistent] = report.inconsistent + (report.end != truth_.end() ? 1 : 0);
  verdict[Artifact::WrongCount] = wrong_counts_;
  verdict[Artifact::WrongParity] = wrong_parities_;
  return verdict;
}

Artifact Judge::why_missed(const TruthClass& truth) const {
  bool some_ahead = false;
  for (std::size_t i = 0; i < truth.leaves.size(); ++i) {
    if (!owns(truth.leaves[i], truth)) {
      continue;
    }
    const std::uint32_t found = tracer_crossing_[truth.first_crossing + i];
    if (found == kNoCrossing) {
      return Artifact::MissedSolver;
    }
    some_ahead = some_ahead || tracer_.crossings()[found].ahead;
  }
  return some_ahead ? Artifact::MissedLogic : Artifact::MissedRange;
}

const method::HitError& Judge::measure(std::uint32_t crossing, const TruthClass& truth) {
  if (!measured_ || measured_->first != crossing) {
    measured_.emplace(crossing, tracer_.error(crossing, truth_.t(truth)));
  }
  return measured_->second;
}

void Judge::judge_media(const method::Report& report, double direction_length,
                        Verdict& verdict) const {
  // What the method believes behind each class: the last interface that it reports there or
  // before. A reported interface that matches no class stands behind the class before it.
  const std::vector<TruthClass>& classes = truth_.classes();
  std::vector<csg::Medium> believed(classes.size() + 1, report.start);
  int place = 0;
  for (const method::Interface& seen : report.interfaces) {
    const int cls = class_of_[seen.crossing];
    place = cls == kUnmatched ? place : cls + 1;
    std::fill(believed.begin() + place, believed.end(), seen.transition.to);
  }
  std::uint32_t run = 0;
  for (std::size_t i = 0; i <= classes.size(); ++i) {
    const csg::Medium truth = i == 0 ? truth_.start() : classes[i - 1].effect.transition.to;
    if (believed[i] == truth) {
      run = 0;
      continue;
    }
    ++verdict[truth == csg::kEmpty         ? Artifact::GhostMaterial
              : believed[i] == csg::kEmpty ? Artifact::Void
                                           : Artifact::WrongMedium];
    verdict.persistence = std::max(verdict.persistence, ++run);
    if (i < classes.size()) {
      const double begin = i == 0 ? 0 : middle(truth_.t(classes[i - 1]));
      verdict.wrong_length += (middle(truth_.t(classes[i])) - begin) * direction_length;
    }
  }
}

}  // namespace lamina::census
