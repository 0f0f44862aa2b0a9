// What a run was made with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lamina::base {

/// Name and value: version, commit, compiler and flags, versions of the libraries below, the
/// processor and the operating system. The numeric libraries are number::library_versions().
std::vector<std::pair<std::string, std::string>> environment();

}  // namespace lamina::base
