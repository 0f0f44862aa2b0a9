#include <fmt/format.h>

#include <memory>

#include "base/environment.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "experiments/experiment.hpp"
#include "number/versions.hpp"
#include "report/run_folder.hpp"

namespace lamina::cli {
namespace {

struct Options {
  std::string experiment;
  SceneOptions read;
  SolverOptions solvers;
  std::string methods = "all";
  std::string numbers;
  std::uint64_t rays = 0;
  std::uint64_t seed = 1;
  int threads = 0;
  std::string out;
  std::string format = "md";
};

std::vector<method::NumberChoice> numbers_of(const Options& options,
                                             const experiments::Experiment& experiment) {
  if (!options.numbers.empty() || experiment.default_numbers.empty()) {
    return parse_numbers(options.numbers.empty() ? "all" : options.numbers);
  }
  return parse_numbers(fmt::format("{}", fmt::join(experiment.default_numbers, ",")));
}

void run(const Options& options) {
  const report::Format format = report::parse_format(options.format);
  const experiments::Experiment& experiment = experiments::find_experiment(options.experiment);
  experiments::Settings settings;
  settings.plan = {parse_methods(options.methods), numbers_of(options, experiment),
                   options.solvers.solvers(), options.threads};
  settings.read = options.read.read;
  settings.rays = options.rays == 0 ? experiment.default_rays : options.rays;
  settings.seed = options.seed;
  settings.progress = progress_bar();
  catch_interrupts();
  const experiments::Result result = experiment.run(settings);
  if (!options.out.empty()) {
    auto environment = base::environment();
    for (auto& version : number::library_versions()) {
      environment.push_back(std::move(version));
    }
    environment.emplace_back("experiment", experiment.name);
    environment.emplace_back("rays", fmt::format("{}", settings.rays));
    environment.emplace_back("seed", fmt::format("{}", settings.seed));
    report::write_run(options.out, result.tables, environment);
  }
  fmt::print("{}", report::write(result.tables, format));
}

}  // namespace

void add_run(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "runs an experiment and prints its tables");
  command->footer(
      "See `lamina list experiments`, and README.md in the experiment's folder. Ctrl-C stops after\n"
      "the work in hand and prints what is finished.\n\n"
      "Example: lamina run coincident-faces --rays 100000 --out results/coincident");
  command->add_option("experiment", options->experiment)->required();
  command->add_option("--rays", options->rays, "rays in all; 0: the experiment's own number")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of scenes and rays")->capture_default_str();
  command->add_option("--methods", options->methods, "separated by commas, or all")
      ->capture_default_str();
  command->add_option("--numbers", options->numbers,
                      "separated by commas, or all; default: the experiment's own");
  command->add_option("--threads", options->threads, "0: all; results do not depend on it")
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for the tables, for `lamina table`");
  command->add_option("--format", options->format, "md, csv, json, latex")->capture_default_str();
  options->read.add_facets_to(*command);
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
