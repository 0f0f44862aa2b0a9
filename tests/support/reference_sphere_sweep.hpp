// An oracle for sphere sweeps: the ray in the trajectory's parameter, by FLINT and Arb.
//
// It finds which balls meet the ray, and among these the first and last points by calculus in the
// parameter, encloses them, and joins the intervals. No t is eliminated, no point of the ray
// sampled. From the project it takes GMP's numbers as bare types; the pieces are made anew.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/reference_sweep.hpp"

namespace lamina::reference {

/// A polygon in space, and what curve it stands for; an open one is continued at its ends by the
/// reflection of the neighbour.
struct SpaceCurve {
  PlaneCurve::Kind kind = PlaneCurve::Kind::Line;
  bool closed = true;
  std::vector<std::array<number::Rational, 3>> points;
};

class SweptBall {
 public:
  using Rational = number::Rational;
  using Polynomial = std::vector<Rational>;  ///< ascending
  using Point = std::array<Rational, 3>;
  using Piece = std::array<Polynomial, 3>;  ///< x, y and z of u, for 0 <= u <= 1

  /// Between these, both included.
  struct Bounds {
    Rational lower;
    Rational upper;
  };

  struct Crossings {
    bool has_piece_along = false;   ///< all balls of a piece touch the line: nothing else is said
    bool is_inseparable = false;    ///< what may be equal could not be told apart: no crossings
    std::size_t ranges = 0;         ///< of the parameter, in which balls meet the line
    std::size_t overlaps = 0;       ///< intervals of t that are part of one before
    std::vector<Bounds> crossings;  ///< ascending and disjoint
  };

  SweptBall(const SpaceCurve& curve, const Rational& radius);

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  [[nodiscard]] Crossings crossings(const Point& origin, const Point& direction) const;

  /// -1 inside, 1 outside, 0 on the ball at a piece's end and nowhere inside; nothing where the
  /// distance from the curve may be the radius elsewhere.
  [[nodiscard]] std::optional<int> side(const Point& point) const;

 private:
  [[nodiscard]] Crossings attempt(const Point& origin, const Point& direction, int bits) const;

  bool closed_;
  Rational radius_;
  std::vector<Piece> pieces_;
};

}  // namespace lamina::reference
