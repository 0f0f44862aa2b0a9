#include <fmt/format.h>

#include <memory>

#include "base/contract.hpp"
#include "census/run_store.hpp"
#include "cli/commands.hpp"
#include "cli/tables.hpp"
#include "experiments/runner.hpp"

namespace lamina::cli {
namespace {

std::vector<report::Table> tables_in(const std::string& folder) {
  const census::RunStore store = census::RunStore::open(folder);
  for (const auto& [name, value] : store.settings()) {
    if (name == "experiment") {
      return experiments::tables_of(experiments::find_experiment(value), store);
    }
  }
  throw base::InputError(fmt::format("the run in '{}' does not say of what experiment", folder));
}

}  // namespace

void add_table(CLI::App& app) {
  struct Options {
    std::string folder;
    TableOptions tables;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("table", "prints the tables of a run kept by --out");
  command->footer(
      "A run that is not finished shows what it has so far. CSV is one table, the first unless\n"
      "--table names another.\n\n"
      "Example: lamina table results/coincident --format latex\n"
      "         lamina table results/coincident --table paired --format csv");
  command->add_option("dir", options->folder, "the folder that --out named")->required();
  options->tables.add_to(*command);
  command->callback([options] {
    const std::vector<report::Table> tables = tables_in(options->folder);
    options->tables.check(tables);
    print_tables(tables, options->tables);
  });
}

}  // namespace lamina::cli
