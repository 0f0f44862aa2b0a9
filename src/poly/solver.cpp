#include "poly/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/contract.hpp"

namespace lamina::poly {
namespace {

constexpr std::array<SolverInfo, 17> kSolvers{{
    {Solver::Textbook, "textbook", 2, 2, "(-b -+ sqrt(b^2 - ac)) / a"},
    {Solver::Stable, "stable", 2, 2, "the second root by Vieta: no digits of b are lost"},
    {Solver::Kahan, "kahan", 2, 2, "stable, with the discriminant to 3/2 ulp by fused operations"},
    {Solver::Cardano, "cardano", 3, 3, "closed form: Cardano, or cosines where it has three roots"},
    {Solver::CardanoPolished, "cardano-polished", 3, 3, "the same, then Newton's steps"},
    {Solver::KahanCubic, "kahan-cubic", 3, 3,
     "one root by Newton from the safe side, then a quadratic (Kahan 1986)"},
    {Solver::Ferrari, "ferrari", 4, 4, "closed form by the resolvent cubic"},
    {Solver::FerrariPolished, "ferrari-polished", 4, 4, "the same, then Newton's steps"},
    {Solver::Algorithm1010, "algorithm-1010", 4, 4,
     "two real quadratics, refined together (Orellana and De Michele 2020)"},
    {Solver::Laguerre, "laguerre", 1, kMostDegree,
     "Laguerre's method and synthetic division (van Wijk 1984, section 5)"},
    {Solver::LaguerrePolished, "laguerre-polished", 1, kMostDegree,
     "the same, then steps on the undivided polynomial"},
    {Solver::Sturm, "sturm", 1, kMostDegree,
     "Sturm's sequence and bisection, then regula falsi (Hanrahan 1983)"},
    {Solver::Monotone, "monotone", 1, kMostDegree,
     "Newton between the derivative's roots (Yuksel 2022)"},
    {Solver::Bernstein, "bernstein", 1, kMostDegree,
     "Descartes' rule in the Bernstein basis, halving, then Halley"},
    {Solver::Companion, "companion", 1, kMostDegree, "eigenvalues of the companion matrix (Eigen)"},
    {Solver::Certified, "certified", 1, kMostDegree,
     "intervals: roots for certain, none for certain, or undecided"},
    {Solver::Exact, "exact", 1, kMostDegree,
     "the exact roots of the rounded coefficients, rounded once"},
}};

}  // namespace

std::span<const SolverInfo> all_solvers() { return kSolvers; }

const SolverInfo& solver_info(Solver solver) {
  static_assert([] {
    for (std::size_t i = 0; i < kSolvers.size(); ++i) {
      if (kSolvers[i].solver != static_cast<Solver>(i)) {
        return false;
      }
    }
    return true;
  }());
  return kSolvers[static_cast<std::size_t>(solver)];
}

Solver parse_solver(std::string_view name) {
  std::string names;
  for (const SolverInfo& info : kSolvers) {
    if (info.name == name) {
      return info.solver;
    }
    names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
  }
  throw base::InputError(fmt::format("unknown solver '{}': one of {}", name, names));
}

bool fits(Solver solver, int degree) {
  const SolverInfo& info = solver_info(solver);
  return info.least_degree <= degree && degree <= info.most_degree;
}

Recentring parse_recentring(std::string_view name) {
  for (const Recentring recentring : {Recentring::None, Recentring::Tori, Recentring::All}) {
    if (name_of(recentring) == name) {
      return recentring;
    }
  }
  throw base::InputError(
      fmt::format("unknown rays to recentre '{}': one of none, tori, all", name));
}

std::string_view name_of(Recentring recentring) {
  switch (recentring) {
    case Recentring::None:
      return "none";
    case Recentring::Tori:
      return "tori";
    case Recentring::All:
      return "all";
  }
  return {};
}

SweepSearch parse_sweep_search(std::string_view name) {
  for (const SweepSearch search :
       {SweepSearch::Polynomial, SweepSearch::Subdivision, SweepSearch::StripTree}) {
    if (name_of(search) == name) {
      return search;
    }
  }
  throw base::InputError(fmt::format(
      "unknown search of sweeps '{}': one of polynomial, subdivision, strip-tree", name));
}

std::string_view name_of(SweepSearch search) {
  switch (search) {
    case SweepSearch::Polynomial:
      return "polynomial";
    case SweepSearch::Subdivision:
      return "subdivision";
    case SweepSearch::StripTree:
      return "strip-tree";
  }
  return {};
}

}  // namespace lamina::poly
