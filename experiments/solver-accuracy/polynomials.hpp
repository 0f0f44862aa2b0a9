// The polynomials of the experiment `solver-accuracy`: families with known roots, and those of
// rays at a sphere, a torus and swept splines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "poly/solution.hpp"

namespace lamina::experiments {

/// A polynomial as a number type holds it.
struct HeldPolynomial {
  std::vector<number::Rational> ascending;
  number::Rational shift = 0;  ///< its roots are those of the ideal one less this
};

/// What is to be solved: the ideal polynomial, exact, and what becomes of it in a number type.
struct Problem {
  std::vector<number::Rational> ideal;
  poly::ExactRange range;
  /// By the name of the number type; none if it holds no such coefficients.
  std::function<std::optional<HeldPolynomial>(const std::string& number)> hold;
  /// By one of the family's scene solvers; none if it does not compute in that number type.
  std::function<std::optional<poly::Solution>(const std::string& solver, const std::string& number)>
      from_scene;
};

struct PolynomialFamily {
  std::string name;
  std::string parameter;
  int degree = 2;
  /// Ways from the numbers of the scene to the roots without a polynomial as it is held.
  std::vector<std::string> scene_solvers;
  std::function<Problem(base::SeededStream&)> draw;
};

const std::vector<PolynomialFamily>& polynomial_families();

}  // namespace lamina::experiments
