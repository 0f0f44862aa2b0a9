#include "cli/registry.hpp"

#include <fmt/format.h>

#include <algorithm>

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

std::vector<SolverName> solver_names() {
  return {{"plain", "quadratic: the textbook's formula"},
          {"careful", "quadratic: Kahan's discriminant, the stable second root (default)"},
          {"ferrari", "quartic: closed form by the resolvent cubic"},
          {"monotone", "quartic: bracketed Newton between critical points (default)"}};
}

poly::Solvers parse_solvers(const std::string& quadratic, const std::string& quartic) {
  poly::Solvers solvers;
  if (quadratic != "plain" && quadratic != "careful") {
    throw base::InputError(fmt::format("quadratic solver '{}': one of plain, careful", quadratic));
  }
  if (quartic != "ferrari" && quartic != "monotone") {
    throw base::InputError(fmt::format("quartic solver '{}': one of ferrari, monotone", quartic));
  }
  solvers.quadratic =
      quadratic == "plain" ? poly::QuadraticSolver::Plain : poly::QuadraticSolver::Careful;
  solvers.quartic =
      quartic == "ferrari" ? poly::QuarticSolver::Ferrari : poly::QuarticSolver::Monotone;
  return solvers;
}

}  // namespace lamina::cli
