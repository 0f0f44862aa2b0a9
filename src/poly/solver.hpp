// The root finders by name, and the one way to call them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "poly/line_roots.hpp"
#include "poly/real_roots.hpp"

namespace lamina::poly {

enum class Solver : std::uint8_t {
  Textbook,
  Stable,
  Kahan,
  Cardano,
  CardanoPolished,
  KahanCubic,
  Ferrari,
  FerrariPolished,
  Algorithm1010,
  Laguerre,
  LaguerrePolished,
  Sturm,
  Monotone,
  Bernstein,
  Companion,
  Certified,
  Exact,
};

struct SolverInfo {
  Solver solver;
  std::string_view name;
  int least_degree;  ///< lower ones, from leading zeros, go to the default of their degree
  int most_degree;
  std::string_view meaning;
};

/// Every solver, by degree and then by kind.
std::span<const SolverInfo> all_solvers();
const SolverInfo& solver_info(Solver solver);

/// Throws base::InputError that lists them.
Solver parse_solver(std::string_view name);

/// Is it one of the closed forms that poly/quadratic.hpp has?
constexpr bool is_quadratic_formula(Solver solver) {
  return solver == Solver::Textbook || solver == Solver::Stable || solver == Solver::Kahan;
}

/// Can it solve polynomials of this degree?
bool fits(Solver solver, int degree);

/// The one to take for polynomials of this degree, chosen from the table of
/// experiments/solver-accuracy: README.md there says why. Contract: degree >= 2.
constexpr Solver default_solver(int degree) {
  return degree == 2 ? Solver::Kahan : degree == 3 ? Solver::KahanCubic : Solver::Bernstein;
}

/// Which rays' polynomials are set up at the ray's point that is nearest to the surface's own
/// origin, not where the ray starts.
enum class Recentring : std::uint8_t {
  None,
  Tori,  ///< of rays from farther than a torus' outer diameter
  All,   ///< of these, and of all rays at quadrics
};

/// Throws base::InputError that lists them.
Recentring parse_recentring(std::string_view name);
std::string_view name_of(Recentring recentring);

/// How the contour's parameter is found where a ray crosses a swept contour of splines (van Wijk
/// 1984, sections 1 and 7, names all three).
enum class SweepSearch : std::uint8_t {
  Polynomial,   ///< a solver on the ray's polynomial in the parameter
  Subdivision,  ///< halving the contour, a rectangle test for each part (Catmull 1974)
  StripTree,    ///< halving the contour, strips along it in place of rectangles (Kajiya 1983)
};

/// Throws base::InputError that lists them.
SweepSearch parse_sweep_search(std::string_view name);
std::string_view name_of(SweepSearch search);

/// Which solver finds the roots of a ray's polynomial of which degree, and of which polynomial:
/// of degree 2 (quadrics) and 4 (tori) in t, 3 and 6 (sweeps of splines) in the contour's
/// parameter; that of sextics for all higher degrees too (sphere sweeps, generalised conic sweeps),
/// where it fits. That of cubics is not the default of their degree, which finds a root at a joint
/// twice or not at all: experiments/sweep-accuracy.
struct Solvers {
  Solver quadratic = default_solver(2);
  Solver quartic = default_solver(4);
  Solver cubic = Solver::Bernstein;
  Solver sextic = default_solver(6);
  Recentring recentring = Recentring::Tori;
  SweepSearch search = SweepSearch::Polynomial;
  RootFault fault{};  ///< made in the roots of all but sweeps
};

/// Returns the roots of c_0 + c_1 t + ... + c_n t^n in the range, ascending, as the solver finds
/// them; no NaN, none outside the range, whatever the coefficients are. Allocates nothing for
/// n <= kMostDegree, but for Exact. What a solver's errors are stands in its own header.
///
/// Contract: n <= kMostDegree, and the solver fits the degree; lower degrees than it is made for
/// are solved by default_solver, a linear equation by division.
template <RoundedNumber Number>
RealRoots<Number> real_roots(std::span<const Number> ascending, const Range<Number>& range,
                             Solver solver);

/// Returns the sign changes on the whole line of a polynomial of degree 4 at most: those of
/// real_roots that are not known to be of even multiplicity.
template <RoundedNumber Number>
LineRoots<Number> crossings(std::span<const Number> ascending, Solver solver);

}  // namespace lamina::poly
