// One ray by one method in one number type against the truth.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "census/truth.hpp"
#include "method/tracer.hpp"

namespace lamina::census {

/// What is counted. A table counts the rays that have at least one of each.
enum class Artifact : std::uint8_t {
  FirstWrong,        ///< the first visible interface is not the truth's: what a picture shows
  MissedSolver,      ///< a missed hit: a root of an owner was not found
  MissedLogic,       ///< a missed hit: all roots of the owners found, none accepted
  MissedRange,       ///< a missed hit: found, but not at t > 0
  EpsilonHole,       ///< a missed hit that the method misses in exact arithmetic too
  GhostHit,          ///< an interface reported where the truth has none
  GhostSurface,      ///< right class, but the reported leaf is not in its owner set
  WrongInterface,    ///< right class, but from or to differ
  GhostMaterial,     ///< empty called a material on an exact open interval
  Void,              ///< a material called empty
  WrongMedium,       ///< a material called another
  Inconsistent,      ///< an enter while IN, a leave while OUT, or a wrong medium at the end
  WrongCount,        ///< a leaf with a wrong number of crossings
  WrongParity,       ///< a leaf with a wrong number of crossings, odd for even
  SelfIntersection,  ///< a spawned ray hits the surface that it starts on, at s = 0
};
inline constexpr std::size_t kArtifactCount = 15;

struct ArtifactText {
  std::string_view name;        ///< as in CSV and JSON
  std::string_view heading;     ///< as in tables
  std::string_view definition;  ///< one sentence
};
const std::array<ArtifactText, kArtifactCount>& artifact_texts();

/// Everything that is wrong with one ray.
struct Verdict {
  std::array<std::uint32_t, kArtifactCount> count{};
  double wrong_length = 0;          ///< of bounded intervals with a wrong medium, world units
  std::uint32_t persistence = 0;    ///< longest run of intervals with a wrong medium
  std::uint32_t lamina_fronts = 0;  ///< lamina classes that all events enter
  std::uint32_t lamina_fronts_seen = 0;
  std::uint32_t lamina_backs = 0;  ///< lamina classes that all events leave
  std::uint32_t lamina_backs_seen = 0;
  bool first_hit_measured = false;  ///< the first interface is right, and its error known
  method::HitError first_hit;

  [[nodiscard]] std::uint32_t operator[](Artifact a) const {
    return count[static_cast<std::size_t>(a)];
  }
  std::uint32_t& operator[](Artifact a) { return count[static_cast<std::size_t>(a)]; }
  [[nodiscard]] bool right() const;
  /// Is an interface of the truth not reported?
  [[nodiscard]] bool missed() const;
};

inline constexpr std::uint32_t kNoCrossing = UINT32_MAX;

/// Where an interface is wrong.
struct Finding {
  Artifact artifact = Artifact::GhostHit;  ///< a miss, a ghost, or a wrong interface
  /// Index into Truth::classes(): it is there or, where it matches none, next before it.
  std::size_t cls = 0;
  std::uint32_t crossing = kNoCrossing;  ///< the tracer's that was reported; none for a miss
};

/// Judges the rays of one scene in one number type. Not for two threads at once.
class Judge {
 public:
  Judge(const Truth& truth, const method::Tracer& tracer, std::size_t leaf_count);

  /// Matches the tracer's crossings of the present ray with the truth's: once for all
  /// methods. By (leaf, which crossing of the leaf); where a leaf has another number of
  /// crossings than in truth, in order, entering with entering, as many as possible and then
  /// with the least distance in t.
  void match();

  /// `direction_length` turns intervals of t into lengths.
  [[nodiscard]] Verdict judge(const method::Report& report, double direction_length);

  /// By the truth's crossing, the tracer's that match() paired with it, or kNoCrossing.
  [[nodiscard]] const std::vector<std::uint32_t>& matches() const { return tracer_crossing_; }

  /// The wrong interfaces of the last judged report: those reported in its order, then those
  /// missed in the truth's.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }

  /// Which classes the last judged report has an interface for.
  [[nodiscard]] const std::vector<bool>& reported_classes() const { return reported_; }

 private:
  static constexpr int kUnmatched = -2;

  void match_leaf(csg::LeafIndex leaf);
  [[nodiscard]] Artifact why_missed(const TruthClass& truth) const;
  const method::HitError& measure(std::uint32_t crossing, const TruthClass& truth);
  void judge_media(const method::Report& report, double direction_length, Verdict& verdict) const;

  const Truth& truth_;
  const method::Tracer& tracer_;
  std::vector<std::vector<std::uint32_t>> by_leaf_;  // indices of the tracer's crossings
  std::vector<int> class_of_;                   // by the tracer's crossing; -1 behind the start
  std::vector<std::uint32_t> tracer_crossing_;  // by the truth's crossing
  std::vector<Finding> findings_;
  std::vector<bool> reported_;
  // The error of the crossing last measured on this ray: methods mostly share their first hit.
  std::optional<std::pair<std::uint32_t, method::HitError>> measured_;
  std::uint32_t wrong_counts_ = 0;
  std::uint32_t wrong_parities_ = 0;
};

}  // namespace lamina::census
