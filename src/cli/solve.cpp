#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/contract.hpp"
#include "base/text.hpp"
#include "census/solver_census.hpp"
#include "cli/commands.hpp"
#include "cli/registry.hpp"
#include "poly/solution.hpp"

namespace lamina::cli {
namespace {

using number::Rational;

struct Options {
  std::string coefficients;
  std::string interval;
  std::string solvers = "all";
  std::string numbers = "all";
  std::string format = "text";
};

struct Polynomial {
  std::vector<Rational> ascending;
  poly::ExactRange range;

  [[nodiscard]] bool is_zero() const { return degree() < 0; }
  [[nodiscard]] int degree() const {
    int degree = static_cast<int>(ascending.size()) - 1;
    while (degree >= 0 && ascending[degree] == 0) {
      --degree;
    }
    return degree;
  }
};

struct Result {
  std::string solver;
  std::string number;
  poly::Solution solution;
  int significand_bits;
};

std::vector<Rational> parse_list(const std::string& option, const std::string& text) {
  std::vector<Rational> values;
  for (const std::string& part : base::split(text, ',')) {
    try {
      values.push_back(number::parse_rational(part));
    } catch (const base::InputError& error) {
      throw base::InputError(
          fmt::format("{}, number {}: {}", option, values.size() + 1, error.what()));
    }
  }
  return values;
}

Polynomial parse(const Options& options) {
  Polynomial p{parse_list("--coefficients", options.coefficients), {}};
  if (!options.interval.empty()) {
    const std::vector<Rational> ends = parse_list("--interval", options.interval);
    if (ends.size() != 2 || ends[0] > ends[1]) {
      throw base::InputError(
          fmt::format("--interval '{}': two numbers a,b with a <= b", options.interval));
    }
    p.range = {ends[0], ends[1]};
  }
  return p;
}

std::vector<Result> solve_all(const Polynomial& p, const Options& options) {
  const std::vector<trace::NumberChoice> numbers = parse_numbers(options.numbers);
  std::vector<Result> results;
  for (const poly::Solver chosen : parse_solver_list(options.solvers)) {
    const poly::SolverInfo& solver = poly::solver_info(chosen);
    if (static_cast<int>(p.ascending.size()) - 1 > poly::kMostDegree ||
        p.degree() > solver.most_degree || (p.degree() < solver.least_degree && p.degree() > 1)) {
      continue;
    }
    for (const trace::NumberChoice& number : numbers) {
      if (number.solve) {
        results.push_back({std::string(solver.name), number.name,
                           number.solve(p.ascending, p.range, solver.solver),
                           number.significand_bits});
      }
    }
  }
  return results;
}

// Would the exact roots be among the results?
bool wants_exact(const Options& options) {
  const auto names = base::split(options.solvers, ',');
  const auto numbers = base::split(options.numbers, ',');
  const auto has = [](const std::vector<std::string>& list, const char* name) {
    return std::any_of(list.begin(), list.end(),
                       [name](const std::string& s) { return s == name || s == "all"; });
  };
  return has(names, "exact") && has(numbers, "exact");
}

const char* spelled(poly::Outcome outcome) {
  switch (outcome) {
    case poly::Outcome::Found:
      return "found";
    case poly::Outcome::Everywhere:
      return "everywhere";
    case poly::Outcome::NotFinite:
      return "not finite";
    case poly::Outcome::Undecided:
      return "undecided";
  }
  return "";
}

nlohmann::ordered_json multiplicity_of(int multiplicity) {
  return multiplicity == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(multiplicity);
}

std::string json(const Polynomial& p, const std::vector<number::Root>& roots,
                 const std::vector<Result>& results, bool with_exact) {
  auto list = nlohmann::ordered_json::array();
  if (with_exact) {
    const auto intervals = poly::isolating_intervals(roots);
    auto exact = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < roots.size(); ++i) {
      exact.push_back(
          {{"value", number::nearest_double(roots[i])},
           {"multiplicity", roots[i].multiplicity()},
           {"isolating",
            {number::to_text(intervals[i].lower), number::to_text(intervals[i].upper)}}});
    }
    list.push_back({{"solver", "exact"},
                    {"number", "exact"},
                    {"outcome", p.is_zero() ? "everywhere" : "found"},
                    {"roots", exact}});
  }
  for (const Result& result : results) {
    auto found = nlohmann::ordered_json::array();
    for (const poly::Solution::Root& root : result.solution.roots) {
      const double value = number::nearest_double(root.t);
      if (!found.empty() && found.back()["value"] == value) {
        found.back()["multiplicity"] = nullptr;  // close ones, or one twice: it cannot know
      } else {
        found.push_back({{"value", value}, {"multiplicity", multiplicity_of(root.multiplicity)}});
      }
    }
    list.push_back({{"solver", result.solver},
                    {"number", result.number},
                    {"outcome", spelled(result.solution.outcome)},
                    {"roots", found}});
  }
  return nlohmann::ordered_json{{"results", list}}.dump() + "\n";
}

std::string polynomial_text(const Polynomial& p) {
  std::string text;
  for (int i = p.degree(); i >= 0; --i) {
    const Rational& c = p.ascending[i];
    if (c == 0) {
      continue;
    }
    const Rational size = abs(c);
    const std::string factor = size == 1 && i > 0 ? "" : number::to_text(size) + (i > 0 ? " " : "");
    const std::string power = i == 0 ? "" : i == 1 ? "t" : fmt::format("t^{}", i);
    const char* sign = text.empty() ? (c < 0 ? "-" : "") : (c < 0 ? " - " : " + ");
    text += sign + factor + power;
  }
  return text.empty() ? "0" : text;
}

std::string repeated(int multiplicity) {
  return multiplicity > 1 ? fmt::format(" ({} times)", multiplicity) : "";
}

// Against the exact roots, each as often as it is multiple: how many there are, or how far off.
std::string compared(const Result& result, const std::vector<number::Root>& roots) {
  if (result.solution.outcome != poly::Outcome::Found) {
    return spelled(result.solution.outcome);
  }
  census::RootCounts counts;
  double worst = 0;
  const auto exact = poly::known(roots, result.significand_bits);
  for (const census::RootPair& pair : judge(result.solution, exact, counts)) {
    worst = std::max(worst, pair.ulps);
  }
  if (counts.wrong_count > 0) {
    return counts.missed > 0 ? fmt::format("{} missed", counts.missed)
                             : fmt::format("{} too many", counts.spurious);
  }
  return roots.empty() ? "none, right" : fmt::format("{:.3g} ulp", worst);
}

std::string text(const Polynomial& p, const std::vector<number::Root>& roots,
                 const std::vector<Result>& results) {
  std::string out = polynomial_text(p) + "\n";
  const auto end = [](const std::optional<Rational>& x, const char* none) {
    return x ? number::to_text(*x) : std::string(none);
  };
  out += fmt::format("exact roots in {} .. {}:\n", end(p.range.low, "-infinity"),
                     end(p.range.high, "infinity"));
  if (p.is_zero()) {
    out += "  every t is a root\n";
  } else if (roots.empty()) {
    out += "  none\n";
  }
  const auto intervals = poly::isolating_intervals(roots);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    out += fmt::format("  {:<24} alone in {} .. {}{}\n",
                       fmt::format("{}", number::nearest_double(roots[i])),
                       number::to_text(intervals[i].lower), number::to_text(intervals[i].upper),
                       repeated(static_cast<int>(roots[i].multiplicity())));
  }
  if (results.empty()) {
    return out;
  }
  out += fmt::format("\n{:<18} {:<11} {:<18} {}\n", "solver", "number", "off by at most", "roots");
  for (const Result& result : results) {
    std::vector<std::string> values;
    for (const poly::Solution::Root& root : result.solution.roots) {
      values.push_back(
          fmt::format("{}{}", number::nearest_double(root.t), repeated(root.multiplicity)));
    }
    std::string line = fmt::format("{:<18} {:<11} {:<18} {}", result.solver, result.number,
                                   compared(result, roots), fmt::join(values, "  "));
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

void run(const Options& options) {
  if (options.format != "text" && options.format != "json") {
    throw base::InputError(fmt::format("format '{}': one of text, json", options.format));
  }
  const Polynomial p = parse(options);
  const std::vector<number::Root> roots =
      p.is_zero() ? std::vector<number::Root>() : poly::exact_roots(p.ascending, p.range);
  const std::vector<Result> results = solve_all(p, options);
  if (results.empty() && !wants_exact(options)) {
    throw base::InputError(fmt::format(
        "none of these solvers takes a polynomial of degree {} in one of these number types (see "
        "`lamina list solvers`)",
        p.degree()));
  }
  fmt::print("{}", options.format == "json" ? json(p, roots, results, wants_exact(options))
                                            : text(p, roots, results));
}

}  // namespace

void add_solve(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "solve", "one polynomial through every root finder, next to its exact roots");
  command->footer(
      "Coefficients and interval are read exactly; each number type takes the nearest numbers it\n"
      "has. Roots are printed as the nearest doubles. `off by` is against the exact roots of the\n"
      "polynomial as written, so that it has the error of rounding the coefficients in it, too;\n"
      "the solver `exact` in a rounded number type shows that alone.\n"
      "JSON: {\"results\":[{\"solver\":\"exact\",\"number\":\"exact\",\"outcome\":\"found\",\n"
      "\"roots\":[{\"value\":0.5,\"multiplicity\":2,\"isolating\":[\"1/2\",\"1/2\"]}]}]}; "
      "multiplicity "
      "is\n"
      "null where the solver cannot know it.\n\n"
      "Example: lamina solve --coefficients 1/4,-1,1 --interval 0,1\n"
      "         lamina solve --coefficients=-6,11,-6,1 --numbers float,double --solvers "
      "cardano,sturm");
  command
      ->add_option("--coefficients", options->coefficients,
                   "a0,a1,..,an of a0 + a1 t + .. + an t^n: decimals or fractions")
      ->required();
  command->add_option("--interval", options->interval, "a,b: roots from a to b, both included");
  command->add_option("--solvers", options->solvers, "see `lamina list solvers`; or all")
      ->capture_default_str();
  command->add_option("--numbers", options->numbers, "see `lamina list numbers`; or all")
      ->capture_default_str();
  command->add_option("--format", options->format, "text or json")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
