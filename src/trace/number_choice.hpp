// A number type without its type: what tables and the program choose from.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "method/tracer.hpp"
#include "poly/solution.hpp"
#include "scene/rounding.hpp"
#include "surface/sweep_solution.hpp"
#include "trace/ray_path.hpp"

namespace lamina::trace {

struct NumberChoice {
  std::string name;
  int significand_bits = 0;  ///< 0 for exact types
  std::function<std::unique_ptr<method::Tracer>(const scene::Scene&, const poly::Solvers&)>
      make_tracer;
  scene::Rounding round;
  /// None for exact types: the point that a ray is spawned at is no rational one.
  std::function<std::unique_ptr<RayPath>(const scene::Scene&, const poly::Solvers&)> make_path{};
  /// None for exact types, which have one way to solve alone: poly::solve and seconds_to_solve.
  std::function<poly::Solution(const std::vector<number::Rational>&, const poly::ExactRange&,
                               poly::Solver)>
      solve{};
  std::function<double(const std::vector<std::vector<number::Rational>>&,
                       const std::vector<poly::ExactRange>&, poly::Solver)>
      seconds_to_solve{};
  /// The same for rays at sweeps: surface::cross_sweep and seconds_to_cross.
  std::function<std::vector<surface::FoundCrossing>(
      const surface::AnySweep&, const geometry::ExactRay&, const surface::SweepMethod&)>
      cross_sweep{};
  std::function<double(const std::vector<surface::AnySweep>&,
                       const std::vector<geometry::ExactRay>&, const surface::SweepMethod&)>
      seconds_to_cross{};
};

template <number::RealNumber Number>
NumberChoice number_choice() {
  using Traits = number::number_traits<Number>;
  NumberChoice choice{Traits::name(), Traits::kSignificandBits, method::make_tracer<Number>,
                      scene::rounding<Number>};
  if constexpr (number::RoundedNumber<Number>) {
    choice.make_path = make_ray_path<Number>;
    choice.solve = poly::solve<Number>;
    choice.seconds_to_solve = poly::seconds_to_solve<Number>;
    choice.cross_sweep = surface::cross_sweep<Number>;
    choice.seconds_to_cross = surface::seconds_to_cross<Number>;
  }
  return choice;
}

}  // namespace lamina::trace
