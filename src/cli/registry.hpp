// Where names become number types and methods.
#pragma once

#include <string>
#include <vector>

#include "method/method.hpp"
#include "method/tracer.hpp"
#include "poly/solver.hpp"
#include "trace/number_choice.hpp"

namespace lamina::cli {

/// Every number type, in the order of number/all_numbers.hpp.
const std::vector<trace::NumberChoice>& all_numbers();

/// `double`, `bin24` or `bin<24>`, ... Throws base::InputError that lists them.
trace::NumberChoice parse_number(const std::string& text);

/// Names separated by commas, or `all`.
std::vector<trace::NumberChoice> parse_numbers(const std::string& text);

/// Spellings separated by commas, or `all`: the five methods, epsilon at the tolerance that
/// stands in kAllMethods. A bare `epsilon` takes it too: outputs always state it.
std::vector<method::Method> parse_methods(const std::string& text);
method::Method parse_method(const std::string& text);

inline constexpr const char* kAllMethods =
    "roth,wyvill-sharp,epsilon:1e-6,regularized,wyvill-trotman";

/// Names separated by commas, or `all`.
std::vector<poly::Solver> parse_solver_list(const std::string& text);

/// Solvers separated by commas, each for the degrees of surfaces that it fits; where several fit
/// the last one counts, and the default where none does. Throws base::InputError that lists them.
poly::Solvers parse_solvers(const std::string& text);

}  // namespace lamina::cli
