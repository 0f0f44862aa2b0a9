#include "cli/tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.hpp"

namespace lamina::cli {

void TableOptions::add_to(CLI::App& command) {
  command.add_option("--format", format, "md, csv, json, latex")->capture_default_str();
  command.add_option("--table", name,
                     "one table only, by its name: artifacts, paired (two methods on the same "
                     "rays), clock, environment, or one of the experiment's own");
}

void TableOptions::check(const std::vector<report::Table>& tables) const {
  static_cast<void>(report::parse_format(format));
  std::vector<std::string> names;
  for (const report::Table& table : tables) {
    names.push_back(table.name);
  }
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
    throw base::InputError(
        fmt::format("no table '{}'; there are: {}", name, fmt::join(names, ", ")));
  }
}

void print_tables(const std::vector<report::Table>& tables, const TableOptions& options) {
  const report::Format format = report::parse_format(options.format);
  std::vector<report::Table> chosen;
  std::copy_if(tables.begin(), tables.end(), std::back_inserter(chosen),
               [&options](const report::Table& table) {
                 return options.name.empty() ? !table.on_request : table.name == options.name;
               });
  if (format == report::Format::Csv) {
    chosen.resize(1);
  }
  fmt::print("{}", options.name.empty() ? report::write(chosen, format)
                                        : report::write(chosen.front(), format));
}

}  // namespace lamina::cli
