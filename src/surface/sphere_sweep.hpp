// The solid that a ball sweeps out along a trajectory, exactly (van Wijk, "Ray tracing objects
// defined by sweeping a sphere", Eurographics 1984).
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/trajectory.hpp"
#include "number/algebraic.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {

/// All points that are not farther than a radius from a trajectory, in local coordinates.
class SphereSweep {
 public:
  /// As SweptSurface::Crossings has it; a bounded solid never starts inside.
  struct Crossings {
    bool in_boundary = false;
    std::vector<number::Root> t;
  };

  /// A point of the trajectory.
  struct Foot {
    std::uint32_t piece = 0;
    number::Rational u;  ///< 0 <= u <= 1, to 2^-320
  };

  /// Throws base::InputError if the radius is not positive.
  SphereSweep(const number::Rational& radius,
              std::shared_ptr<const geometry::Trajectory> trajectory);

  /// All crossings on the whole line of a ray in local coordinates; t is the same as in the world.
  /// Exact. With f(t, u) = |o + t d - c(u)|^2 - r^2, where a ball at the inside of a piece is the
  /// nearest one, f = df/du = 0: t is a root of the discriminant of f in u, of degree 10, or 6 or 2
  /// of a parabola or a straight piece. All other crossings are of the balls at the trajectory's
  /// ends and corners. Between all of these t, sample points are inside or not: so that parts which
  /// overlap, or just touch, need nothing of their own.
  [[nodiscard]] Crossings crossings(const geometry::ExactRay& local) const;

  /// -1 inside, 0 on the surface, 1 outside: exact.
  [[nodiscard]] int side(const geometry::ExactPoint& local) const;

  /// Of a point of the surface: is one point of the trajectory alone as near to it? Then both the
  /// inside and the outside are next to it. Exact.
  [[nodiscard]] bool has_one_foot(const geometry::ExactPoint& local) const;

  /// Where the trajectory is nearest to a point.
  [[nodiscard]] Foot foot_near(const geometry::ExactPoint& local) const;
  /// From the foot to the point: there, on the surface, the outward normal, not of length one.
  [[nodiscard]] geometry::ExactPoint normal_near(const geometry::ExactPoint& local) const;

  /// None is flat.
  [[nodiscard]] static std::optional<SweptSurface::Facets> facets(const geometry::ExactPoint&) {
    return std::nullopt;
  }

  [[nodiscard]] const number::Rational& radius() const { return radius_; }
  [[nodiscard]] const geometry::Trajectory& trajectory() const { return *trajectory_; }

  /// Equal if the radii and the trajectories are.
  friend bool operator==(const SphereSweep& a, const SphereSweep& b) { return (a <=> b) == 0; }
  friend std::strong_ordering operator<=>(const SphereSweep& a, const SphereSweep& b);

 private:
  number::Rational radius_;
  std::shared_ptr<const geometry::Trajectory> trajectory_;
};

using AnySweep = std::variant<SweptSurface, SphereSweep>;

}  // namespace lamina::surface
