// A finished run on disk: its tables and what they were made with.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "report/table.hpp"

namespace lamina::report {

/// Names and values.
using Record = std::vector<std::pair<std::string, std::string>>;

/// Writes `tables.json` and `environment.json` to the folder, which is made if it is not
/// there. Each file is written whole before it takes its name. The environment holds, besides
/// what the run was made with, its settings. Throws base::InputError if the folder cannot be
/// written.
void write_run(const std::filesystem::path& folder, const std::vector<Table>& tables,
               const Record& environment, const Record& settings);

enum class Found : std::uint8_t { Nothing, ThisRun, AnotherRun };

/// Does the folder have a run, and is it one of these settings?
Found find_run(const std::filesystem::path& folder, const Record& settings);

/// Returns the tables of a run. Throws base::InputError that says what is missing or broken.
std::vector<Table> read_run(const std::filesystem::path& folder);

/// All tables one after the other; JSON as `{"tables": [...]}`.
std::string write(const std::vector<Table>& tables, Format format);

}  // namespace lamina::report
