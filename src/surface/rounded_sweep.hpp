// Half-spaces bounded by a swept contour, in a rounded number type, by van Wijk's equations.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vector.hpp"
#include "poly/solver.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {

/// A sweep in local coordinates, its contour's pieces rounded once.
template <number::RoundedNumber Number>
class RoundedSweep {
 public:
  explicit RoundedSweep(const SweptSurface& exact);

  struct Crossing {
    Number t;
    Number s;  ///< the contour's parameter on the piece, 0 <= s < 1, or 1 at the axis
    std::uint32_t piece = 0;
  };

  /// Returns in `crossings`, ascending in t, where a ray in local coordinates crosses the surface:
  /// the s of each piece that its rectangle does not rule out, by equations 2, 6 and 9 of van Wijk
  /// 1984, then t by one of its equations for it, that with the largest divisor. Rays along the
  /// contour's plane or its axis have equations of their own in place of his very small numbers:
  /// at one z in a rotational sweep v(s) = o_z, and two t on the circle; parallel to the axis
  /// u(s) is the distance from it. Roots that the solver knows to be of even multiplicity are
  /// touches, and left out; a ray for which the equation of a piece holds all along crosses
  /// nothing.
  ///
  /// By his rule a joint belongs to the piece with s = 0: a ray that touches a corner there crosses
  /// it once, as far as this can tell. Where the contour meets the axis and ends, or goes on along
  /// it, u^2 has a double root, which is a crossing.
  ///
  /// Error:  that of the solver's s times the slope of t over s. The coefficients of the sextic are
  ///         the more off the farther away the ray starts, and with them s; and as a ray gets
  ///         nearly level, t is off by some u (|d| / d_z)^2: for |d_z| below some sqrt(u) |d| its
  ///         two crossings of a steep piece are lost.
  void find_crossings(const geometry::Ray<Number>& local, const poly::Solvers& solvers,
                      std::vector<Crossing>& crossings) const;

  /// Are all of the piece's points off the ray, for certain if nothing underflows? Van Wijk's
  /// rectangle tests of sections 3 to 5, as bounds of the equation over the rectangle, each less a
  /// bound on its rounding. (The twelve cases of section 5 decide the same for the hyperbola.)
  [[nodiscard]] bool rules_out(const geometry::Ray<Number>& local, std::uint32_t piece) const;

  /// The outward normal at a crossing, not of length one: van Wijk's, but the right n_z of a conic
  /// sweep, -(n_x u + n_y v). Contract: not at the apex of a conic sweep, nor on the axis.
  [[nodiscard]] geometry::Vector3<Number> normal(const geometry::Ray<Number>& local,
                                                 const Crossing& crossing) const;

 private:
  struct Piece {
    int degree;
    std::array<Number, 4> u;
    std::array<Number, 4> v;
    Number u_min, u_max, v_min, v_max;  // not inside the exact ones
    bool sweeps;                        // or is on the axis
    bool from_pole;                     // it begins where the surface meets the axis
    bool to_pole;                       // it ends there
  };

  // a v^2 + b v + c - d u^2 = 0 (equation 9 of van Wijk) or, with a and d zero, a line of v and u.
  struct Equation {
    Number u{0}, uu{0}, v{0}, vv{0}, constant{0};
    // The same, all products positive: the coefficients before anything cancels.
    Number most_u{0}, most_uu{0}, most_v{0}, most_vv{0}, most_constant{0};
  };

  [[nodiscard]] Equation equation(const geometry::Ray<Number>& local) const;
  [[nodiscard]] static bool rules_out(const Equation& e, const Piece& piece);
  [[nodiscard]] bool is_level(const geometry::Ray<Number>& local) const {
    return sweep_ == Sweep::Rotational && local.direction.z == 0;
  }
  [[nodiscard]] bool is_upright(const geometry::Ray<Number>& local) const {
    return sweep_ == Sweep::Rotational && local.direction.x == 0 && local.direction.y == 0;
  }
  // The s in 0 .. 1 at which the piece's equation holds for the ray.
  [[nodiscard]] poly::RealRoots<Number> roots_of(const Piece& piece, const Equation& e,
                                                 const geometry::Ray<Number>& local,
                                                 const poly::Solvers& solvers) const;
  void add_crossings(const geometry::Ray<Number>& local, std::uint32_t piece, const Number& s,
                     std::vector<Crossing>& crossings) const;

  Sweep sweep_;
  int orientation_;
  std::vector<Piece> pieces_;
};

}  // namespace lamina::surface
