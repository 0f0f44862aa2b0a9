#include "number/trigonometry.hpp"

#include <boost/math/constants/constants.hpp>

#include "base/contract.hpp"
#include "number/traits.hpp"

namespace lamina::number {
namespace {

// 517 bits, of which the results lose a few: the nearest double then is the nearest to the
// true value unless some value is within 2^-400 of halfway between two doubles.
using Wide = mpfr<155>;

Wide wide(const Rational& value) { return number_traits<Wide>::from_exact(value); }

Wide radians(const Rational& degrees) {
  return wide(Rational(degrees / 180)) * boost::math::constants::pi<Wide>();
}

}  // namespace

Rational reduced_degrees(const Rational& degrees) {
  // In (-180, 180]: degrees - 360 * ceil((degrees - 180) / 360), where ceil(n/d) is -floor(-n/d).
  const Rational turns = (180 - degrees) / 360;
  Integer floor = numerator(turns) / denominator(turns);
  if (floor * denominator(turns) > numerator(turns)) {
    --floor;  // GMP's quotient is rounded to zero
  }
  return degrees + 360 * Rational(floor);
}

double sine_of_degrees(const Rational& degrees) {
  const Rational reduced = reduced_degrees(degrees);
  const Rational magnitude = abs(reduced);
  const Rational acute = magnitude > 90 ? Rational(180 - magnitude) : magnitude;
  const double sine = Wide(sin(radians(acute))).convert_to<double>();
  return reduced.sign() < 0 ? -sine : sine;
}

double tangent_of_degrees_over_root(const Rational& degrees, const Rational& square) {
  LAMINA_REQUIRE(abs(degrees) < 90 && square > 0, "the tangent and the root are finite");
  const Rational magnitude = abs(degrees);
  // Near 90 degrees the tangent is the inverse of the complement's, which loses no bits.
  const Wide tangent = magnitude <= 45 ? Wide(tan(radians(magnitude)))
                                       : Wide(1 / tan(radians(Rational(90 - magnitude))));
  const double result = Wide(tangent / sqrt(wide(square))).convert_to<double>();
  return degrees.sign() < 0 ? -result : result;
}

}  // namespace lamina::number
