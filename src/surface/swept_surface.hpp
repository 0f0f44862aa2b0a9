// Half-spaces bounded by a swept contour, exactly: van Wijk's translational, conic and rotational
// sweeps, and his generalization of conic ones.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/contour.hpp"
#include "geometry/vector.hpp"
#include "number/algebraic.hpp"

namespace lamina::surface {

/// Which points (x, y, z) lie in the half-space, for a contour in the (u, v) plane (van Wijk 1984,
/// sections 3 to 5). None has caps: these are planes of the scene's tree.
enum class Sweep : std::uint8_t {
  Translational,  ///< (u, v) = (x, y): the infinite cylinder over the contour
  Conic,          ///< (u, v) = (x / z, y / z): the infinite cone of both nappes, apex at the origin
  Rotational,     ///< (u, v) = (sqrt(x^2 + y^2), z): the solid of revolution
  /// (u, v) = (x / p(z), y / q(z)) for polynomials p and q: each coordinate is scaled by a function
  /// of its own (section 7). At heights where one is zero there is no inside.
  GeneralisedConic,
};

/// What a scene calls it: `translational_sweep` and so on.
std::string_view name_of(Sweep sweep);

struct ContourCurve;  // surface/contour_curve.hpp

/// Of a generalised conic sweep: coefficients of 1, z, z^2, ...
struct Scaling {
  std::vector<number::Rational> x;  ///< of p
  std::vector<number::Rational> y;  ///< of q

  friend bool operator==(const Scaling&, const Scaling&) = default;
};

/// The half-space in local coordinates.
class SweptSurface {
 public:
  struct Crossing {
    number::Root t;
    std::uint32_t piece = 0;  ///< of the contour; where two meet, the lower one; see crossings()
  };

  /// The crossings of a ray: where it goes from outside to inside or back, each at its exact t,
  /// ascending; a touch is none.
  struct Crossings {
    bool starts_inside = false;  ///< for t towards -infinity
    bool in_boundary = false;    ///< the ray runs along the surface somewhere: no crossings then
    std::vector<Crossing> crossings;
  };

  /// A point of the contour.
  struct Foot {
    std::uint32_t piece = 0;
    number::Rational s;  ///< 0 <= s < 1, to 2^-320; or 1 at the axis
  };

  /// Throws base::InputError for a contour that the sweep cannot have: an open one, but for
  /// Rotational, for that one with points left of the axis, and one that encloses nothing.
  SweptSurface(Sweep sweep, std::shared_ptr<const geometry::Contour> contour);
  /// Generalised conic; but translational with p = q = 1, and conic with p = q = z. Throws
  /// base::InputError also for a polynomial that is zero, and for degrees above 5: of p and q
  /// together, or of either where they are equal.
  SweptSurface(Scaling scaling, std::shared_ptr<const geometry::Contour> contour);

  /// All crossings on the whole line of a ray in local coordinates; t is the same as in the world.
  /// Exact: s is eliminated from each piece, which leaves a polynomial in t of degree 3, or 6 of a
  /// rotational sweep, or up to 15 of a generalised conic one; between its isolated roots the ray's
  /// points are inside or not. Where the curves of several pieces pass through one point, which may
  /// be beyond their ends, the crossing is that of the lowest piece whose rectangle holds it.
  [[nodiscard]] Crossings crossings(const geometry::ExactRay& local) const;

  /// -1 inside, 0 on the surface, 1 outside: exact.
  [[nodiscard]] int side(const geometry::ExactPoint& local) const;

  /// Where the contour is nearest to a point that is all but on the surface, as far as that is told
  /// by u or v alone. Its error is of the order of the point's distance from the surface. Contract:
  /// not where the scaling is zero, as at z = 0 of a conic sweep.
  [[nodiscard]] Foot foot_near(const geometry::ExactPoint& local) const;
  /// The outward normal, not of length one, at a point over this one of the contour.
  [[nodiscard]] geometry::ExactPoint normal_at(const geometry::ExactPoint& local,
                                               const Foot& foot) const;
  /// That at foot_near(local); zero where the scaling is, as at the apex of a conic sweep.
  [[nodiscard]] geometry::ExactPoint normal_near(const geometry::ExactPoint& local) const;

  /// The planes that the surface consists of around one of its points.
  struct Facets {
    std::vector<geometry::ExactPoint> normals;  ///< outward: one, or two where they meet
    bool convex = true;                         ///< is inside of both what is inside, or of either?
  };
  /// Of the sides of a polygon that is not turned; exact. Nothing at a curved piece or the apex.
  [[nodiscard]] std::optional<Facets> facets(const geometry::ExactPoint& local) const;

  /// Of a piece that is part of the surface: the curve that it lies on.
  [[nodiscard]] const ContourCurve& curve(std::uint32_t piece) const;
  /// Is a piece part of the surface? One that a rotational sweep has on its axis is not.
  [[nodiscard]] bool sweeps(std::uint32_t piece) const;

  [[nodiscard]] Sweep sweep() const { return sweep_; }
  /// Empty but of a generalised conic sweep; without leading zeros.
  [[nodiscard]] const Scaling& scaling() const { return scaling_; }
  [[nodiscard]] const geometry::Contour& contour() const { return *contour_; }

  /// Equal if the sweeps are, and the contours by their points, which must begin at the same one.
  friend bool operator==(const SweptSurface& a, const SweptSurface& b) { return (a <=> b) == 0; }
  friend std::strong_ordering operator<=>(const SweptSurface& a, const SweptSurface& b);

 private:
  Sweep sweep_;
  Scaling scaling_;
  std::shared_ptr<const geometry::Contour> contour_;
  std::shared_ptr<const std::vector<ContourCurve>> curves_;  // of all pieces
};

}  // namespace lamina::surface
