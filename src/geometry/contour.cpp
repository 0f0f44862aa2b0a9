#include "geometry/contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/contract.hpp"
#include "geometry/contour_crossings.hpp"
#include "number/algebraic.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Coefficients = std::vector<Rational>;

void require_on_axis(const PlanePoint& point, std::string_view does, std::size_t index) {
  if (!point.u.is_zero()) {
    throw base::InputError(
        fmt::format("an open contour {} on the axis u = 0, but point {} has u = {}: set it to 0 or "
                    "close the contour",
                    does, index + 1, number::to_text(point.u)));
  }
}

void require_points(const std::vector<PlanePoint>& points, bool closed) {
  require_distinct_points(points.size(), closed, [&points](std::size_t i, std::size_t j) {
    return points[i] == points[j];
  });
  if (!closed) {
    require_on_axis(points.front(), "begins", 0);
    require_on_axis(points.back(), "ends", points.size() - 1);
  }
}

PlanePoint mirrored(const PlanePoint& point) { return {-point.u, point.v}; }

// One point more at the front and two at the back: piece i depends on entries i to i + 3.
std::vector<PlanePoint> continued(const std::vector<PlanePoint>& points, bool closed) {
  const std::size_t n = points.size();
  std::vector<PlanePoint> result{closed ? points[n - 1] : mirrored(points[1])};
  result.insert(result.end(), points.begin(), points.end());
  if (closed) {
    result.push_back(points[0]);
    result.push_back(points[1]);
  } else {
    result.push_back(mirrored(points[n - 2]));
  }
  return result;
}

ContourPiece piece_of(ContourKind kind, std::span<const PlanePoint, 4> p) {
  return {spline_piece(kind, {p[0].u, p[1].u, p[2].u, p[3].u}),
          spline_piece(kind, {p[0].v, p[1].v, p[2].v, p[3].v})};
}

std::vector<ContourPiece> pieces_of(const std::vector<PlanePoint>& points, ContourKind kind,
                                    bool closed) {
  const std::vector<PlanePoint> all = continued(points, closed);
  std::vector<ContourPiece> pieces;
  for (std::size_t i = 0; i + 3 < all.size(); ++i) {
    pieces.push_back(piece_of(kind, std::span(all).subspan(i).first<4>()));
  }
  return pieces;
}

ControlPolygon control_polygon(const ContourPiece& piece) {
  const Coefficients u = bezier(piece.u);
  const Coefficients v = bezier(piece.v);
  ControlPolygon polygon;
  for (std::size_t i = 0; i < u.size(); ++i) {
    polygon.push_back({u[i], v[i]});
  }
  return polygon;
}

Rectangle bounding_rectangle(const ControlPolygon& polygon) {
  Rectangle r{polygon[0].u, polygon[0].u, polygon[0].v, polygon[0].v};
  for (const PlanePoint& p : polygon) {
    r = {std::min(r.u_min, p.u), std::max(r.u_max, p.u), std::min(r.v_min, p.v),
         std::max(r.v_max, p.v)};
  }
  return r;
}

// Where the derivative is zero inside (0, 1); none if it is zero all along.
std::vector<number::Root> turning_points(const Coefficients& c) {
  Coefficients derivative;
  for (std::size_t power = 1; power < c.size(); ++power) {
    derivative.push_back(c[power] * static_cast<long>(power));
  }
  const number::IntegerPolynomial polynomial = number::with_cleared_denominators(derivative);
  if (polynomial.degree() < 1) {
    return {};
  }
  std::vector<number::Root> roots = number::real_roots(polynomial);
  std::erase_if(roots, [](const number::Root& root) {
    return compare(root, Rational(0)) <= 0 || compare(root, Rational(1)) >= 0;
  });
  return roots;
}

// Bounds of the cubic's value at a zero of its derivative. At most w away from it the value differs
// by at most w^2/2 max |f''| = w^2 (|c2| + 3 |c3|). Here w <= 2^-40, and of a control box of size 1
// |c2| <= 6 and |c3| <= 4, so that the bounds exceed the value by less than 2^-74.
number::Enclosure extremum(const Coefficients& c, const number::Root& root) {
  const number::Enclosure s = number::enclosure(root, 40);
  const Rational lower = std::max(s.lower, Rational(0));  // |f''| is bounded on [0, 1] only
  const Rational width = std::min(s.upper, Rational(1)) - lower;
  const Rational middle = value_at(c, lower);
  const Rational error = width * width * (abs(c[2]) + 3 * abs(c[3]));
  return {middle - error, middle + error};
}

// The range of values on [0, 1].
number::Enclosure range(const Coefficients& c) {
  const Rational end = value_at(c, 1);
  number::Enclosure result{std::min(c[0], end), std::max(c[0], end)};
  for (const number::Root& root : turning_points(c)) {
    const number::Enclosure turn = extremum(c, root);
    result = {std::min(result.lower, turn.lower), std::max(result.upper, turn.upper)};
  }
  return result;
}

Rectangle tight_rectangle(const ContourPiece& piece, const Rectangle& control_box) {
  const number::Enclosure u = range(piece.u);
  const number::Enclosure v = range(piece.v);
  return {std::max(u.lower, control_box.u_min), std::min(u.upper, control_box.u_max),
          std::max(v.lower, control_box.v_min), std::min(v.upper, control_box.v_max)};
}

bool gets_negative(const Coefficients& c) {
  if (c[0] < 0 || value_at(c, 1) < 0) {
    return true;
  }
  const number::IntegerPolynomial polynomial = number::with_cleared_denominators(c);
  const std::vector<number::Root> turns = turning_points(c);
  return std::any_of(turns.begin(), turns.end(), [&](const number::Root& turn) {
    return number::sign_at(polynomial, turn) < 0;
  });
}

}  // namespace

Contour::Contour(std::vector<PlanePoint> points, ContourKind kind, bool closed)
    : points_(std::move(points)), kind_(kind), closed_(closed) {
  require_points(points_, closed);
  pieces_ = pieces_of(points_, kind, closed);
  std::vector<ControlPolygon> polygons;
  for (const ContourPiece& piece : pieces_) {
    polygons.push_back(control_polygon(piece));
    control_boxes_.push_back(bounding_rectangle(polygons.back()));
    boxes_.push_back(tight_rectangle(piece, control_boxes_.back()));
  }
  require_no_crossing(polygons, closed);
}

int Contour::orientation() const {
  Rational area = 0;  // the integral of u dv, which is zero along the axis
  for (const ContourPiece& piece : pieces_) {
    for (std::size_t i = 0; i < piece.u.size(); ++i) {
      for (std::size_t j = 1; j < piece.v.size(); ++j) {
        area += piece.u[i] * piece.v[j] * Rational(j, i + j);
      }
    }
  }
  return area.sign();
}

void Contour::require_right_of_axis() const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (control_boxes_[i].u_min < 0 && gets_negative(pieces_[i].u)) {
      throw base::InputError(
          fmt::format("the contour crosses the axis u = 0 near point {}, between it and point {}: "
                      "move the points there to larger u",
                      i + 1, (i + 1) % points_.size() + 1));
    }
  }
}

}  // namespace lamina::geometry
