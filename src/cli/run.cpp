#include <fmt/format.h>

#include <memory>

#include "base/contract.hpp"
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
  bool resume = false;
  std::string format = "md";
};

std::vector<method::NumberChoice> numbers_of(const Options& options,
                                             const experiments::Experiment& experiment) {
  if (!options.numbers.empty() || experiment.default_numbers.empty()) {
    return parse_numbers(options.numbers.empty() ? "all" : options.numbers);
  }
  return parse_numbers(fmt::format("{}", fmt::join(experiment.default_numbers, ",")));
}

std::string names_of(const std::vector<method::Method>& methods) {
  std::vector<std::string> names;
  for (const method::Method& method : methods) {
    names.push_back(method.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

std::string names_of(const std::vector<method::NumberChoice>& numbers) {
  std::vector<std::string> names;
  for (const method::NumberChoice& number : numbers) {
    names.push_back(number.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

// Everything that the tables depend on.
report::Record record_of(const Options& options, const experiments::Settings& settings) {
  return {{"experiment", options.experiment},
          {"rays", fmt::format("{}", settings.rays)},
          {"seed", fmt::format("{}", settings.seed)},
          {"methods", names_of(settings.plan.methods)},
          {"numbers", names_of(settings.plan.numbers)},
          {"quadratic", options.solvers.quadratic},
          {"quartic", options.solvers.quartic},
          {"facets", settings.read.facets ? "yes" : "no"}};
}

// The run is in the folder already: true. Throws if something else is.
bool is_done(const Options& options, const report::Record& settings) {
  const report::Found found =
      options.out.empty() ? report::Found::Nothing : report::find_run(options.out, settings);
  if (found == report::Found::Nothing || (found == report::Found::ThisRun && options.resume)) {
    return found == report::Found::ThisRun;
  }
  throw base::InputError(
      fmt::format("folder '{}' has {}", options.out,
                  found == report::Found::ThisRun
                      ? "this run already: see it with `lamina table`, or give --resume"
                      : "a run of other settings, which would be lost: name another folder"));
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
  const report::Record record = record_of(options, settings);
  if (is_done(options, record)) {
    fmt::print("{}", report::write(report::read_run(options.out), format));
    return;
  }
  catch_interrupts();
  const experiments::Result result = experiment.run(settings);
  fmt::print("{}", report::write(result.tables, format));
  if (options.out.empty() || result.interrupted) {
    return;
  }
  report::Record environment = base::environment();
  for (auto& version : number::library_versions()) {
    environment.push_back(std::move(version));
  }
  report::write_run(options.out, result.tables, environment, record);
}

}  // namespace

void add_run(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "runs an experiment and prints its tables");
  command->footer(
      "See `lamina list experiments`, and README.md in the experiment's folder. Ctrl-C stops "
      "after\n"
      "the work in hand and prints what is finished; only whole runs are kept in a folder.\n\n"
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
  command->add_option("--out", options->out, "folder for the finished tables, for `lamina table`");
  command->add_flag("--resume", options->resume,
                    "if that folder has this run already, print it instead of running again");
  command->add_option("--format", options->format, "md, csv, json, latex")->capture_default_str();
  options->read.add_facets_to(*command);
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
