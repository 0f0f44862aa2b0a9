// The exact crossings of a ray that starts on a surface: certified, or undecided.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "number/interval.hpp"
#include "poly/certified_roots.hpp"
#include "scene/scene.hpp"
#include "surface/enclosed_sweep.hpp"

namespace lamina::method {

/// The point on a surface that a spawned ray starts at. Its coordinates are algebraic numbers
/// that nothing writes down, but which carriers go through it is known.
struct ExactStart {
  /// Encloses the point, with about that many bits after the binary point; none where a ray
  /// before it is not certified so closely. Copies share what is known: not for two threads.
  std::function<std::optional<geometry::Vector3<number::Interval>>(int bits)> point;
  std::vector<surface::CarrierIndex> carriers;  ///< all that go through the point, ascending

  struct SweepCurve {
    surface::CarrierIndex carrier = 0;
    surface::EnclosedSweep::CurveIndex curve = 0;
  };
  /// Of all sweeps, whether these go through the point or not; ascending.
  std::vector<SweepCurve> curves;
};

/// All leaves of one carrier at one of its roots, s > 0.
struct SpawnedClass {
  surface::CarrierIndex carrier = 0;
  std::size_t root = 0;  ///< 0, 1, ... among the carrier's positive roots
  double s = 0;          ///< within 2^-60 max(1, s) of the root
};

/// The crossings with s > 0 of the ray start + s direction, the start an algebraic point, the
/// direction read exactly (design 1, conditional truth). For a carrier through the start the
/// root s = 0 is divided out, never searched for. Everything else is decided by intervals, of
/// more and more bits until they suffice; equal roots of different carriers, or of different curves
/// of a swept contour, never do. In a scene with a sphere sweep nothing is decided.
class SpawnedEvents {
 public:
  /// Bits at which a decision is given up.
  static constexpr int kMaxBits = 1536;

  explicit SpawnedEvents(const scene::Scene& scene);

  /// Where an exact ray meets a surface. The carriers and curves through the point are decided
  /// exactly, but that a sweep which the ray only touches there is no such carrier. Nothing is
  /// decided from where a curve of a sweep goes through the point that the ray runs along
  /// somewhere.
  [[nodiscard]] ExactStart start_on(const geometry::ExactRay& ray, const number::Root& t) const;

  /// Returns whether all of the ray is decided; if not, there is nothing to ask for.
  bool find(const ExactStart& start, const geometry::ExactPoint& direction);

  /// Ascending s.
  [[nodiscard]] std::span<const SpawnedClass> classes() const { return classes_; }
  /// The leaf's state at s = 0+.
  [[nodiscard]] bool starts_inside(csg::LeafIndex leaf) const { return starts_inside_[leaf] != 0; }
  /// Where a ray starts that is spawned at a class of this one.
  [[nodiscard]] ExactStart start_on(std::size_t cls) const;

 private:
  // The sign of f at s = 0+, 0 if the ray lies in the carrier, and the roots; those of a polynomial
  // have no place.
  using CarrierRoots = surface::EnclosedSweep::Crossings;
  // Both: none if that many bits do not suffice. The ray's origin is given besides.
  [[nodiscard]] std::optional<CarrierRoots> roots_of(
      surface::CarrierIndex carrier, const surface::EnclosedSweep::EnclosedPoint& origin,
      surface::EnclosedRayMonomials& ray) const;
  [[nodiscard]] std::optional<poly::IsolatedRoot> root_of(
      std::size_t cls, const surface::EnclosedSweep::EnclosedPoint& origin) const;
  [[nodiscard]] surface::EnclosedSweep::Start sweep_start(surface::CarrierIndex carrier) const;
  bool find_with(int bits);

  const scene::Scene* scene_;
  bool is_decidable_ = true;  // no carrier is a sphere sweep
  // By the carrier; none but for swept contours.
  std::shared_ptr<const std::vector<std::optional<surface::EnclosedSweep>>> sweeps_;
  ExactStart start_;
  geometry::ExactPoint direction_;
  std::vector<SpawnedClass> classes_;
  std::vector<surface::EnclosedSweep::Place> places_;  // of classes_, where these are of sweeps
  std::vector<std::uint8_t> starts_inside_;
};

}  // namespace lamina::method
