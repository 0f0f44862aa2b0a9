// Quartic equations in rounded arithmetic.
#pragma once

#include <array>

#include "poly/line_roots.hpp"

namespace lamina::poly {

/// Returns the crossings of c[0] + c[1] t + ... + c[4] t^4. Leading zeros lower the degree;
/// a constant has none.
///
/// Ferrari:  the closed form: the depressed quartic is split in two quadratics by the largest
///           root of its resolvent cubic (Cardano, or cosines where it has three). No error
///           bound: it loses digits where roots are close, and may invent or drop pairs. Uses
///           cos, acos and pow, which differ in the last bits between number types.
/// Monotone: between neighbouring roots of the derivative, found in the same way, the
///           polynomial is monotone: a sign change there is one root, found by Newton steps
///           kept inside the bracket, to the last bit of the evaluated polynomial (the idea of
///           Yuksel, "High-performance polynomial root finding", HPG 2022, without its
///           tolerance). Uses + - * / and sqrt only. What it gets wrong comes from the sign
///           of the polynomial as evaluated by Horner's rule.
template <RoundedNumber Number>
LineRoots<Number> quartic_crossings(const std::array<Number, 5>& c, QuarticSolver solver);

}  // namespace lamina::poly
