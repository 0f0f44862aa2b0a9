// Versions of the numeric libraries, for environment records.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lamina::number {

/// Name and version of Boost, CGAL, GMP, MPFR and MPFI.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace lamina::number
