// Sines and tangents of angles in degrees: the same on every machine.
#pragma once

#include "number/rational.hpp"

namespace lamina::number {

/// Returns the double nearest to the sine of the angle. Multiples of 30 degrees give 0,
/// 1/2 and 1 exactly, and angles that are symmetric about an axis give the same value up
/// to its sign: the angle is reduced to 0 .. 90 exactly before anything is rounded.
double sine_of_degrees(const Rational& degrees);

/// Returns the double nearest to tan(angle) / sqrt(square); infinity beyond the range.
/// Contract: -90 < angle < 90 in degrees, square > 0.
double tangent_of_degrees_over_root(const Rational& degrees, const Rational& square);

/// The angle minus a multiple of 360 degrees, in (-180, 180]. Exact.
Rational reduced_degrees(const Rational& degrees);

}  // namespace lamina::number
