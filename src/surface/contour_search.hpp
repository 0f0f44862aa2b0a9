// Where a ray's image crosses a piece of a contour, without its polynomial in s: by halving the
// piece.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "surface/ray_image.hpp"

namespace lamina::surface {

/// A part of a piece, from s = `from` on: its Bezier control points.
template <number::RoundedNumber Number>
struct BezierPart {
  std::array<Number, 4> u;
  std::array<Number, 4> v;
  Number from{0};
  Number width{1};

  [[nodiscard]] std::array<Number, 2> point(std::size_t i) const { return {u[i], v[i]}; }

  [[nodiscard]] PlaneBox<Number> box() const {
    const auto [u_min, u_max] = std::minmax({u[0], u[1], u[2], u[3]});
    const auto [v_min, v_max] = std::minmax({v[0], v[1], v[2], v[3]});
    return {u_min, u_max, v_min, v_max};
  }

  /// By de Casteljau; where they meet they have the same point. s is exact while the width is not
  /// below the unit roundoff.
  [[nodiscard]] std::array<BezierPart, 2> halves() const {
    const Number half_width = Number(0.5) * width;
    std::array<BezierPart, 2> two{BezierPart{u, v, from, half_width},
                                  BezierPart{u, v, from + half_width, half_width}};
    halve(u, two[0].u, two[1].u);
    halve(v, two[0].v, two[1].v);
    return two;
  }

 private:
  static void halve(const std::array<Number, 4>& c, std::array<Number, 4>& low,
                    std::array<Number, 4>& high) {
    const Number half(0.5);
    const Number middle = half * (c[1] + c[2]);
    low[1] = half * (c[0] + c[1]);
    high[2] = half * (c[2] + c[3]);
    low[2] = half * (low[1] + middle);
    high[1] = half * (middle + high[2]);
    low[3] = high[0] = half * (low[2] + high[1]);
  }
};

/// A contour's piece, its exact numbers rounded once.
template <number::RoundedNumber Number>
struct RoundedPiece {
  int degree;
  std::array<Number, 4> u;
  std::array<Number, 4> v;
  BezierPart<Number> control;  // ends where the next piece's begins, to the bit
  PlaneBox<Number> box;        // not inside the exact one
  bool sweeps;                 // or is on the axis
  bool from_pole;              // it begins where the surface meets the axis
  bool to_pole;                // it ends there
};

namespace detail {

template <number::RoundedNumber Number>
Number cubic_at(const std::array<Number, 4>& c, const Number& s) {
  return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
}

// What the searches have in common: they go by the signs of the image's left side at the ends of
// parts, 0 counting as positive. Neighbours share these to the bit, and a part is only left out
// where both its ends have one sign, so that around a closed contour crossings are even in number.
template <number::RoundedNumber Number>
struct PieceSearch {
  const RayImage<Number>& image;
  const RoundedPiece<Number>& piece;

  // The left side at an end of a part. On the axis it is never negative, but by rounding.
  [[nodiscard]] Number at_end(const BezierPart<Number>& part, bool high) const {
    const auto [u, v] = part.point(high ? 3 : 0);
    const bool at_pole =
        high ? piece.to_pole && part.from + part.width == 1 : piece.from_pole && part.from == 0;
    const Number value = image.at(u, v);
    return at_pole && image.depends_on_u() && value < 0 ? Number(0) : value;
  }

  // Is the piece on a line that the ray's image is?
  [[nodiscard]] bool holds_all_along() const {
    for (std::size_t i = 0; i < 4; ++i) {
      if (image.at(piece.control.u[i], piece.control.v[i]) != 0) {
        return false;
      }
    }
    return image.is_line();
  }
};

}  // namespace detail

namespace detail {

// The left side over the hull of a part's control points: a point of it is their weighted mean, and
// the left side there that of the polar forms of all pairs. These have 11 roundings at most, and so
// the bound of the rectangle.
template <number::RoundedNumber Number>
ImageBounds<Number> over_hull(const RayImage<Number>& image, const BezierPart<Number>& part,
                              const Number& rounding) {
  ImageBounds<Number> bounds{image.polar(part.point(0), part.point(0)), Number(0), rounding};
  bounds.greatest = bounds.least;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = image.is_line() ? i : 0; j <= i; ++j) {
      const Number value = image.polar(part.point(i), part.point(j));
      bounds.least = std::min(bounds.least, value);
      bounds.greatest = std::max(bounds.greatest, value);
    }
  }
  return bounds;
}

}  // namespace detail

/// Calls cross(s) with each s, ascending, at which the image crosses the piece, by Catmull's
/// subdivision (van Wijk 1984, section 7; Catmull 1974): the rectangle of the control points is
/// tested, and the piece halved. At a tangency of slope not 0 rectangles alone are excluded where
/// they are smaller than their distance from it squared, which takes u^-1/2 of them, and along a
/// straight piece u^-1; so where the rectangle is met, the hull of the control points is tested
/// too, which takes some log u. A part is halved no further where
/// - the left side's greatest and least value over the hull differ by no more than the bound on
///   their rounding: a half could be excluded by chance only; or
/// - s itself has no numbers in between, whose spacing below 1 is the unit roundoff.
/// Parts that are left and neighbours are one cluster: a crossing if the left side has not the same
/// sign at its ends, found by bisection there, and else a touch. Returns false if the piece is part
/// of the image.
///
/// Error:  of s, the unit roundoff, and what moves the left side by its rounding, 16 u times its
///         absolute terms, and the points by theirs, at most 2 u of the largest coordinate for each
///         halving. Near a tangency the cluster is some square root of that wide: two crossings in
///         one are none. A touch at a joint, where a cluster ends whatever is behind it, may be two
///         crossings.
template <number::RoundedNumber Number, typename Cross>
bool cross_by_subdivision(const RayImage<Number>& image, const RoundedPiece<Number>& piece,
                          const Cross& cross) {
  const detail::PieceSearch<Number> search{image, piece};
  if (search.holds_all_along()) {
    return false;
  }
  struct Cluster {
    bool open = false;
    Number low, high;
    bool low_negative, high_negative;
  } cluster;

  const auto close = [&] {
    if (cluster.open && cluster.low_negative != cluster.high_negative) {
      Number low = cluster.low;
      Number high = cluster.high;
      while (high - low > number::unit_roundoff<Number>()) {
        const Number middle = Number(0.5) * (low + high);
        if (!(low < middle && middle < high)) {
          break;
        }
        const Number value =
            image.at(detail::cubic_at(piece.u, middle), detail::cubic_at(piece.v, middle));
        ((value < 0) == cluster.low_negative ? low : high) = middle;
      }
      cross(Number(0.5) * (low + high));
    }
    cluster.open = false;
  };
  const auto divide = [&](const auto& self, const BezierPart<Number>& part, int halvings) -> void {
    ImageBounds<Number> bounds = image.over(part.box());
    if (!bounds.exclude_zero()) {
      bounds = detail::over_hull(image, part, bounds.rounding);
    }
    if (bounds.exclude_zero()) {
      close();
    } else if (halvings > 0 && bounds.greatest - bounds.least > bounds.rounding) {
      for (const BezierPart<Number>& half : part.halves()) {
        self(self, half, halvings - 1);
      }
    } else {
      if (!cluster.open) {
        cluster.open = true;
        cluster.low = part.from;
        cluster.low_negative = search.at_end(part, false) < 0;
      }
      cluster.high = part.from + part.width;
      cluster.high_negative = search.at_end(part, true) < 0;
    }
  };
  divide(divide, piece.control, number::number_traits<Number>::kSignificandBits);
  close();
  return true;
}

namespace detail {

// The left side over a part's strip: the rectangle along its chord that holds its control points.
// It lies between the nine Bernstein coefficients of the left side over the strip. These have 11
// roundings at most, and a corner, a control point plus two multiples of the chord, is off by less
// than 10 u of the points' distance, which is below 3 times the largest coordinate, and 3 u of
// that: less than 33 u of it, counted twice where a coordinate is squared. 128 u is more.
template <number::RoundedNumber Number>
ImageBounds<Number> over_strip(const RayImage<Number>& image, const BezierPart<Number>& part) {
  using std::abs;
  const auto& u = part.u;
  const auto& v = part.v;
  Number along_u = u[3] - u[0];
  Number along_v = v[3] - v[0];
  Number square = along_u * along_u + along_v * along_v;
  if (!(square > 0)) {  // any direction will do
    along_u = square = Number(1);
    along_v = Number(0);
  }
  Number x_min(0), x_max(0), y_min(0), y_max(0);
  for (std::size_t i = 1; i < 4; ++i) {
    const Number du = u[i] - u[0];
    const Number dv = v[i] - v[0];
    const Number x = (along_u * du + along_v * dv) / square;
    const Number y = (along_u * dv - along_v * du) / square;
    x_min = std::min(x_min, x);
    x_max = std::max(x_max, x);
    y_min = std::min(y_min, y);
    y_max = std::max(y_max, y);
  }
  const auto corner = [&](const Number& x, const Number& y) -> std::array<Number, 2> {
    return {u[0] + x * along_u - y * along_v, v[0] + x * along_v + y * along_u};
  };
  const auto a = corner(x_min, y_min);
  const auto b = corner(x_max, y_min);
  const auto c = corner(x_min, y_max);
  const auto d = corner(x_max, y_max);
  const auto [least, greatest] =
      std::minmax({image.polar(a, a), image.polar(b, b), image.polar(c, c), image.polar(d, d),
                   image.polar(a, b), image.polar(c, d), image.polar(a, c), image.polar(b, d),
                   Number(Number(0.5) * (image.polar(a, d) + image.polar(b, c)))});
  const auto largest = [&](std::size_t i) {
    return std::max({Number(abs(a[i])), Number(abs(b[i])), Number(abs(c[i])), Number(abs(d[i]))});
  };
  return {least, greatest,
          128 * number::unit_roundoff<Number>() * image.terms(largest(0), largest(1))};
}

// Calls cross(x) with each x in 0 .. 1 at which b_0 (1 - x)^2 + 2 b_1 x (1 - x) + b_2 x^2 changes
// its sign, 0 counting as positive: one root if the ends differ, and else none or two, whatever is
// rounded. With y = x / (1 - x) it is b_2 y^2 + 2 b_1 y + b_0.
template <number::RoundedNumber Number, typename Cross>
void cross_quadratic(std::array<Number, 3> b, const Cross& cross) {
  using std::abs;
  using std::sqrt;
  const Number largest = std::max({Number(abs(b[0])), Number(abs(b[1])), Number(abs(b[2]))});
  if (!(largest > 0)) {
    return;
  }
  for (Number& c : b) {
    c = c / largest;
  }
  const bool differ = (b[0] < 0) != (b[2] < 0);
  const Number discriminant = b[1] * b[1] - b[0] * b[2];
  if (!differ && (!(discriminant > 0) || (b[1] < 0) == (b[0] < 0))) {
    return;
  }
  const Number root = sqrt(discriminant);
  const Number q = b[1] < 0 ? Number(root - b[1]) : Number(-root - b[1]);
  const auto low = [&] { return Number(b[0] / (b[0] + q)); };
  const auto high = [&] { return Number(q / (q + b[2])); };
  if (q == 0) {  // at an end, where it does not turn
    cross(Number(b[0] == 0 ? 0 : 1));
  } else if (differ) {
    cross((q < 0) == (b[0] < 0) ? low() : high());
  } else {
    const auto [first, second] = std::minmax({low(), high()});
    cross(first);
    cross(second);
  }
}

}  // namespace detail

/// Calls cross(s) with each s, ascending, at which the image crosses the piece, by its strip tree
/// (Ballard 1981; Kajiya 1983): the strips that the image meets are halved down to those whose
/// chord, run through evenly, is the curve but for the rounding of its points, and there the image
/// is intersected with the chord. Returns false if the piece is part of the image.
///
/// A strip's points are at most 3/4 of the second differences of its control points off its chord.
/// These are at most four times the largest coordinate, and a quarter of that after each halving;
/// 8 u of it is what rounding leaves of them: half as many halvings as the significand has bits
/// get there. Nor is a strip halved over which the left side is 0 but for its own rounding, as that
/// of a ray from far away. A tree kept for all rays would have 2^26 strips of each piece in double:
/// they are made on the ray.
///
/// Error:  of s, 12 u and what moves the left side by its rounding, 16 u times its absolute terms,
///         and the points by theirs, 8 u; it is so at tangencies too: two crossings of one chord
///         are told from none by a discriminant, those of two by the sign between them.
template <number::RoundedNumber Number, typename Cross>
bool cross_by_strips(const RayImage<Number>& image, const RoundedPiece<Number>& piece,
                     const Cross& cross) {
  using std::abs;
  const detail::PieceSearch<Number> search{image, piece};
  if (search.holds_all_along()) {
    return false;
  }
  Number largest(0);
  for (std::size_t i = 0; i < 4; ++i) {
    largest = std::max({largest, Number(abs(piece.control.u[i])), Number(abs(piece.control.v[i]))});
  }
  const Number rounding = 8 * number::unit_roundoff<Number>() * largest;
  const auto is_even = [&rounding](const std::array<Number, 4>& c) {
    return abs(c[0] - 2 * c[1] + c[2]) <= rounding && abs(c[1] - 2 * c[2] + c[3]) <= rounding;
  };
  const auto divide = [&](const auto& self, const BezierPart<Number>& part, int halvings) -> void {
    const ImageBounds<Number> bounds = detail::over_strip(image, part);
    if (bounds.exclude_zero()) {
      return;
    }
    if (halvings > 0 && 8 * (bounds.greatest - bounds.least) > bounds.rounding &&
        !(is_even(part.u) && is_even(part.v))) {
      for (const BezierPart<Number>& half : part.halves()) {
        self(self, half, halvings - 1);
      }
      return;
    }
    detail::cross_quadratic<Number>(
        {search.at_end(part, false), image.polar(part.point(0), part.point(3)),
         search.at_end(part, true)},
        [&](const Number& x) { cross(Number(part.from + x * part.width)); });
  };
  divide(divide, piece.control, number::number_traits<Number>::kSignificandBits / 2);
  return true;
}

}  // namespace lamina::surface
