#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/contract.hpp"
#include "census/census.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "report/census_table.hpp"
#include "scene/rays.hpp"
#include "trace/camera.hpp"

namespace lamina::cli {
namespace {

struct Options {
  std::vector<std::string> scenes;
  SceneOptions read;
  SolverOptions solvers;
  std::string methods = "all";
  std::string numbers = "all";
  std::uint64_t rays = 1000;
  std::string rays_file;
  std::uint64_t seed = 1;
  int threads = 0;
  TableOptions tables{.name = "artifacts"};
};

// Folders stand for the scene files in them.
std::vector<std::string> scene_paths(const std::vector<std::string>& given) {
  std::vector<std::string> paths;
  for (const std::string& path : given) {
    if (!std::filesystem::is_directory(path)) {
      paths.push_back(path);
      continue;
    }
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      if (entry.path().extension() == ".csg") {
        files.push_back(entry.path().string());
      }
    }
    if (files.empty()) {
      throw base::InputError(fmt::format("folder '{}' has no .csg files", path));
    }
    std::sort(files.begin(), files.end());
    paths.insert(paths.end(), files.begin(), files.end());
  }
  return paths;
}

// Task `index` of a scene: its part of the given rays, or of random ones.
std::vector<geometry::ExactRay> draw_rays(const scene::Scene& scene, const Options& options,
                                          std::size_t index, std::uint64_t count) {
  base::SeededStream stream("census/rays", options.seed, index);
  return scene.bounds ? scene::uniform_rays(*scene.bounds, count, stream)
                      : trace::camera_rays(*scene.camera, count, stream);
}

census::Census scene_census(const scene::Scene& scene, const Options& options,
                            const census::Plan& plan, const std::vector<geometry::ExactRay>& given,
                            const census::Progress& progress) {
  if (given.empty() && !scene.bounds && !scene.camera) {
    throw base::InputError(
        fmt::format("{}: nothing in the scene is bounded and it has no camera, so there is nothing "
                    "to aim rays at: give --rays-file",
                    scene.name));
  }
  constexpr std::uint64_t kRaysPerTask = 64;
  const std::uint64_t count = given.empty() ? options.rays : given.size();
  return census::run_census(
      plan, (count + kRaysPerTask - 1) / kRaysPerTask,
      [&](std::size_t index) {
        const std::uint64_t first = index * kRaysPerTask;
        const std::uint64_t last = std::min(first + kRaysPerTask, count);
        return census::Task{
            scene, given.empty() ? draw_rays(scene, options, index, last - first)
                                 : std::vector(given.begin() + static_cast<std::ptrdiff_t>(first),
                                               given.begin() + static_cast<std::ptrdiff_t>(last))};
      },
      progress);
}

std::vector<report::Table> tables_of(const std::vector<report::LabelledCensus>& censuses) {
  const std::vector<report::Column> labels{{"scene", "scene", ""}};
  return {report::census_table(censuses, labels, "census"),
          report::paired_table(censuses, labels, "census: methods in pairs")};
}

void run(const Options& options) {
  options.tables.check(tables_of({}));
  const census::Plan plan{parse_methods(options.methods), parse_numbers(options.numbers),
                          options.solvers.solvers(), options.threads};
  const auto rays =
      options.rays_file.empty() ? std::vector<geometry::ExactRay>{} : read_rays(options.rays_file);
  if (!options.rays_file.empty() && rays.empty()) {
    throw base::InputError(fmt::format("'{}' has no rays", options.rays_file));
  }
  catch_interrupts();
  std::vector<report::LabelledCensus> censuses;
  for (const std::string& path : scene_paths(options.scenes)) {
    SceneOptions one = options.read;
    one.path = path;
    const scene::Scene scene = one.open();
    censuses.push_back({{path},
                        scene_census(scene, options, plan, rays, progress_bar(path)),
                        replay_options(options.read.read, options.solvers)});
    if (censuses.back().census.interrupted) {
      break;
    }
  }
  std::vector<report::Table> tables = tables_of(censuses);
  if (interrupted()) {
    tables[0].notes.emplace_back("Interrupted: the counts are of the rays that were finished.");
  }
  print_tables(tables, options.tables);
}

}  // namespace

void add_census(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "census", "counts what each method in each number type gets wrong on a scene");
  command->footer(
      "Rays go through uniformly random points of the scene's bounding box, from outside, or of "
      "its\n"
      "camera's image where nothing is bounded; float holds them exactly, and all methods and "
      "number\n"
      "types get the same. Below the table is what each column means, and rays to replay with\n"
      "`lamina explain`.\n\n"
      "Example: lamina census data/scenes/figure07.csg --numbers float,double --rays 10000");
  command->add_option("scene", options->scenes, "scene files (.csg), folders, family members")
      ->required();
  options->read.add_facets_to(*command);
  command->add_option("--methods", options->methods, "separated by commas, or all")
      ->capture_default_str();
  command->add_option("--numbers", options->numbers, "separated by commas, or all")
      ->capture_default_str();
  command->add_option("--rays", options->rays, "number of rays for each scene")
      ->capture_default_str();
  command->add_option("--rays-file", options->rays_file, "these rays instead of random ones");
  command->add_option("--seed", options->seed, "of the random rays")->capture_default_str();
  command->add_option("--threads", options->threads, "0: all; results do not depend on it")
      ->capture_default_str();
  options->tables.add_to(*command);
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
