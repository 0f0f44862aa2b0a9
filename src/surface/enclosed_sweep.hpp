// A swept contour along a ray whose origin is only enclosed: certified crossings, or undecided.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "poly/certified_roots.hpp"
#include "surface/carrier.hpp"
#include "surface/contour_curve.hpp"

namespace lamina::surface {

/// The curves of a sweep's pieces, each once, for many rays.
class EnclosedSweep {
 public:
  using CurveIndex = std::uint32_t;
  using EnclosedPoint = geometry::Vector3<number::Interval>;

  /// Contract: it is a SweptSurface that is placed.
  explicit EnclosedSweep(std::shared_ptr<const PlacedSweep> sweep);

  /// What is known of the point that a ray starts at.
  struct Start {
    bool on_surface = false;
    /// All that go through it, also beyond the ends of their pieces; ascending.
    std::vector<CurveIndex> curves;
  };

  /// The curves through a point of a ray in the world, as Start has them: exact. `point` encloses
  /// it.
  [[nodiscard]] std::vector<CurveIndex> curves_at(const geometry::ExactRay& ray,
                                                  const number::Root& t,
                                                  const EnclosedPoint& point) const;

  /// Which root it is that a ray crosses the surface at.
  struct Place {
    CurveIndex curve = 0;
    std::size_t root = 0;  ///< 0, 1, ... among the curve's positive roots
  };
  struct Crossing {
    poly::IsolatedRoot root;
    Place place;
  };
  struct Crossings {
    int sign = 0;  ///< -1 inside at s = 0+, 1 outside, 0 if the ray runs along the surface there
    std::vector<Crossing> crossings;  ///< s > 0, ascending; none if the sign is 0
  };

  /// The crossings of a ray in the world: those of every ray whose origin is enclosed and which
  /// starts as told. None if that cannot be certified with so many bits: where the ray touches a
  /// curve or meets two of them at one point, if that may be on a piece or no rectangle tells.
  ///
  /// The roots of each curve that the ray may meet on a piece are isolated, that at the start
  /// divided out. Between two of these roots an exact point beside the ray is inside or outside,
  /// and so is the ray, as no curve's piece is between them: where that changes is a crossing.
  [[nodiscard]] std::optional<Crossings> crossings(const EnclosedPoint& origin,
                                                   const geometry::ExactPoint& direction,
                                                   const Start& start) const;

  /// The root at a place that crossings() found for this ray, perhaps with fewer bits; none as
  /// there.
  [[nodiscard]] std::optional<poly::IsolatedRoot> root_at(const Place& place,
                                                          const EnclosedPoint& origin,
                                                          const geometry::ExactPoint& direction,
                                                          const Start& start) const;

 private:
  struct Curve {
    ContourCurve equation;
    std::optional<ContourCurve> on_axis;     // of a rotational sweep
    std::vector<geometry::Rectangle> boxes;  // of its pieces
  };

  // A ray in local coordinates, and what is known of its start.
  struct LocalRay;

  [[nodiscard]] const SweptSurface& surface() const {
    return std::get<SweptSurface>(sweep_->surface);
  }

  [[nodiscard]] LocalRay local_ray(const EnclosedPoint& origin,
                                   const geometry::ExactPoint& direction, const Start& start) const;
  // Of the curve along the ray, that at the start divided out; an empty polynomial if the ray stays
  // on the curve.
  [[nodiscard]] std::vector<number::Interval> restrict(CurveIndex curve, LocalRay& ray) const;
  [[nodiscard]] bool has_zero_coefficient(const ContourCurve& equation,
                                          const geometry::ExactPoint& direction,
                                          std::size_t power) const;
  [[nodiscard]] std::optional<int> side_at(const EnclosedPoint& point) const;

  std::shared_ptr<const PlacedSweep> sweep_;
  std::vector<Curve> curves_;
};

}  // namespace lamina::surface
