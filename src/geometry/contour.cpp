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

void require_enough_points(const std::vector<PlanePoint>& points, bool closed) {
  const std::size_t least = closed ? 3 : 2;
  if (points.size() < least) {
    throw base::InputError(fmt::format("{} contour needs {} points or more, here are {}",
                                       closed ? "a closed" : "an open", least, points.size()));
  }
}

void require_unequal_neighbours(const std::vector<PlanePoint>& points, bool closed) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] == points[i]) {
      throw base::InputError(
          fmt::format("point {} of the contour repeats point {}: leave one of them out", i + 1, i));
    }
  }
  if (closed && points.front() == points.back()) {
    throw base::InputError(
        fmt::format("point {} of the contour, its last one, repeats point 1: leave the last one "
                    "out, since a closed contour goes back to the first point by itself",
                    points.size()));
  }
}

void require_on_axis(const PlanePoint& point, std::string_view does, std::size_t index) {
  if (!point.u.is_zero()) {
    throw base::InputError(
        fmt::format("an open contour {} on the axis u = 0, but point {} has u = {}: set it to 0 or "
                    "close the contour",
                    does, index + 1, number::to_text(point.u)));
  }
}

void require_points(const std::vector<PlanePoint>& points, bool closed) {
  require_enough_points(points, closed);
  require_unequal_neighbours(points, closed);
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

Coefficients line(const Rational& p, const Rational& next) { return {p, next - p}; }

// The sum of (1-s)^3/6 p0, (3s^3-6s^2+4)/6 p1, (-3s^3+3s^2+3s+1)/6 p2 and s^3/6 p3.
Coefficients b_spline(const Rational& p0, const Rational& p1, const Rational& p2,
                      const Rational& p3) {
  return {(p0 + 4 * p1 + p2) / 6, (p2 - p0) / 2, (p0 - 2 * p1 + p2) / 2,
          (3 * (p1 - p2) + p3 - p0) / 6};
}

// From p1 to p2 with the derivatives (p2-p0)/2 and (p3-p1)/2.
Coefficients catmull_rom(const Rational& p0, const Rational& p1, const Rational& p2,
                         const Rational& p3) {
  return {p1, (p2 - p0) / 2, (2 * p0 - 5 * p1 + 4 * p2 - p3) / 2, (3 * (p1 - p2) + p3 - p0) / 2};
}

ContourPiece piece_of(ContourKind kind, std::span<const PlanePoint, 4> p) {
  switch (kind) {
    case ContourKind::Line:
      return {line(p[1].u, p[2].u), line(p[1].v, p[2].v)};
    case ContourKind::BSpline:
      return {b_spline(p[0].u, p[1].u, p[2].u, p[3].u), b_spline(p[0].v, p[1].v, p[2].v, p[3].v)};
    case ContourKind::CatmullRom:
      break;
  }
  return {catmull_rom(p[0].u, p[1].u, p[2].u, p[3].u), catmull_rom(p[0].v, p[1].v, p[2].v, p[3].v)};
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

Coefficients bezier(const Coefficients& c) {
  if (c.size() == 2) {
    return {c[0], c[0] + c[1]};
  }
  return {c[0], c[0] + c[1] / 3, c[0] + (2 * c[1] + c[2]) / 3, c[0] + c[1] + c[2] + c[3]};
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

Rational value_at(std::span<const Rational> ascending, const Rational& s) {
  Rational sum = 0;
  for (auto c = ascending.rbegin(); c != ascending.rend(); ++c) {
    sum = sum * s + *c;
  }
  return sum;
}

std::string_view name_of(ContourKind kind) {
  switch (kind) {
    case ContourKind::Line:
      return "line";
    case ContourKind::BSpline:
      return "bspline";
    case ContourKind::CatmullRom:
      break;
  }
  return "catmull_rom";
}

ContourKind parse_contour_kind(std::string_view name) {
  for (const ContourKind kind :
       {ContourKind::Line, ContourKind::BSpline, ContourKind::CatmullRom}) {
    if (name_of(kind) == name) {
      return kind;
    }
  }
  throw base::InputError(
      fmt::format("unknown kind of contour '{}': one of line, bspline, catmull_rom", name));
}

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
