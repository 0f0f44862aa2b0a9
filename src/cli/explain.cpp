#include <fmt/format.h>

#include <memory>

#include "base/contract.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "report/explain.hpp"
#include "trace/camera.hpp"

namespace lamina::cli {
namespace {

struct Options {
  SceneOptions scene;
  SolverOptions solvers;
  std::string ray;
  std::vector<double> pixel;
  std::string size = "640x480";
  std::string methods = "all";
  std::string numbers = "float,double,exact";
};

void run(const Options& options) {
  if (options.ray.empty() == options.pixel.empty()) {
    throw base::InputError(
        "explain: give one ray, either --ray \"ox oy oz dx dy dz\" or --pixel X,Y");
  }
  const scene::Scene scene = options.scene.open();
  geometry::ExactRay ray;
  if (!options.ray.empty()) {
    ray = parse_ray(options.ray);
  } else {
    if (!scene.camera) {
      throw base::InputError(fmt::format(
          "{}: the scene has no camera, so --pixel means nothing: give --ray", options.scene.path));
    }
    ray = trace::pixel_ray(*scene.camera, parse_size(options.size), options.pixel[0],
                           options.pixel[1]);
  }
  const auto methods = parse_methods(options.methods);
  const auto numbers = parse_numbers(options.numbers);
  fmt::print("{}", report::explain(scene, ray, methods, numbers, options.solvers.solvers()));
}

}  // namespace

void add_explain(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "explain", "one ray: its events in exact order, and where each method departs from them");
  command->footer(
      "Example: lamina explain data/scenes/figure04.csg --pixel 320,200 --methods roth\n"
      "         lamina explain model.csg --ray \"0 -5 1/2 0.1 1 0\" --numbers float,exact");
  options->scene.add_to(*command);
  command->add_option("--ray", options->ray, "\"ox oy oz dx dy dz\" (decimal or a/b)");
  command->add_option("--pixel", options->pixel, "X,Y of the camera's image, from the top left")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--size", options->size, "WxH of that image")->capture_default_str();
  command->add_option("--methods", options->methods, "separated by commas, or all")
      ->capture_default_str();
  command->add_option("--numbers", options->numbers, "separated by commas, or all")
      ->capture_default_str();
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
