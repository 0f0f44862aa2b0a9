// An oracle for swept contours: the ray in the contour's parameter, by FLINT and Arb.
//
// It solves van Wijk's equations (1984, numbers 2, 6 and 9) for s, piece by piece, and encloses t
// at each root. From the project it takes GMP's numbers as bare types; the pieces are made anew.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "number/rational.hpp"

namespace lamina::reference {

/// A polygon, and what curve it stands for.
struct PlaneCurve {
  enum class Kind : std::uint8_t { Line, BSpline, CatmullRom };

  Kind kind = Kind::Line;
  bool closed = true;  ///< or else from the axis u = 0 to it, continued by its mirror image
  std::vector<std::array<number::Rational, 2>> points;
};

enum class SweepKind : std::uint8_t { Translational, Conic, Rotational };

class SweptCurve {
 public:
  using Rational = number::Rational;
  using Polynomial = std::vector<Rational>;  ///< ascending
  using Point = std::array<Rational, 3>;

  /// u and v of s, for 0 <= s < 1.
  struct Piece {
    Polynomial u;
    Polynomial v;
  };

  /// Why the crossings are not all that this formulation could find: the last that holds.
  enum class Doubt : std::uint8_t {
    None,
    Inseparable,  ///< what is not equal could not be told apart
    Joint,        ///< a root is exactly at an end of a piece
    InSurface,    ///< the equation of a piece holds for all of it
    NoEquation,   ///< all of the ray has one u and v, or, of a rotational sweep, one v
  };

  /// t is between the bounds, both included.
  struct Crossing {
    Rational lower;
    Rational upper;
    std::size_t piece = 0;
    unsigned multiplicity = 1;  ///< of s: odd
  };

  struct Crossings {
    Doubt doubt = Doubt::None;
    bool has_piece_along = false;     ///< the equation of a piece holds for all of it
    std::size_t touches = 0;          ///< roots of even multiplicity, which are left out
    std::size_t isolated = 0;         ///< pieces that might have a root by their coefficients
    std::vector<Crossing> crossings;  ///< ascending and disjoint if there is no doubt
  };

  enum class Membership : std::uint8_t { Inside, Outside, Undecided };

  /// The curve does not cross itself; that of a rotational sweep has u >= 0.
  SweptCurve(SweepKind kind, const PlaneCurve& curve);

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  [[nodiscard]] Crossings crossings(const Point& origin, const Point& direction) const;

  /// By counting where half-lines from (u, v) along the axes of the plane cross the curve.
  /// Undecided on the surface, at z = 0 of a conic sweep, and where every half-line meets a joint
  /// or runs along a piece.
  [[nodiscard]] Membership membership(const Point& point) const;

 private:
  [[nodiscard]] Crossings attempt(const Point& origin, const Point& direction, int bits) const;

  SweepKind kind_;
  bool closed_;
  std::vector<Piece> pieces_;
};

}  // namespace lamina::reference
