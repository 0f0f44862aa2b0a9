// Printing the tables of a run: which, and how.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "report/table.hpp"

namespace lamina::cli {

struct TableOptions {
  std::string format = "md";
  std::string name;  ///< empty: all that are not on request

  void add_to(CLI::App& command);
  /// Throws base::InputError for an unknown format, or a name that none of these tables has: to
  /// be asked before the work.
  void check(const std::vector<report::Table>& tables) const;
  [[nodiscard]] bool is_for_programs() const { return format == "csv" || format == "json"; }
};

/// Prints the table that was asked for alone; else all but those on request, or in CSV, of which
/// a file holds one, the first. Contract: options.check(tables).
void print_tables(const std::vector<report::Table>& tables, const TableOptions& options);

}  // namespace lamina::cli
