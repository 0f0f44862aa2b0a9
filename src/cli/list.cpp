#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/registry.hpp"
#include "experiments/experiment.hpp"
#include "scene/families.hpp"
#include "trace/number_choice.hpp"
#include "trace/spawn.hpp"

namespace lamina::cli {
namespace {

void print(const std::string& name, const std::string& meaning) {
  fmt::print("{:<30} {}\n", name, meaning);
}

void list_numbers() {
  for (const trace::NumberChoice& number : all_numbers()) {
    print(number.name, number.significand_bits == 0
                           ? "rational coefficients, real algebraic roots"
                           : fmt::format("{} significand bits", number.significand_bits));
  }
}

void list_solvers() {
  for (const poly::SolverInfo& info : poly::all_solvers()) {
    const bool has_one_degree = info.least_degree == info.most_degree;
    const std::string degrees =
        has_one_degree ? fmt::format("degree {}", info.least_degree)
        : info.most_degree == poly::kMostDegree
            ? std::string("any degree")
            : fmt::format("degrees {} to {}", info.least_degree, info.most_degree);
    const int degree = has_one_degree ? info.least_degree : info.most_degree;
    const std::string_view is_default = info.solver != poly::default_solver(degree) ? ""
                                        : has_one_degree ? " (the default)"
                                                         : " (the default from degree 4 on)";
    print(std::string(info.name), fmt::format("{}: {}{}", degrees, info.meaning, is_default));
  }
}

}  // namespace

void add_list(CLI::App& app) {
  CLI::App* command = app.add_subcommand("list", "what there is to choose from");
  command->require_subcommand(1);
  command->add_subcommand("methods", "ways of deciding what a ray sees")->callback([] {
    for (const method::MethodHelp& help : method::method_help()) {
      print(help.spelling, help.meaning);
    }
  });
  command->add_subcommand("numbers", "number types")->callback(list_numbers);
  command->add_subcommand("spawns", "where spawned rays start")->callback([] {
    for (const trace::SpawnHelp& help : trace::spawn_help()) {
      print(help.spelling, help.meaning);
    }
  });
  command->add_subcommand("experiments", "for `lamina run`")->callback([] {
    for (const experiments::Experiment& e : experiments::all_experiments()) {
      print(e.name, e.question);
    }
  });
  command->add_subcommand("families", "seeded families of scenes, family:FAMILY:SEED:CASE")
      ->callback([] {
        for (const scene::Family& family : scene::families()) {
          print(family.name + family.parameters, family.about);
        }
      });
  command->add_subcommand("solvers", "root finders, for --solver and `lamina solve`")
      ->callback(list_solvers);
}

}  // namespace lamina::cli
