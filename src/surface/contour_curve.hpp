// The curves that the pieces of a swept contour are parts of, and where a ray meets them: one
// polynomial in t for each, over the rationals or over intervals.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/contour.hpp"
#include "geometry/vector.hpp"
#include "number/interval.hpp"
#include "surface/polynomials.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {

/// The sign of a number, none if it is not certain.
inline std::optional<int> certain_sign(const number::Rational& value) { return value.sign(); }
inline std::optional<int> certain_sign(const number::Interval& value) { return value.sign(); }

/// A rational as a number of the same kind as another one, of as many bits.
inline const number::Rational& as_in(const number::Rational& /*like*/,
                                     const number::Rational& value) {
  return value;
}
inline number::Interval as_in(const number::Interval& like, const number::Rational& value) {
  return {value, like.bits()};
}

/// A ray where the contour is: homogeneous coordinates of its points in the (u, v) plane, each a
/// polynomial in t, ascending, with coefficients in a ring. Of a rotational sweep u is none, but
/// its square is.
template <typename Ring>
struct PlaneRayOver {
  std::optional<std::vector<Ring>> u;
  std::vector<Ring> u_squared;
  std::vector<Ring> v;
  std::vector<Ring> w;
};

/// Of a line whose coordinates x, y, z in the sweep's place and 1 are these polynomials in t.
template <typename Ring>
PlaneRayOver<Ring> plane_ray(const SweptSurface& surface,
                             const std::array<std::vector<Ring>, 4>& line) {
  const auto& [x, y, z, one] = line;
  switch (surface.sweep()) {
    case Sweep::Translational:
      return {x, {}, y, one};
    case Sweep::Conic:
      return {x, {}, y, z};
    case Sweep::Rotational: {
      std::vector<Ring> squared = multiply(x, x);
      add(squared, multiply(y, y));
      return {{}, std::move(squared), z, one};
    }
    case Sweep::GeneralisedConic: {
      const auto& [p, q] = surface.scaling();
      const auto held = [&like = line[3][0]](const number::Rational& c) { return as_in(like, c); };
      std::vector<Ring> scale_x = composed(p, z, held);
      if (p == q) {
        return {x, {}, y, std::move(scale_x)};
      }
      const std::vector<Ring> scale_y = composed(q, z, held);
      return {multiply(x, scale_y), {}, multiply(y, scale_x), multiply(scale_x, scale_y)};
    }
  }
  return {};
}

/// Of an exact ray: constants and coefficients of t, zero or not.
PlaneRayOver<number::Rational> plane_ray(const SweptSurface& surface,
                                         const geometry::ExactRay& local);

/// A curve g = 0 in the contour's plane, g a form of a degree in (u, v, w), or for a rotational
/// sweep in (u^2, v, w), where u^2 is of degree 2: coprime integer coefficients in the order of the
/// exponents, the first one positive. Two curves are equal if and only if their points are, for a
/// rotational sweep those of the surfaces that they are turned to.
struct ContourCurve {
  struct Term {
    std::array<int, 3> exponents;  ///< of u or u^2, of v and of w
    number::Integer coefficient;   ///< not zero

    friend bool operator==(const Term&, const Term&) = default;
  };
  int degree = 0;
  std::vector<Term> terms;

  friend bool operator==(const ContourCurve&, const ContourCurve&) = default;
};

/// Returns the curve that a piece, which is not on a rotational sweep's axis, continues beyond its
/// ends: of degree 1 if it is straight, else of that of (u(s), v(s)); of a rotational sweep, unless
/// it is its own mirror image at the axis, of twice that, as it holds the mirror image too. Exact:
/// the resultant over s of u(s) - u and v(s) - v by Bezout's matrix.
ContourCurve curve_of(Sweep sweep, const geometry::ContourPiece& piece);
/// Returns where such a piece of a rotational sweep, continued, meets the axis: there curve_of's
/// form may be the square of this one, in (v, w).
ContourCurve curve_on_axis(const geometry::ContourPiece& piece);

/// The monomials of a ray's plane coordinates: computed once for a ray, used for all curves.
template <typename Ring>
class PlaneMonomials {
 public:
  explicit PlaneMonomials(const PlaneRayOver<Ring>& ray)
      : coordinates_{ray.u ? *ray.u : ray.u_squared, ray.v, ray.w} {}

  /// g along the ray: a polynomial in t, ascending, with no more coefficients than the lengths of
  /// the coordinates' polynomials allow.
  [[nodiscard]] std::vector<Ring> restrict(const ContourCurve& curve) {
    std::vector<Ring> sum;
    for (const auto& [exponents, coefficient] : curve.terms) {
      add(sum, monomial(exponents), coefficient);
    }
    return sum;
  }

 private:
  const std::vector<Ring>& monomial(const std::array<int, 3>& exponents) {
    std::size_t first = 0;
    while (exponents.at(first) == 0) {
      ++first;
    }
    std::array<int, 3> rest = exponents;
    --rest.at(first);
    if (rest == std::array<int, 3>{}) {
      return coordinates_.at(first);
    }
    const auto [known, is_new] = known_.try_emplace(exponents);
    if (is_new) {
      known->second = multiply(coordinates_.at(first), monomial(rest));
    }
    return known->second;
  }

  std::array<std::vector<Ring>, 3> coordinates_;
  std::map<std::array<int, 3>, std::vector<Ring>> known_;
};

/// Of u >= 0 whose enclosure may begin a little left of the axis.
inline number::Rational least_square(const geometry::Rectangle& box) {
  return box.u_min > 0 ? number::Rational(box.u_min * box.u_min) : number::Rational(0);
}

/// Van Wijk's rectangle test of section 3: are all corners on one side of the projected ray, a line
/// in the (u, v) plane, for certain? Not of a rotational sweep. What is not straight there, as in
/// generalised conic sweeps, is not told.
template <typename Ring>
bool line_misses(const PlaneRayOver<Ring>& ray, const geometry::Rectangle& box) {
  // The line through two of its points, in homogeneous coordinates: their cross product.
  const auto at = [](const std::vector<Ring>& p, std::size_t i) {
    return i < p.size() ? p[i] : Ring();
  };
  const std::vector<Ring>& u = *ray.u;
  if (u.size() > 2 || ray.v.size() > 2 || ray.w.size() > 2) {
    return false;
  }
  const Ring a = at(ray.v, 0) * at(ray.w, 1) - at(ray.w, 0) * at(ray.v, 1);
  const Ring b = at(ray.w, 0) * at(u, 1) - at(u, 0) * at(ray.w, 1);
  const Ring c = at(u, 0) * at(ray.v, 1) - at(ray.v, 0) * at(u, 1);
  std::optional<int> all;
  for (const Ring& along_u : {a * as_in(u[0], box.u_min) + c, a * as_in(u[0], box.u_max) + c}) {
    for (const number::Rational& corner_v : {std::cref(box.v_min), std::cref(box.v_max)}) {
      const std::optional<int> sign = certain_sign(along_u + b * as_in(u[0], corner_v));
      if (!sign || *sign == 0 || (all && *all != *sign)) {
        return false;
      }
      all = sign;
    }
  }
  return true;
}

/// Is no point of the whole ray in the turned rectangle, which is a ring, for certain? Only of a
/// rotational sweep.
template <typename Ring>
bool ring_is_missed(const PlaneRayOver<Ring>& ray, const geometry::Rectangle& box) {
  const std::vector<Ring>& squared = ray.u_squared;
  const Ring& v = ray.v[0];
  const auto is_zero = [](const std::vector<Ring>& p, std::size_t i) {
    return i >= p.size() || certain_sign(p[i]) == 0;
  };
  const auto is_above = [](const Ring& a, const Ring& b) { return certain_sign(a - b) == 1; };
  const Ring to_bottom = as_in(v, box.v_min) - v;
  const Ring to_top = as_in(v, box.v_max) - v;
  const bool is_level = is_zero(ray.v, 1);
  std::optional<Ring> first;
  std::optional<Ring> last;
  const Ring beyond = as_in(v, box.u_max * box.u_max);
  if (is_level) {
    if (certain_sign(to_bottom) == 1 || certain_sign(to_top) == -1) {
      return true;
    }
  } else {
    first = to_bottom / ray.v[1];
    last = to_top / ray.v[1];
    const auto squared_at = [&squared](const Ring& t) {
      Ring value = squared.back();
      for (std::size_t i = squared.size() - 1; i-- > 0;) {
        value = value * t + squared[i];
      }
      return value;
    };
    const Ring at_first = squared_at(*first);
    const Ring at_last = squared_at(*last);
    const Ring before = as_in(v, least_square(box));
    if (is_above(before, at_first) && is_above(before, at_last)) {
      return true;
    }
    if (!is_above(at_first, beyond) || !is_above(at_last, beyond)) {
      return false;
    }
  }
  if (is_zero(squared, 2)) {
    return !is_level;
  }
  // u^2 is least where the ray is nearest to the axis.
  const Ring nearest = (Ring() - squared[1]) / (number::Integer(2) * squared[2]);
  return (first && certain_sign((nearest - *first) * (nearest - *last)) == 1) ||
         is_above(squared[0] - nearest * nearest * squared[2], beyond);
}

}  // namespace lamina::surface
