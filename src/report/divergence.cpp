#include "report/divergence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace lamina::report {
namespace {

using Cause = Divergence::Cause;
using census::kNoCrossing;
using census::TruthCrossing;
using method::EventRecord;

constexpr int kNoClass = -2;

// Looks for the cause of what is wrong in one outcome.
class Search {
 public:
  explicit Search(const Outcome& outcome)
      : outcome_(outcome),
        truth_(*outcome.truth),
        tree_(outcome.scene->tree),
        exact_(truth_.crossings().size()),
        record_of_(outcome.lane->exact_of.size(), kNoCrossing) {
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      for (const TruthCrossing& crossing : truth_.crossings_of(leaf)) {
        exact_[crossing.crossing] = &crossing;
      }
    }
    for (std::uint32_t r = 0; r < outcome.records.size(); ++r) {
      record_of_[outcome.records[r].crossing] = r;
    }
  }

  Divergence run() {
    if (outcome_.report.start != truth_.start()) {
      return outcome_.geometric() ? start_test() : carried_to_start();
    }
    if (outcome_.findings.empty()) {
      Divergence found = anything_else();
      const census::Verdict& verdict = outcome_.verdict;
      found.harmless = verdict[census::Artifact::GhostMaterial] + verdict[census::Artifact::Void] +
                           verdict[census::Artifact::WrongMedium] ==
                       0;
      return found;
    }
    const census::Finding& first = *std::min_element(
        outcome_.findings.begin(), outcome_.findings.end(),
        [](const census::Finding& a, const census::Finding& b) { return a.cls < b.cls; });
    return first.crossing == kNoCrossing ? missed(first.cls) : reported(first);
  }

 private:
  // Events first .. last-1 that are processed at once.
  struct Group {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    [[nodiscard]] bool contains(std::uint32_t record) const {
      return first <= record && record < last;
    }
    [[nodiscard]] bool empty() const { return first == last; }
  };

  // Stands for the start of the ray: no events, behind those that are not ahead of it.
  static Group at_start(std::uint32_t behind) { return {behind, behind}; }

  [[nodiscard]] const EventRecord& record(std::uint32_t r) const { return outcome_.records[r]; }

  [[nodiscard]] std::uint32_t record_count() const {
    return static_cast<std::uint32_t>(outcome_.records.size());
  }

  // The exact crossing that the event is, if it is one.
  [[nodiscard]] const TruthCrossing* exact(std::uint32_t r) const {
    const std::uint32_t index = outcome_.exact_of(record(r));
    return index == kNoCrossing ? nullptr : exact_[index];
  }

  [[nodiscard]] int class_of(std::uint32_t r) const {
    const TruthCrossing* crossing = exact(r);
    return crossing == nullptr ? kNoClass : crossing->cls;
  }

  // The event of an exact crossing, or kNoCrossing where its root was not found or, by a
  // geometric method, not looked at.
  [[nodiscard]] std::uint32_t event_of(const TruthCrossing& crossing) const {
    const std::uint32_t found = found_for(crossing);
    return found == kNoCrossing ? kNoCrossing : record_of_[found];
  }

  [[nodiscard]] std::uint32_t found_for(const TruthCrossing& crossing) const {
    return outcome_.lane->judge.matches()[crossing.crossing];
  }

  [[nodiscard]] Divergence at_record(Cause cause, std::uint32_t r,
                                     std::uint32_t other = Divergence::kNone) const {
    return {.cause = cause, .record = r, .other = other, .leaf = outcome_.leaf_of(record(r))};
  }

  [[nodiscard]] Divergence at_exact(Cause cause, const TruthCrossing& crossing) const {
    return {.cause = cause,
            .exact = crossing.crossing,
            .leaf = truth_.crossings()[crossing.crossing].leaf};
  }

  // What is wrong with the event by itself.
  [[nodiscard]] std::optional<Divergence> fault_of(std::uint32_t r) const {
    const TruthCrossing* truth = exact(r);
    if (truth == nullptr) {
      return at_record(Cause::RootInvented, r);
    }
    if (outcome_.ahead(record(r)) != (truth->cls >= 0)) {
      return at_record(Cause::OtherSide, r);
    }
    if (!std::isfinite(outcome_.lane->tracer->t(record(r).crossing))) {
      return at_record(Cause::NotFinite, r);
    }
    if (record(r).enters != truth->enters) {
      return at_record(Cause::WrongSense, r);
    }
    if (!record(r).accepted) {
      return at_record(Cause::Rejected, r);
    }
    return std::nullopt;
  }

  // What is wrong with the way in which an exact crossing was found, if it was.
  [[nodiscard]] std::optional<Divergence> fault_of(const TruthCrossing& crossing) const {
    const std::uint32_t found = found_for(crossing);
    if (found == kNoCrossing) {
      return at_exact(Cause::RootMissing, crossing);
    }
    if (const std::uint32_t r = record_of_[found]; r != kNoCrossing) {
      return fault_of(r);
    }
    if (!std::isfinite(outcome_.lane->tracer->t(found))) {
      return at_exact(Cause::NotFinite, crossing);
    }
    if (outcome_.lane->tracer->crossings()[found].ahead != (crossing.cls >= 0)) {
      return at_exact(Cause::OtherSide, crossing);
    }
    return std::nullopt;
  }

  [[nodiscard]] Group group_of(std::uint32_t r) const {
    Group group{r, r + 1};
    while (group.first > 0 && record(group.first - 1).group == record(r).group) {
      --group.first;
    }
    while (group.last < record_count() && record(group.last).group == record(r).group) {
      ++group.last;
    }
    return group;
  }

  // The leaf's state in truth in front of a class.
  [[nodiscard]] bool true_state(csg::LeafIndex leaf, int cls) const {
    bool inside = truth_.starts_inside(leaf);
    for (const TruthCrossing& crossing : truth_.crossings_of(leaf)) {
      if (crossing.cls >= cls) {
        break;
      }
      inside = crossing.enters;
    }
    return inside;
  }

  // What the method takes all leaves for in front of an event.
  [[nodiscard]] std::vector<bool> states_before(std::uint32_t r) const {
    std::vector<bool> states;
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      states.push_back(outcome_.first_state(leaf));
    }
    apply({0, r}, states);
    return states;
  }

  // Carries states over the events; only of carried states.
  void apply(const Group& events, std::vector<bool>& states) const {
    for (std::uint32_t r = events.first; r < events.last; ++r) {
      states[outcome_.leaf_of(record(r))] = record(r).inside;
    }
  }

  [[nodiscard]] csg::Medium medium(const std::vector<bool>& states) const {
    return csg::evaluate(tree_, [&](csg::LeafIndex leaf) {
      return states[leaf] ? tree_.medium_of(leaf) : csg::kEmpty;
    });
  }

  // Does it change the medium whether the leaf is inside?
  [[nodiscard]] bool matters(csg::LeafIndex leaf, std::vector<bool> states) const {
    const csg::Medium as_it_is = medium(states);
    states[leaf].flip();
    return medium(states) != as_it_is;
  }

  [[nodiscard]] bool single() const {
    return outcome_.method->grouping == method::Grouping::Single;
  }

  // Why events of different t are processed at once.
  [[nodiscard]] Cause at_once() const { return single() ? Cause::LookedAhead : Cause::Merged; }

  // ---- Methods that carry states.

  [[nodiscard]] Divergence carried_to_start() const {
    Group behind{0, 0};
    while (behind.last < record_count() && !outcome_.ahead(record(behind.last))) {
      behind.last = group_of(behind.last).last;
    }
    if (const auto found = wrong_state(0, at_start(behind.last))) {
      return *found;
    }
    return {.cause = Cause::Unknown};
  }

  [[nodiscard]] Divergence reported(const census::Finding& finding) const {
    const std::uint32_t r = record_of_[finding.crossing];
    if (class_of(r) < 0) {
      return fault_of(r).value_or(Divergence{.cause = Cause::Unknown});
    }
    if (outcome_.geometric()) {
      return tested_wrong(r);
    }
    return carried_to(static_cast<int>(finding.cls), r);
  }

  [[nodiscard]] Divergence missed(std::size_t index) const {
    const census::TruthClass& cls = truth_.classes()[index];
    std::vector<std::uint32_t> events;
    for (std::uint32_t i = 0; i < cls.leaves.size(); ++i) {
      const auto& owners = cls.effect.owners;
      if (std::find(owners.begin(), owners.end(), cls.leaves[i]) == owners.end()) {
        continue;
      }
      const TruthCrossing& crossing = *exact_[cls.first_crossing + i];
      const std::uint32_t r = event_of(crossing);
      const auto fault = fault_of(crossing);
      // A check that rejects has its reason in the leaf's state, which is looked at below.
      if (fault && fault->cause != Cause::Rejected) {
        return *fault;
      }
      events.push_back(r);
    }
    if (!outcome_.geometric()) {
      return carried_to(static_cast<int>(index), events.front());
    }
    return tested_wrong(events.front());
  }

  // The interface of a class is wrong, and `r` is an event of it.
  [[nodiscard]] Divergence carried_to(int cls, std::uint32_t r) const {
    const Group group = group_of(r);
    if (const auto found = wrong_state(cls, group)) {
      return *found;
    }
    return wrong_group(cls, r, group);
  }

  // Why the states in front of the group are wrong, if that matters there: by one leaf that
  // would do alone, else by the first of several that do it together.
  [[nodiscard]] std::optional<Divergence> wrong_state(int cls, const Group& group) const {
    const std::vector<bool> before = states_before(group.first);
    std::vector<bool> behind = before;
    apply(group, behind);
    std::vector<bool> due_before = before;
    std::vector<bool> due_behind = behind;
    std::vector<csg::LeafIndex> wrong;
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      if (before[leaf] != state_due(leaf, cls, group)) {
        wrong.push_back(leaf);
        due_before[leaf].flip();
        due_behind[leaf].flip();
      }
    }
    if (medium(before) == medium(due_before) && medium(behind) == medium(due_behind)) {
      return std::nullopt;
    }
    std::stable_partition(wrong.begin(), wrong.end(), [&](csg::LeafIndex leaf) {
      return matters(leaf, before) || matters(leaf, behind);
    });
    for (const csg::LeafIndex leaf : wrong) {
      if (const auto found = why_wrong(leaf, cls, group)) {
        return found;
      }
    }
    return std::nullopt;
  }

  // The true state in front of the class or, where the leaf's own event in it was processed
  // before the group, behind it.
  [[nodiscard]] bool state_due(csg::LeafIndex leaf, int cls, const Group& group) const {
    for (const TruthCrossing& crossing : truth_.crossings_of(leaf)) {
      if (crossing.cls == cls && event_of(crossing) < group.first && !group.empty()) {
        return crossing.enters;
      }
    }
    return true_state(leaf, cls);
  }

  [[nodiscard]] std::optional<Divergence> why_wrong(csg::LeafIndex leaf, int cls,
                                                    const Group& group) const {
    const std::vector<TruthCrossing>& crossings = truth_.crossings_of(leaf);
    for (const TruthCrossing& crossing : crossings) {
      if (crossing.cls < cls && found_for(crossing) == kNoCrossing) {
        return at_exact(Cause::RootMissing, crossing);
      }
    }
    for (std::uint32_t r = 0; r < group.first; ++r) {
      if (outcome_.leaf_of(record(r)) == leaf && exact(r) == nullptr) {
        return at_record(Cause::RootInvented, r);
      }
    }
    if (outcome_.first_state(leaf) != truth_.starts_inside(leaf)) {
      return Divergence{.cause = Cause::WrongStart, .leaf = leaf};
    }
    for (std::uint32_t r = 0; r < group.first; ++r) {
      if (outcome_.leaf_of(record(r)) == leaf) {
        if (const auto fault = fault_of(r)) {
          return fault;
        }
        if (class_of(r) >= cls && group.empty()) {  // at once with what is behind the start
          return at_record(at_once(), r, group_of(r).first);
        }
        if (class_of(r) > cls) {
          return at_record(Cause::Swapped, r, group.first);
        }
      }
    }
    for (const TruthCrossing& crossing : crossings) {
      if (crossing.cls < cls && event_of(crossing) >= group.first) {
        const std::uint32_t late = event_of(crossing);
        return fault_of(late).value_or(at_record(Cause::Swapped, group.first, late));
      }
    }
    return std::nullopt;
  }

  // All states were right in front of the group that `r` is in.
  [[nodiscard]] Divergence wrong_group(int cls, std::uint32_t r, const Group& group) const {
    const census::TruthClass& truth = truth_.classes()[cls];
    std::vector<std::uint32_t> of_class;
    for (std::uint32_t i = 0; i < truth.leaves.size(); ++i) {
      const TruthCrossing& crossing = *exact_[truth.first_crossing + i];
      if (const auto fault = fault_of(crossing)) {
        return *fault;
      }
      of_class.push_back(event_of(crossing));
    }
    std::sort(of_class.begin(), of_class.end());
    for (std::uint32_t i = group.first; i < group.last; ++i) {
      if (exact(i) == nullptr) {
        return at_record(Cause::RootInvented, i);
      }
      if (class_of(i) != cls) {
        return at_record(at_once(), std::max(i, r), std::min(i, r));
      }
    }
    for (std::uint32_t i = of_class.front(); i < of_class.back(); ++i) {
      if (class_of(i) > cls) {
        return at_record(Cause::Swapped, i, of_class.back());
      }
    }
    if (!group.contains(of_class.front()) || !group.contains(of_class.back())) {
      return taken_apart(of_class, truth.effect.transition.from);
    }
    if (outcome_.reported(record(r)) != nullptr) {
      return at_record(Cause::NotOwner, r);
    }
    return {.cause = Cause::Unknown, .record = r};
  }

  // The events of one class are in several groups: between which the medium is wrong.
  [[nodiscard]] Divergence taken_apart(const std::vector<std::uint32_t>& events,
                                       csg::Medium from) const {
    std::optional<Divergence> first;
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const Group group = group_of(events[i]);
      if (group.contains(events[i + 1])) {
        continue;
      }
      const Divergence here =
          at_record(single() ? Cause::OneAtATime : Cause::Split, events[i], events[i + 1]);
      if (record(group.last - 1).medium != from) {
        return here;
      }
      first = first.value_or(here);
    }
    return *first;
  }

  // ---- Methods that test points.

  [[nodiscard]] Divergence start_test() const {
    std::vector<bool> tested;
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      tested.push_back(outcome_.first_state(leaf));
    }
    Divergence found{.cause = Cause::Unknown};
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      if (tested[leaf] != true_state(leaf, 0)) {
        found = {.cause = Cause::InsideTest, .leaf = leaf};
        if (matters(leaf, tested)) {
          break;  // alone; else several do it together
        }
      }
    }
    return found;
  }

  // The event's classification is wrong: by its sense, or by a test of another leaf.
  [[nodiscard]] Divergence tested_wrong(std::uint32_t r) const {
    if (const auto fault = fault_of(r)) {
      return *fault;
    }
    const int cls = class_of(r);
    const csg::LeafIndex own = outcome_.leaf_of(record(r));
    std::vector<bool> before;
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      before.push_back(outcome_.state_behind(record(r), leaf, false));
    }
    before[own] = !record(r).enters;
    std::vector<bool> behind = before;
    behind[own] = record(r).enters;
    std::vector<csg::LeafIndex> suspects;  // tested wrong, then crossed at the same t
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      const bool in_truth = true_state(leaf, cls);
      if (in_truth == true_state(leaf, cls + 1) && before[leaf] != in_truth) {
        suspects.push_back(leaf);
      }
    }
    for (const csg::LeafIndex leaf : truth_.classes()[cls].leaves) {
      if (leaf != own) {
        suspects.push_back(leaf);
      }
    }
    if (suspects.empty()) {
      const bool seen = outcome_.reported(record(r)) != nullptr;
      return at_record(seen ? Cause::NotOwner : Cause::Unknown, r);
    }
    // One that would do alone; else several do it together.
    const auto culprit = std::find_if(suspects.begin(), suspects.end(), [&](csg::LeafIndex leaf) {
      return matters(leaf, before) || matters(leaf, behind);
    });
    return {.cause = Cause::InsideTest,
            .record = r,
            .leaf = culprit == suspects.end() ? suspects.front() : *culprit};
  }

  // ---- All interfaces are right, one by one.

  [[nodiscard]] Divergence anything_else() const {
    for (std::uint32_t r = 0; r < record_count(); ++r) {
      if (exact(r) == nullptr) {
        return at_record(Cause::RootInvented, r);
      }
    }
    for (const TruthCrossing* crossing : exact_) {
      if (const auto fault = fault_of(*crossing)) {
        return *fault;
      }
    }
    for (std::uint32_t r = 0; r + 1 < record_count(); ++r) {
      if (class_of(r) > class_of(r + 1)) {
        return at_record(Cause::Swapped, r, r + 1);
      }
    }
    for (csg::LeafIndex leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
      if (outcome_.first_state(leaf) != truth_.starts_inside(leaf) && !outcome_.geometric()) {
        return {.cause = Cause::WrongStart, .leaf = leaf};
      }
    }
    return {.cause = Cause::Unknown};
  }

  const Outcome& outcome_;
  const census::Truth& truth_;
  const csg::Tree& tree_;
  std::vector<const TruthCrossing*> exact_;  // by the truth's crossing
  std::vector<std::uint32_t> record_of_;     // by the tracer's crossing
};

}  // namespace

Divergence first_divergence(const Outcome& outcome) {
  return outcome.verdict.right() ? Divergence{} : Search(outcome).run();
}

}  // namespace lamina::report
