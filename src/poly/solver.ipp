#pragma once

#include "base/contract.hpp"
#include "poly/algorithm_1010.ipp"
#include "poly/bernstein.ipp"
#include "poly/certified_solver.hpp"
#include "poly/companion.hpp"
#include "poly/cubic.hpp"
#include "poly/exact_roots.hpp"
#include "poly/ferrari.hpp"
#include "poly/laguerre.ipp"
#include "poly/monotone.hpp"
#include "poly/quadratic.hpp"
#include "poly/solver.hpp"
#include "poly/sturm.ipp"

namespace lamina::poly {
namespace detail {

// Contract: finite coefficients, a degree that the solver is made for.
template <RoundedNumber Number>
RealRoots<Number> solve(const Polynomial<Number>& p, const Range<Number>& range, Solver solver) {
  switch (solver) {
    case Solver::Textbook:
    case Solver::Stable:
    case Solver::Kahan:
      return quadratic_roots(p, solver);
    case Solver::Cardano:
      return cardano_roots(p);
    case Solver::CardanoPolished:
      return cardano_polished_roots(p);
    case Solver::KahanCubic:
      return kahan_cubic_roots(p);
    case Solver::Ferrari:
      return ferrari_roots(p);
    case Solver::FerrariPolished:
      return ferrari_polished_roots(p);
    case Solver::Algorithm1010:
      return algorithm_1010_roots(p);
    case Solver::Laguerre:
      return laguerre_roots(p);
    case Solver::LaguerrePolished:
      return laguerre_polished_roots(p);
    case Solver::Sturm:
      return sturm_roots(p, range);
    case Solver::Monotone:
      return monotone_roots(p, range);
    case Solver::Bernstein:
      return bernstein_roots(p, range);
    case Solver::Companion:
      return companion_roots(p);
    case Solver::Certified:
      return certified_real_roots(p, range);
    case Solver::Exact:
      return exact_roots(p, range);
  }
  return {};
}

template <RoundedNumber Number>
RealRoots<Number> only_in(const Range<Number>& range, RealRoots<Number> roots) {
  int kept = 0;
  for (int i = 0; i < roots.count; ++i) {
    const bool is_finite = roots.t[i] - roots.t[i] == 0;
    if (is_finite && range.contains(roots.t[i])) {
      roots.t[kept] = roots.t[i];
      roots.multiplicity[kept] = roots.multiplicity[i];
      ++kept;
    }
  }
  roots.count = kept;
  return roots;
}

}  // namespace detail

template <RoundedNumber Number>
RealRoots<Number> real_roots(std::span<const Number> ascending, const Range<Number>& range,
                             Solver solver) {
  RealRoots<Number> roots;
  for (const Number& c : ascending) {
    if (!(c - c == 0)) {
      roots.outcome = Outcome::NotFinite;
      return roots;
    }
  }
  const Polynomial<Number> p(ascending);
  if (p.degree < 0) {
    roots.outcome = Outcome::Everywhere;
    return roots;
  }
  if (p.degree == 0) {
    return roots;
  }
  const bool exactly = solver == Solver::Certified || solver == Solver::Exact;
  if (p.degree == 1 && !exactly) {
    roots.add(Number(-p.c[0] / p.c[1]), 1);
    return detail::only_in(range, roots);
  }
  const int made_for = solver_info(solver).least_degree;
  return detail::only_in(
      range, detail::solve(p, range, p.degree < made_for ? default_solver(p.degree) : solver));
}

template <RoundedNumber Number>
LineRoots<Number> crossings(std::span<const Number> ascending, Solver solver) {
  const RealRoots<Number> all = real_roots(ascending, Range<Number>(), solver);
  LineRoots<Number> roots;
  for (int i = 0; i < all.count; ++i) {
    const bool is_odd = all.multiplicity[i] % 2 == 1 || all.multiplicity[i] == 0;
    if (is_odd && roots.count < static_cast<int>(roots.t.size())) {
      roots.cross(all.t[i]);
    }
  }
  return roots;
}

}  // namespace lamina::poly
