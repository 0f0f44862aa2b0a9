#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "report/run_folder.hpp"

namespace lamina::cli {

void add_table(CLI::App& app) {
  struct Options {
    std::string folder;
    std::string format = "md";
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("table", "prints the tables of a run kept by --out");
  command->footer("Example: lamina table results/coincident --format latex");
  command->add_option("dir", options->folder, "the folder that --out named")->required();
  command->add_option("--format", options->format, "md, csv, json, latex")->capture_default_str();
  command->callback([options] {
    const report::Format format = report::parse_format(options->format);
    fmt::print("{}", report::write(report::read_run(options->folder), format));
  });
}

}  // namespace lamina::cli
