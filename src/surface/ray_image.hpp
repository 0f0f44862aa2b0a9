// A ray's image in the plane of a swept contour, in a rounded number type.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "number/traits.hpp"

namespace lamina::surface {

template <number::RoundedNumber Number>
struct PlaneBox {
  Number u_min, u_max, v_min, v_max;
};

/// What an image's left side is on some part of the plane, as computed, and what this is off by.
template <number::RoundedNumber Number>
struct ImageBounds {
  Number least, greatest, rounding;

  /// Has it one sign, by `times` its rounding?
  [[nodiscard]] bool exclude_zero(int times = 1) const {
    const Number bound = static_cast<Number>(times) * rounding;
    return least > bound || greatest < -bound;
  }
};

/// vv v^2 + v v + constant + u u + uu u^2 = 0: equation 9 of van Wijk 1984, where uu <= 0 <= vv, or
/// a line (2 and 6), where both are zero.
template <number::RoundedNumber Number>
struct RayImage {
  Number u{0}, uu{0}, v{0}, vv{0}, constant{0};
  // The same, all products positive: the coefficients before anything cancels.
  Number most_u{0}, most_uu{0}, most_v{0}, most_vv{0}, most_constant{0};

  [[nodiscard]] bool is_line() const { return uu == 0 && vv == 0; }
  [[nodiscard]] bool depends_on_u() const { return uu != 0 || u != 0; }

  [[nodiscard]] Number at(const Number& at_u, const Number& at_v) const {
    return in_u(at_u) + in_v(at_v) + constant;
  }

  /// The left side's polar form: of the first degree in each of two points, and its value where
  /// they are one.
  [[nodiscard]] Number polar(const std::array<Number, 2>& p, const std::array<Number, 2>& q) const {
    const Number half(0.5);
    return uu * (p[0] * q[0]) + u * (half * (p[0] + q[0])) + vv * (p[1] * q[1]) +
           v * (half * (p[1] + q[1])) + constant;
  }

  /// Not below the sum of the absolute terms at any point as near to the axes as this one.
  [[nodiscard]] Number terms(const Number& abs_u, const Number& abs_v) const {
    return (most_uu * abs_u + most_u) * abs_u + (most_vv * abs_v + most_v) * abs_v + most_constant;
  }

  /// The left side over a rectangle: a sum of a function of u and one of v, each least or greatest
  /// at an end, or where the parabola in v turns. A term has 9 roundings at most on its way from
  /// the ray's numbers to the sum, so that the sum is off by gamma_9 times that of the absolute
  /// terms (Higham 2002, 3.1); 16 u is more than that for u <= 2^-11, and what rounding the turn
  /// costs is of second order, since most_v^2 <= 4 vv most_constant.
  [[nodiscard]] ImageBounds<Number> over(const PlaneBox<Number>& box) const {
    using std::abs;
    // The radius of a sweep begins at the axis, whatever its rectangle was rounded to.
    const Number u_low = uu < 0 && box.u_min < 0 ? Number(0) : box.u_min;
    const auto [least_u, greatest_u] = std::minmax({in_u(u_low), in_u(box.u_max)});
    auto [least_v, greatest_v] = std::minmax({in_v(box.v_min), in_v(box.v_max)});
    if (vv > 0) {
      const Number turn = -v / (2 * vv);
      if (box.v_min < turn && turn < box.v_max) {
        least_v = std::min(least_v, in_v(turn));
      }
    }
    const Number abs_u = std::max(Number(abs(box.u_min)), Number(abs(box.u_max)));
    const Number abs_v = std::max(Number(abs(box.v_min)), Number(abs(box.v_max)));
    return {least_u + least_v + constant, greatest_u + greatest_v + constant,
            16 * number::unit_roundoff<Number>() * terms(abs_u, abs_v)};
  }

 private:
  [[nodiscard]] Number in_u(const Number& at_u) const { return (uu * at_u + u) * at_u; }
  [[nodiscard]] Number in_v(const Number& at_v) const { return (vv * at_v + v) * at_v; }
};

}  // namespace lamina::surface
