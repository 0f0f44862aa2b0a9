// Sphere sweeps in a rounded number type.
#pragma once

#include <array>
#include <vector>

#include "geometry/vector.hpp"
#include "poly/solver.hpp"
#include "surface/rounded_sweep.hpp"
#include "surface/sphere_sweep.hpp"

namespace lamina::surface {

/// A sphere sweep in local coordinates, its trajectory's pieces rounded once.
template <number::RoundedNumber Number>
class RoundedSphereSweep {
 public:
  using Vector = geometry::Vector3<Number>;
  /// With the trajectory's parameter u for s, 0 <= u <= 1.
  using Crossing = typename RoundedSweep<Number>::Crossing;

  explicit RoundedSphereSweep(const SphereSweep& exact);

  /// Returns in `crossings`, ascending in t, where a ray in local coordinates enters and leaves the
  /// solid: of each piece whose bounding ball it meets, and with the ray set up at its point that
  /// is nearest to that ball's centre. With p = (c(u) - o).d and D = |d|^2 r^2 - |(c(u) - o) x d|^2
  /// the ball at u covers (p -+ sqrt(D)) / |d|^2. The union over a range of u with D > 0 is between
  /// the least and the greatest of them, at the range's ends, or where D'^2 = 4 D p'^2, of degree
  /// 10 in u; the roots of D' and of p' are tried as well, near which
  /// two of those are one as p' or D' gets small. Then intervals that overlap or touch are one. All
  /// roots, but those of p', are found by the solver of sextics. Returns false, and no crossings,
  /// for a ray at a distance of r all along a piece, as far as rounding tells, unless it is inside
  /// by other pieces there.
  ///
  /// Error:  at its least and greatest t has no slope in u, so that an error e of u changes it by
  ///         some e^2; there sqrt(D) is off by the roundings of D, some 40 u (r + |c - o|)^2 |d|^2,
  ///         over 2 sqrt(D). As the chord through the solid gets short, so does D: then t is off by
  ///         the square root of that, and chords that short are lost.
  bool find_crossings(const geometry::Ray<Number>& local, const poly::Solvers& solvers,
                      std::vector<Crossing>& crossings) const;

  /// From the trajectory's point to the crossing's: the outward normal, not of length one.
  [[nodiscard]] Vector normal(const Vector& local, const Crossing& crossing) const;

  /// Of a point: -1 inside, 0 on the surface, 1 outside, by its distance from the nearest point of
  /// the trajectory.
  [[nodiscard]] int side(const Vector& local, const poly::Solvers& solvers,
                         std::vector<Crossing>& scratch) const;
  /// As RoundedSweep has it: a bounded solid does not reach as far.
  [[nodiscard]] int side_at_minus_infinity(const geometry::Ray<Number>&,
                                           const std::vector<Crossing>&, const poly::Solvers&,
                                           std::vector<Crossing>&) const {
    return 1;
  }

  /// (|p - c(u)|^2 - r^2) / 2, which is zero on the ball at the crossing, and has normal() for its
  /// gradient.
  [[nodiscard]] Number value(const Vector& local, const Crossing& crossing) const;
  /// A bound on the error of value() at a point of the world, from the scene's numbers on.
  ///
  /// Arguments: magnitude  RoundedMap::magnitude of the point.
  [[nodiscard]] Number rounding_error(const Vector& magnitude, const Crossing& crossing) const;

 private:
  using Cubic = std::array<Number, 4>;
  using Curve = std::array<Cubic, 3>;

  struct Piece {
    Curve c;
    Vector centre;  // of a ball around all balls of the piece
    Number reach;   // its radius, not rounded down
  };

  // c(u) - p.
  [[nodiscard]] static Curve from(const Vector& p, Curve curve);
  [[nodiscard]] static Vector point(const Curve& curve, const Number& u);
  // Is the point that `gap` leads to from the centre out of reach, for certain if it is off by no
  // more than `error`?
  [[nodiscard]] static bool is_beyond(const Vector& gap, const Piece& piece, const Number& error);
  // To `walls` what a piece covers whose balls all touch the ray, else to `crossings`.
  void add_of_piece(const geometry::Ray<Number>& local, std::uint32_t piece, const Number& shift,
                    const poly::Solvers& solvers, std::vector<Crossing>& crossings,
                    std::vector<Crossing>& walls) const;

  Number radius_;
  std::vector<Piece> pieces_;
};

}  // namespace lamina::surface
