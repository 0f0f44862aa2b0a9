#include "report/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "geometry/ray_text.hpp"
#include "report/divergence.hpp"
#include "report/legend.hpp"
#include "report/outcome.hpp"
#include "report/outcome_text.hpp"
#include "report/page.hpp"
#include "report/truth_text.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {
namespace {

using census::Truth;
using fmt::format;

struct Explained {
  Outcome outcome;
  Divergence divergence;
};

// Leaves with an event ahead of the start, in truth or in some number type, and those that a
// number type finds other roots for.
std::set<csg::LeafIndex> crossed_leaves(const scene::Scene& scene, const Truth& truth,
                                        const std::vector<Lane>& lanes) {
  std::set<csg::LeafIndex> leaves;
  for (const census::TruthClass& cls : truth.classes()) {
    leaves.insert(cls.leaves.begin(), cls.leaves.end());
  }
  for (const Lane& lane : lanes) {
    std::vector<std::size_t> found(scene.leaves.size());
    for (const method::CrossingId& crossing : lane.tracer->crossings()) {
      ++found[crossing.leaf];
      if (crossing.ahead) {
        leaves.insert(crossing.leaf);
      }
    }
    for (csg::LeafIndex leaf = 0; leaf < found.size(); ++leaf) {
      if (found[leaf] != truth.crossings_of(leaf).size()) {
        leaves.insert(leaf);
      }
    }
  }
  return leaves;
}

void insert_leaves_of(const Explained& explained, std::set<csg::LeafIndex>& leaves) {
  const auto& [outcome, divergence] = explained;
  if (divergence.cause != Divergence::Cause::None) {
    leaves.insert(divergence.leaf);
  }
  if (divergence.other != Divergence::kNone) {
    leaves.insert(outcome.leaf_of(outcome.records[divergence.other]));
  }
}

// Of many leaves, those that change the medium, or could in another order.
std::set<csg::LeafIndex> leaves_that_matter(const Truth& truth,
                                            const std::vector<Explained>& explained) {
  std::set<csg::LeafIndex> leaves;
  for (const census::TruthClass& cls : truth.classes()) {
    leaves.insert(cls.effect.owners.begin(), cls.effect.owners.end());
  }
  for (const Explained& each : explained) {
    const Outcome& outcome = each.outcome;
    csg::Medium medium = outcome.report.start;
    for (const method::EventRecord& record : outcome.records) {
      if (outcome.ahead(record) && (record.medium != medium || !record.accepted)) {
        leaves.insert(outcome.leaf_of(record));
      }
      medium = record.medium;
    }
    insert_leaves_of(each, leaves);
  }
  return leaves;
}

std::string heading(const scene::Scene& scene, const geometry::ExactRay& ray, const Truth& truth) {
  std::string text = paragraph(
      format("{} (leaves {}, carriers {})", scene.name, scene.leaves.size(), scene.carriers.size()),
      "Scene", 7);
  text += paragraph(format("--ray \"{}\"", geometry::to_text(ray)), "Ray", 7);
  text +=
      paragraph(truth.start() == csg::kEmpty ? "in empty space"
                                             : format("in {}", medium_name(scene, truth.start())),
                "Start", 7);
  return text;
}

// Outcomes as `method  in number, number`, a line for each method.
std::string combinations(const std::vector<const Explained*>& outcomes, std::size_t all_numbers) {
  Columns columns;
  for (std::size_t i = 0; i < outcomes.size();) {
    const std::string& method = outcomes[i]->outcome.method->name;
    std::vector<std::string> numbers;
    for (; i < outcomes.size() && outcomes[i]->outcome.method->name == method; ++i) {
      numbers.push_back(outcomes[i]->outcome.lane->number->name);
    }
    columns.add({method, numbers.size() == all_numbers && all_numbers > 2
                             ? format("in all {} number types", all_numbers)
                             : format("in {}", fmt::join(numbers, ", "))});
  }
  return columns.text(2);
}

std::string events_and_cause(const Explained& explained, const Legend& legend) {
  std::string text = events_text(explained.outcome, explained.divergence, legend);
  if (explained.divergence.cause != Divergence::Cause::None) {
    text += paragraph(sentence(explained.divergence, explained.outcome, legend), "=>", 4);
  }
  return text;
}

// Do two outcomes see the same things, and go wrong first by the same cause? Harmless swaps
// of other events make no difference.
bool same_way(const Explained& a, const Explained& b) {
  const auto seen = [](const Outcome& outcome) {
    std::vector<std::array<std::uint32_t, 3>> interfaces;
    for (const method::Interface& i : outcome.report.interfaces) {
      interfaces.push_back(
          {outcome.lane->tracer->crossings()[i.crossing].leaf, i.transition.from, i.transition.to});
    }
    return interfaces;
  };
  return a.divergence.cause == b.divergence.cause && a.divergence.leaf == b.divergence.leaf &&
         a.outcome.verdict.count == b.outcome.verdict.count &&
         a.outcome.report.start == b.outcome.report.start && seen(a.outcome) == seen(b.outcome);
}

// Outcomes that are right, then each way of being wrong, in the order of the first of each.
std::string outcomes_text(const std::vector<Explained>& explained, const Legend& legend,
                          std::size_t number_count) {
  if (explained.size() == 1) {
    const Outcome& only = explained.front().outcome;
    return format("\n{} in {}: {}\n{}", only.method->name, only.lane->number->name,
                  verdict_text(only.verdict), events_and_cause(explained.front(), legend));
  }
  std::vector<const Explained*> right;
  std::vector<std::vector<const Explained*>> wrong;
  for (const Explained& each : explained) {
    if (each.outcome.verdict.right()) {
      right.push_back(&each);
      continue;
    }
    const auto known = std::find_if(wrong.begin(), wrong.end(), [&each](const auto& group) {
      return same_way(*group.front(), each);
    });
    (known == wrong.end() ? wrong.emplace_back() : *known).push_back(&each);
  }
  std::string text;
  if (!right.empty()) {
    text += "\nRight\n" + combinations(right, number_count);
  }
  for (const auto& group : wrong) {
    text += "\n" + paragraph(verdict_text(group.front()->outcome.verdict), "Wrong:", 7);
    text += combinations(group, number_count);
    text += events_and_cause(*group.front(), legend);
  }
  return text;
}

}  // namespace

std::string explain(const scene::Scene& scene, const geometry::ExactRay& ray,
                    std::span<const method::Method> methods,
                    std::span<const trace::NumberChoice> numbers, const poly::Solvers& solvers) {
  Truth truth(scene);
  truth.find(ray);
  std::vector<Lane> lanes;
  for (const trace::NumberChoice& number : numbers) {
    lanes.emplace_back(scene, ray, truth, number, solvers);
  }
  std::vector<Explained> explained;
  for (const method::Method& method : methods) {
    for (Lane& lane : lanes) {
      Outcome outcome(scene, ray, truth, method, lane);
      const Divergence divergence = first_divergence(outcome);
      explained.push_back({std::move(outcome), divergence});
    }
  }

  const std::set<csg::LeafIndex> crossed = crossed_leaves(scene, truth, lanes);
  std::set<csg::LeafIndex> shown = crossed;
  if (crossed.size() > Legend::kLetters) {
    shown = leaves_that_matter(truth, explained);
  } else {
    for (const Explained& each : explained) {
      insert_leaves_of(each, shown);
    }
  }
  const Legend legend(scene, {shown.begin(), shown.end()});

  std::string text = heading(scene, ray, truth);
  text += shown.size() < crossed.size()
              ? format("\n{} of the {} leaves that the ray crosses: those that could matter\n",
                       shown.size(), crossed.size())
              : "\nLeaves that the ray crosses\n";
  text += legend.text();
  text += "\n" + truth_text(scene, ray, truth, legend);
  return text + outcomes_text(explained, legend, numbers.size());
}

}  // namespace lamina::report
