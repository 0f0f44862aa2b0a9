// Random contours for tests, with coordinates on a grid of 1/64, and surfaces swept by them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::support {

inline constexpr std::array kSweeps{surface::Sweep::Translational, surface::Sweep::Conic,
                                    surface::Sweep::Rotational};
inline constexpr std::array kSweepsOfAllKinds{surface::Sweep::Translational, surface::Sweep::Conic,
                                              surface::Sweep::Rotational,
                                              surface::Sweep::GeneralisedConic};
inline constexpr std::array kKinds{geometry::ContourKind::Line, geometry::ContourKind::BSpline,
                                   geometry::ContourKind::CatmullRom};

inline number::Rational dyadic(double value, int denominator) {
  return {static_cast<std::int64_t>(std::lround(value * denominator)), denominator};
}

// A multiple of 1/64 between the bounds.
inline number::Rational any_dyadic(base::SeededStream& stream, double low, double high) {
  return dyadic(stream.uniform(low, high), 64);
}

// With angles that increase by less than half a turn: the polygon goes around the centre once.
inline std::vector<geometry::PlanePoint> any_star(base::SeededStream& stream,
                                                  const geometry::PlanePoint& centre) {
  const std::int64_t count = stream.integer(4, 12);
  std::vector<geometry::PlanePoint> points;
  for (std::int64_t i = 0; i < count; ++i) {
    const double turn =
        (static_cast<double>(i) + stream.uniform(0, 0.8)) / static_cast<double>(count);
    const double angle = 2 * std::numbers::pi * turn;
    const double radius = stream.uniform(0.25, 1.5);
    points.push_back({centre.u + dyadic(radius * std::cos(angle), 64),
                      centre.v + dyadic(radius * std::sin(angle), 64)});
  }
  return points;
}

// From the axis at v = -1 to the axis at v = 1, always upwards.
inline std::vector<geometry::PlanePoint> any_profile(base::SeededStream& stream) {
  const std::int64_t last = stream.integer(3, 8);
  std::vector<geometry::PlanePoint> points{{0, -1}};
  for (std::int64_t i = 1; i < last; ++i) {
    const double height =
        (static_cast<double>(i) + stream.uniform(-0.4, 0.4)) * 2 / static_cast<double>(last) - 1;
    points.push_back({any_dyadic(stream, 0.375, 1.5), dyadic(height, 64)});
  }
  points.push_back({0, 1});
  return points;
}

// A line and a parabola.
inline surface::Scaling any_scaling(base::SeededStream& stream) {
  const auto any = [&stream] {
    return number::Rational((stream.chance(0.5) ? 1 : -1) * stream.integer(1, 8), 8);
  };
  return {{any(), any()}, {any(), any(), any()}};
}

// Nothing where a spline crosses itself, or gets left of the axis. A star and a profile that are
// polygons never do.
inline std::optional<surface::SweptSurface> swept_surface(surface::Sweep sweep,
                                                          std::vector<geometry::PlanePoint> points,
                                                          geometry::ContourKind kind, bool closed,
                                                          surface::Scaling scaling = {}) {
  try {
    auto contour = std::make_shared<const geometry::Contour>(std::move(points), kind, closed);
    return sweep == surface::Sweep::GeneralisedConic
               ? surface::SweptSurface(std::move(scaling), std::move(contour))
               : surface::SweptSurface(sweep, std::move(contour));
  } catch (const base::InputError&) {
    if (kind == geometry::ContourKind::Line) {
      throw;
    }
    return std::nullopt;
  }
}

inline std::optional<surface::SweptSurface> any_swept_surface(base::SeededStream& stream,
                                                              surface::Sweep sweep,
                                                              geometry::ContourKind kind) {
  const bool turned = sweep == surface::Sweep::Rotational;
  const bool closed = !turned || stream.chance(0.5);
  const geometry::PlanePoint centre{turned ? number::Rational(2) : any_dyadic(stream, -1, 1),
                                    any_dyadic(stream, -1, 1)};
  auto points = closed ? any_star(stream, centre) : any_profile(stream);
  return swept_surface(
      sweep, std::move(points), kind, closed,
      sweep == surface::Sweep::GeneralisedConic ? any_scaling(stream) : surface::Scaling{});
}

}  // namespace lamina::support
