// Van Wijk's rectangle test for lines, and his equation 8, as they are in print; over the
// rationals, so that nothing but the formula is wrong.
#pragma once

#include <vector>

#include "surface/swept_surface.hpp"

namespace lamina::experiments {

/// P(u, v) = u_factor u + v_factor v + constant: the left side of equation 2 of a translational
/// sweep, or 6 of a conic one.
struct RayLine {
  number::Rational u_factor;
  number::Rational v_factor;
  number::Rational constant;

  [[nodiscard]] number::Rational at(const number::Rational& u, const number::Rational& v) const {
    return u_factor * u + v_factor * v + constant;
  }
  /// In equation 2, d_x d_y < 0: the factors are d_y and -d_x.
  [[nodiscard]] bool falls() const { return u_factor.sign() * v_factor.sign() > 0; }
  /// Neither of the two cases of the test is for such a line.
  [[nodiscard]] bool is_level() const { return u_factor.is_zero() || v_factor.is_zero(); }
};
RayLine ray_line(surface::Sweep sweep, const geometry::ExactRay& local);

/// Section 3: has P one sign at two corners of the rectangle? Where the line falls, print has
/// (u_max, v_min) for the second; it should be (u_max, v_max), opposite to the first.
bool rules_out(const RayLine& line, const geometry::Rectangle& box, bool as_printed);

/// Where a ray meets a rotational sweep by equation 8 as it is in print, u = x^2 + y^2, or as it
/// should be, u^2 = x^2 + y^2: the t, ascending, by the piece's own polynomial with v(s) = o_z +
/// d_z t; odd multiplicities alone; to some 200 bits. Contract: d_z is not zero.
std::vector<number::Rational> rotational_crossings(const surface::SweptSurface& surface,
                                                   const geometry::ExactRay& local,
                                                   bool as_printed);

}  // namespace lamina::experiments
