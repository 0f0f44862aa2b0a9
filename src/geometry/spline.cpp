#include "geometry/spline.hpp"

#include <fmt/format.h>

#include "base/contract.hpp"

namespace lamina::geometry {

using number::Rational;

namespace {

using Coefficients = std::vector<Rational>;

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

}  // namespace

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

Rational value_at(std::span<const Rational> ascending, const Rational& s) {
  Rational sum = 0;
  for (auto c = ascending.rbegin(); c != ascending.rend(); ++c) {
    sum = sum * s + *c;
  }
  return sum;
}

std::vector<Rational> spline_piece(ContourKind kind, const std::array<Rational, 4>& p) {
  switch (kind) {
    case ContourKind::Line:
      return line(p[1], p[2]);
    case ContourKind::BSpline:
      return b_spline(p[0], p[1], p[2], p[3]);
    case ContourKind::CatmullRom:
      break;
  }
  return catmull_rom(p[0], p[1], p[2], p[3]);
}

std::vector<Rational> bezier(const std::vector<Rational>& ascending) {
  const std::size_t degree = ascending.size() - 1;
  std::vector<Rational> result;
  for (std::size_t k = 0; k <= degree; ++k) {
    Rational& coefficient = result.emplace_back(ascending.front());
    Rational weight = 1;  // binomial(k, i) / binomial(degree, i)
    for (std::size_t i = 1; i <= k; ++i) {
      weight *= Rational(k + 1 - i, degree + 1 - i);
      coefficient += weight * ascending[i];
    }
  }
  return result;
}

void require_distinct_points(std::size_t count, bool closed,
                             const std::function<bool(std::size_t, std::size_t)>& are_equal) {
  const std::size_t least = closed ? 3 : 2;
  if (count < least) {
    throw base::InputError(fmt::format("{} contour needs {} points or more, here are {}",
                                       closed ? "a closed" : "an open", least, count));
  }
  for (std::size_t i = 1; i < count; ++i) {
    if (are_equal(i - 1, i)) {
      throw base::InputError(
          fmt::format("point {} of the contour repeats point {}: leave one of them out", i + 1, i));
    }
  }
  if (closed && are_equal(0, count - 1)) {
    throw base::InputError(
        fmt::format("point {} of the contour, its last one, repeats point 1: leave the last one "
                    "out, since a closed contour goes back to the first point by itself",
                    count));
  }
}

}  // namespace lamina::geometry
