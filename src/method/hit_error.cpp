#include <algorithm>
#include <cmath>

#include "method/tracer.ipp"

namespace lamina::method::detail {

using geometry::ExactPoint;
using number::Rational;

namespace {

Rational magnitude(const ExactPoint& v) {
  return std::max({Rational(abs(v.x)), Rational(abs(v.y)), Rational(abs(v.z))});
}

// 2^e <= |value| < 2^(e+1).
long exponent_of(const Rational& value) {
  const Rational size = abs(value);
  const auto bits = [](const number::Integer& i) { return static_cast<long>(msb(i)); };
  const long guess = bits(numerator(size)) - bits(denominator(size));
  return size < number::detail::scale_by_power_of_two(1, guess) ? guess - 1 : guess;
}

}  // namespace

HitError hit_error(const scene::Scene& scene, const geometry::ExactRay& ray, csg::LeafIndex leaf,
                   const number::Root& truth, const Rational& t, const ExactPoint& point,
                   const ExactPoint& gradient, int significand_bits) {
  constexpr int kGuardBits = 64;
  const number::Enclosure bounds = enclosure(truth, significand_bits + kGuardBits);
  const Rational exact_t = (bounds.lower + bounds.upper) / 2;
  const ExactPoint exact_point = ray.origin + exact_t * ray.direction;
  const scene::Leaf& l = scene.leaves[leaf];
  const ExactPoint exact_gradient =
      Rational(l.side) * surface::gradient_at(scene.carriers[l.carrier], exact_point);

  HitError error;
  if (!exact_t.is_zero()) {
    const long ulp = exponent_of(exact_t) - significand_bits + 1;
    error.t_ulps = number::nearest_double(
        Rational(abs(t - exact_t) * number::detail::scale_by_power_of_two(1, -ulp)));
  }
  if (const Rational size = magnitude(exact_point); !size.is_zero()) {
    error.point_rel = number::nearest_double(Rational(magnitude(point - exact_point) / size));
  }
  // sin(angle)^2 = |a x b|^2 / (|a| |b|)^2, exact until the last step.
  const Rational lengths = dot(gradient, gradient) * dot(exact_gradient, exact_gradient);
  if (!lengths.is_zero()) {
    const ExactPoint across = cross(gradient, exact_gradient);
    const double sine = std::sqrt(number::nearest_double(Rational(dot(across, across) / lengths)));
    const double angle = std::asin(std::min(sine, 1.0));
    error.normal_rad = dot(gradient, exact_gradient).sign() < 0 ? M_PI - angle : angle;
  }
  return error;
}

}  // namespace lamina::method::detail
