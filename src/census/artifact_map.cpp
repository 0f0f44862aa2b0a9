#include "census/artifact_map.hpp"

#include <algorithm>
#include <initializer_list>

namespace lamina::census {

const std::array<FaultText, kFaultCount>& fault_texts() {
  static const std::array<FaultText, kFaultCount> texts{{
      {"missed hit",
       "red",
       {0.90, 0.10, 0.10},
       "the truth has an interface, the method none or a later one"},
      {"ghost hit",
       "magenta",
       {0.95, 0.20, 0.90},
       "an interface is reported where the truth has none"},
      {"ghost surface",
       "orange",
       {1.00, 0.55, 0.00},
       "the right place, but a leaf that does not own it"},
      {"wrong interface",
       "yellow",
       {1.00, 0.95, 0.20},
       "the right place and leaf, but wrong media"},
      {"wrong start",
       "green",
       {0.15, 0.85, 0.25},
       "the ray starts in a wrong medium, and hits what it should"},
      {"self-intersection",
       "cyan",
       {0.10, 0.85, 0.95},
       "the ray hits the surface that it starts on, where it starts"},
      {"undecided",
       "blue",
       {0.20, 0.30, 1.00},
       "no precision tried has decided the truth, or the ray lies in a surface"},
  }};
  return texts;
}

void FaultCounts::add(const FaultCounts& other) {
  for (std::size_t kind = 0; kind < kRayKindCount; ++kind) {
    rays[kind] += other.rays[kind];
    unjudged[kind] += other.unjudged[kind];
    for (std::size_t fault = 0; fault < kFaultCount; ++fault) {
      with[kind][fault] += other.with[kind][fault];
    }
  }
}

namespace {

// The one fault of a verdict that says most; none if all is right.
std::optional<Fault> fault_of(const Verdict& verdict) {
  const auto any = [&verdict](std::initializer_list<Artifact> artifacts) {
    return std::any_of(artifacts.begin(), artifacts.end(),
                       [&verdict](Artifact a) { return verdict[a] > 0; });
  };
  using enum Artifact;
  if (any({Artifact::SelfIntersection})) {
    return Fault::SelfIntersection;
  }
  if (any({Artifact::GhostHit})) {
    return Fault::GhostHit;
  }
  if (any({MissedSolver, MissedLogic, MissedRange})) {
    return Fault::MissedHit;
  }
  if (any({Artifact::GhostSurface})) {
    return Fault::GhostSurface;
  }
  if (any({Artifact::WrongInterface})) {
    return Fault::WrongInterface;
  }
  if (any({GhostMaterial, Void, WrongMedium})) {
    return Fault::WrongStart;
  }
  return std::nullopt;
}

}  // namespace

void FaultFinder::count(std::size_t kind, Fault fault) {
  ++counts_.with[kind][static_cast<std::size_t>(fault)];
  if (!counts_.first) {
    counts_.first = fault;
  }
}

void FaultFinder::judge(std::size_t kind, const trace::RayPath& path, const method::Report& report,
                        double range) {
  const Verdict verdict = judge_first(truth_, path, report, range);
  if (const auto fault = fault_of(verdict)) {
    count(kind, *fault);
  }
  const bool hits = truth_.first() != nullptr && spawns_at_truth(verdict);
  standing_.push_back(hits ? Standing::HitsTruth : Standing::HitsOther);
}

void FaultFinder::primary(const geometry::ExactRay& ray, const trace::RayPath& path,
                          const method::Report& report) {
  counts_ = {};
  standing_.clear();
  ++counts_.rays[0];
  truth_.start(ray);
  if (truth_.in_some_carrier()) {
    count(0, Fault::Undecided);
    standing_.push_back(Standing::HitsOther);
    return;
  }
  judge(0, path, report, std::numeric_limits<double>::infinity());
}

void FaultFinder::spawned(trace::Branch branch, const geometry::ExactPoint& direction,
                          const trace::RayPath& path, const method::Report& report) {
  const std::size_t kind = 1 + static_cast<std::size_t>(branch);
  ++counts_.rays[kind];
  if (standing_.back() != Standing::HitsTruth) {
    ++counts_.unjudged[kind];
    standing_.push_back(Standing::OffTruth);
  } else if (!truth_.spawn(direction)) {
    count(kind, Fault::Undecided);
    standing_.push_back(Standing::Undecided);
  } else {
    judge(kind, path, report, range_of(branch));
  }
}

void FaultFinder::back() {
  const Standing last = standing_.back();
  standing_.pop_back();
  if (last == Standing::HitsTruth || last == Standing::HitsOther) {
    truth_.back();
  }
}

}  // namespace lamina::census
