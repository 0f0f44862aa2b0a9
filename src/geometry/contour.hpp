// Planar contours: closed curves, or curves from the axis to the axis, in polynomial pieces; exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/spline.hpp"
#include "number/rational.hpp"

namespace lamina::geometry {

/// A point of the contour's plane (van Wijk 1984, section 2).
struct PlanePoint {
  number::Rational u;
  number::Rational v;

  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// (u(s), v(s)) for 0 <= s < 1.
struct ContourPiece {
  std::vector<number::Rational> u;  ///< coefficients of 1, s, s^2, s^3: two or four of them
  std::vector<number::Rational> v;  ///< as many
};

struct Rectangle {
  number::Rational u_min;
  number::Rational u_max;
  number::Rational v_min;
  number::Rational v_max;
};

/// A contour that does not cross or touch itself. Immutable, so that several surfaces share one.
class Contour {
 public:
  /// A closed contour goes from the last point back to the first. An open one begins and ends on
  /// the axis u = 0, at the first and last point of a polygon or a Catmull-Rom spline; it is
  /// continued by its mirror image there, so that splines cross the axis at a right angle.
  ///
  /// Throws base::InputError, which names the point by its number from 1, if there are fewer than
  /// three points (two for an open contour), if two in a row are equal, if an open one does not
  /// begin and end on the axis, or if the curve crosses or touches itself.
  Contour(std::vector<PlanePoint> points, ContourKind kind, bool closed);

  [[nodiscard]] const std::vector<PlanePoint>& points() const { return points_; }
  [[nodiscard]] ContourKind kind() const { return kind_; }
  [[nodiscard]] bool closed() const { return closed_; }

  /// In order; each begins where the one before it ends. Piece i of a polygon or a Catmull-Rom
  /// spline goes from point i to the next; that of a B-spline begins near point i.
  [[nodiscard]] std::span<const ContourPiece> pieces() const { return pieces_; }
  /// The rectangle of each piece's Bezier control points: the piece lies in it.
  [[nodiscard]] std::span<const Rectangle> control_boxes() const { return control_boxes_; }
  /// The rectangle of each piece itself: its extrema, enclosed to 2^-60 of its control box.
  [[nodiscard]] std::span<const Rectangle> boxes() const { return boxes_; }

  /// 1 if the inside is on the left when s grows, -1 if on the right: the sign of the area, to
  /// which the axis closes an open contour.
  [[nodiscard]] int orientation() const;

  /// For a contour that is turned about the axis u = 0. Throws base::InputError, which names the
  /// point whose piece gets there, unless u >= 0 all along.
  void require_right_of_axis() const;

 private:
  std::vector<PlanePoint> points_;
  ContourKind kind_;
  bool closed_;
  std::vector<ContourPiece> pieces_;
  std::vector<Rectangle> control_boxes_;
  std::vector<Rectangle> boxes_;
};

}  // namespace lamina::geometry
