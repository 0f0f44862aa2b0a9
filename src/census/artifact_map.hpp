// What is wrong with each pixel of a picture.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "census/path_truth.hpp"
#include "trace/whitted.hpp"

namespace lamina::census {

/// What is wrong with a ray of a pixel's tree, up to its first interface.
enum class Fault : std::uint8_t {
  MissedHit,
  GhostHit,
  GhostSurface,
  WrongInterface,
  WrongStart,  ///< the medium that the ray starts in; its first interface is right
  SelfIntersection,
  Undecided,  ///< no precision tried has decided the truth, or the ray lies in a carrier
};
inline constexpr std::size_t kFaultCount = 7;

struct FaultText {
  std::string_view name;
  std::string_view color_name;
  trace::Color color;  ///< of the pixels
  std::string_view definition;
};
/// By the fault.
const std::array<FaultText, kFaultCount>& fault_texts();

/// The kinds of rays of a tree: primary rays, then as trace::Branch has them.
inline constexpr std::size_t kRayKindCount = 4;

/// What the rays of one pixel's tree, or of all pixels', are like.
struct FaultCounts {
  std::optional<Fault> first;                       ///< of one pixel: the first one, depth first
  std::array<std::uint64_t, kRayKindCount> rays{};  ///< of each kind, judged or not
  std::array<std::uint64_t, kRayKindCount> unjudged{};  ///< spawned where no true ray is
  std::array<std::array<std::uint64_t, kFaultCount>, kRayKindCount> with{};

  /// Adds all counts; leaves `first`.
  void add(const FaultCounts& other);
};

/// Judges the rays of a tree as they are traced, each against the truth conditional on the hit
/// that spawns it. Where a ray hits what is not the truth's first interface, those that it
/// spawns are not judged.
class FaultFinder final : public trace::TreeObserver {
 public:
  explicit FaultFinder(const scene::Scene& scene) : truth_(scene) {}

  /// Of the last tree.
  [[nodiscard]] const FaultCounts& counts() const { return counts_; }

  void primary(const geometry::ExactRay& ray, const trace::RayPath& path,
               const method::Report& report) override;
  void spawned(trace::Branch branch, const geometry::ExactPoint& direction,
               const trace::RayPath& path, const method::Report& report) override;
  void back() override;

 private:
  /// How the truth stands to a ray of the path.
  enum class Standing : std::uint8_t {
    HitsTruth,  ///< the truth is at this ray; it spawns where the truth does
    HitsOther,  ///< the truth is at this ray
    Undecided,  ///< the truth stays at the ray before
    OffTruth,   ///< so does it: the ray before does not hit what is true
  };

  void judge(std::size_t kind, const trace::RayPath& path, const method::Report& report,
             double range);
  void count(std::size_t kind, Fault fault);

  PathTruth truth_;
  FaultCounts counts_;
  std::vector<Standing> standing_;  // of the path's rays
};

}  // namespace lamina::census
