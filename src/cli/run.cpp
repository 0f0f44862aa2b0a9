#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/contract.hpp"
#include "base/environment.hpp"
#include "census/run_store.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "experiments/experiment.hpp"
#include "experiments/runner.hpp"
#include "number/versions.hpp"

namespace lamina::cli {
namespace {

struct Options {
  std::string experiment;
  SceneOptions read;
  SolverOptions solvers;
  std::string methods;
  std::string numbers;
  std::uint64_t rays = 0;
  std::uint64_t seed = 1;
  int threads = 0;
  std::string out;
  bool resume = false;
  TableOptions tables;
};

experiments::Settings settings_of(const Options& options,
                                  const experiments::Experiment& experiment) {
  experiments::Settings settings;
  const std::string& methods =
      options.methods.empty() ? experiment.default_methods : options.methods;
  settings.plan = {
      experiment.default_methods.empty() ? std::vector<method::Method>() : parse_methods(methods),
      parse_numbers(options.numbers.empty() ? experiment.default_numbers : options.numbers),
      experiment.compares_solvers ? poly::Solvers() : options.solvers.solvers(), options.threads};
  settings.solvers = experiment.compares_solvers ? options.solvers.list() : settings.solvers;
  settings.read = options.read.read;
  settings.rays = options.rays == 0 ? experiment.default_rays : options.rays;
  settings.seed = options.seed;
  settings.warn = [](const std::string& message) { fmt::print(stderr, "{}\n", message); };
  return settings;
}

template <typename Named>
std::string names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) {
    names.push_back(one.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

// Everything that the counts depend on.
census::Record record_of(const Options& options, const experiments::Experiment& experiment,
                         const experiments::Settings& settings) {
  return {{"experiment", experiment.name},
          {"rays", fmt::format("{}", settings.rays)},
          {"seed", fmt::format("{}", settings.seed)},
          {"methods", names_of(settings.plan.methods)},
          {"numbers", names_of(settings.plan.numbers)},
          {experiments::kOptionsSetting, replay_options(settings.read, options.solvers)}};
}

census::Record environment() {
  census::Record environment = base::environment();
  for (auto& version : number::library_versions()) {
    environment.push_back(std::move(version));
  }
  return environment;
}

std::string value_in(const census::Record& record, const std::string& name) {
  for (const auto& [known, value] : record) {
    if (known == name) {
      return value;
    }
  }
  return {};
}

// The folder's run, to go on with: it must be one of these settings.
census::RunStore resumed(const std::filesystem::path& folder, const census::Record& settings,
                         bool resume) {
  census::RunStore store = census::RunStore::open(folder);
  for (const auto& [name, value] : settings) {
    if (const std::string there = value_in(store.settings(), name); there != value) {
      throw base::InputError(
          fmt::format("folder '{}' has a run of other settings ({} {}, here {}), which would be "
                      "lost: name another folder",
                      folder.string(), name, there, value));
    }
  }
  if (!resume) {
    throw base::InputError(fmt::format(
        "folder '{0}' has this run already: see it with `lamina table {0}`, or give --resume to "
        "go on with it",
        folder.string()));
  }
  const std::string commit = value_in(environment(), "commit");
  for (const census::Record& session : store.environments()) {
    if (value_in(session, "commit") != commit) {
      throw base::InputError(fmt::format(
          "the run in '{}' was begun by commit {} of Lamina, this is {}: go on with that one, or "
          "name another folder",
          folder.string(), value_in(session, "commit"), commit));
    }
  }
  return store;
}

census::RunStore store_of(const std::string& folder, const census::Record& settings, bool resume) {
  if (folder.empty()) {
    return census::RunStore::in_memory(settings);
  }
  return census::RunStore::exists(folder) ? resumed(folder, settings, resume)
                                          : census::RunStore::begin(folder, settings);
}

void run_one(const Options& options, const experiments::Experiment& experiment,
             const std::string& folder) {
  const experiments::Settings settings = settings_of(options, experiment);
  const std::vector<experiments::Series> series = experiment.series(settings);
  if (std::any_of(series.begin(), series.end(), [](const auto& s) { return s.tasks == 0; })) {
    throw base::InputError(fmt::format("{} has {} series of rays: give --rays {} at least",
                                       experiment.name, series.size(), 12 * series.size()));
  }
  census::RunStore store =
      store_of(folder, record_of(options, experiment, settings), options.resume);
  census::Record session = environment();
  session.emplace_back(
      "threads",
      fmt::format("{}", options.threads > 0 ? options.threads : tbb::info::default_concurrency()));
  store.add_environment(session);
  experiments::run_into(store, series, progress_bar(experiment.name));
  print_tables(experiments::tables_of(experiment, store), options.tables);
  if (interrupted()) {
    fmt::print(
        stderr, "{}\n",
        folder.empty()
            ? "interrupted; with --out FOLDER what is finished would be kept"
            : fmt::format("interrupted; what is finished is in '{}': go on with --resume", folder));
  }
}

void run(const Options& options) {
  const bool all = options.experiment == "all";
  const std::vector<experiments::Experiment> chosen =
      all ? experiments::all_experiments()
          : std::vector{experiments::find_experiment(options.experiment)};
  if (all && options.tables.is_for_programs()) {
    throw base::InputError(
        "run all prints many tables: in csv or json, keep the runs with --out, and ask for one "
        "table after the other with `lamina table`");
  }
  for (const experiments::Experiment& experiment : chosen) {
    options.tables.check(experiments::tables_of(experiment, census::RunStore::in_memory({})));
  }
  catch_interrupts();
  std::size_t failed = 0;
  for (const experiments::Experiment& experiment : chosen) {
    if (interrupted()) {
      break;
    }
    const bool below = all && !options.out.empty();
    try {
      run_one(
          options, experiment,
          below ? (std::filesystem::path(options.out) / experiment.name).string() : options.out);
    } catch (const base::InputError& error) {
      if (!all) {
        throw;
      }
      fmt::print(stderr, "{}: {}\n", experiment.name, error.what());
      ++failed;
    }
  }
  if (failed > 0) {
    throw base::InputError(
        fmt::format("{} of {} experiments could not be run", failed, chosen.size()));
  }
}

}  // namespace

void add_run(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "runs an experiment and prints its tables");
  command->footer(
      "See `lamina list experiments`, and README.md in the experiment's folder; `all` runs every\n"
      "one. With --out the counts are kept in FOLDER/run.sqlite, block after block as they are\n"
      "finished: neither Ctrl-C nor a kill loses more than the block in hand, and --resume goes\n"
      "on from there. Every table is made from that file, here and by `lamina table`.\n\n"
      "Example: lamina run coincident-faces --rays 100000 --out results/coincident");
  command->add_option("experiment", options->experiment, "its name, or all")->required();
  command->add_option("--rays", options->rays, "rays in all; 0: the experiment's own number")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of scenes and rays")->capture_default_str();
  command->add_option("--methods", options->methods,
                      "separated by commas, or all; default: the experiment's own");
  command->add_option("--numbers", options->numbers,
                      "separated by commas, or all; default: the experiment's own");
  command->add_option("--threads", options->threads, "0: all; results do not depend on it")
      ->capture_default_str();
  command->add_option("--out", options->out,
                      "folder to keep the run in; for all, one below it each");
  command->add_flag("--resume", options->resume, "go on with the run that the folder has");
  options->tables.add_to(*command);
  options->read.add_facets_to(*command);
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
