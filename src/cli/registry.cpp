#include "cli/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/contract.hpp"
#include "base/text.hpp"
#include "number/all_numbers.hpp"
#include "trace/number_choice.hpp"

namespace lamina::cli {
const std::vector<trace::NumberChoice>& all_numbers() {
#define LAMINA_CHOICE(Number) trace::number_choice<Number>(),
  static const std::vector<trace::NumberChoice> all{LAMINA_FOR_EACH_NUMBER(LAMINA_CHOICE)};
#undef LAMINA_CHOICE
  return all;
}

trace::NumberChoice parse_number(const std::string& text) {
  std::string name = text;  // bin<24> is bin24
  std::erase_if(name, [](char c) { return c == '<' || c == '>'; });
  const auto& all = all_numbers();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&name](const auto& choice) { return choice.name == name; });
  if (found == all.end()) {
    std::vector<std::string> names;
    for (const auto& choice : all) {
      names.push_back(choice.name);
    }
    throw base::InputError(
        fmt::format("number type '{}': one of {}", text, fmt::join(names, ", ")));
  }
  return *found;
}

std::vector<trace::NumberChoice> parse_numbers(const std::string& text) {
  if (text == "all") {
    return all_numbers();
  }
  std::vector<trace::NumberChoice> numbers;
  for (const std::string& name : base::split(text, ',')) {
    numbers.push_back(parse_number(name));
  }
  return numbers;
}

method::Method parse_method(const std::string& text) {
  if (text != "epsilon") {
    return method::parse_method(text);
  }
  const auto all = parse_methods("all");
  return *std::find_if(all.begin(), all.end(), [](const method::Method& m) {
    return m.grouping == method::Grouping::WithinEpsilon;
  });
}

std::vector<method::Method> parse_methods(const std::string& text) {
  std::vector<method::Method> methods;
  for (const std::string& name : base::split(text == "all" ? kAllMethods : text, ',')) {
    methods.push_back(parse_method(name));
  }
  return methods;
}

std::vector<poly::Solver> parse_solver_list(const std::string& text) {
  std::vector<poly::Solver> solvers;
  if (text == "all") {
    for (const poly::SolverInfo& info : poly::all_solvers()) {
      solvers.push_back(info.solver);
    }
    return solvers;
  }
  for (const std::string& name : base::split(text, ',')) {
    solvers.push_back(poly::parse_solver(name));
  }
  return solvers;
}

poly::Solvers parse_solvers(const std::string& text) {
  poly::Solvers solvers;
  for (const poly::Solver solver : parse_solver_list(text)) {
    for (const auto& [degree, chosen] :
         {std::pair(2, &solvers.quadratic), std::pair(3, &solvers.cubic),
          std::pair(4, &solvers.quartic), std::pair(6, &solvers.sextic)}) {
      if (poly::fits(solver, degree)) {
        *chosen = solver;
      }
    }
  }
  return solvers;
}

}  // namespace lamina::cli
