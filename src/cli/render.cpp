#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <mutex>

#include "base/contract.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "report/artifact_map.hpp"
#include "trace/render.hpp"
#include "trace/whitted.hpp"

namespace lamina::cli {
namespace {

struct Options {
  SceneOptions scene;
  SolverOptions solvers;
  std::string out;
  std::string artifacts;
  std::string method = "wyvill-trotman";
  std::string number = "double";
  std::string spawn = "none";
  std::string size = "640x480";
  int depth = 5;
  int threads = 0;
  TableOptions tables;
};

// Renders pixels, and counts their faults if they are asked for.
struct Worker {
  std::unique_ptr<census::FaultFinder> faults;
  std::unique_ptr<trace::Whitted> whitted;
  census::FaultCounts counts;
};

void run(const Options& options) {
  options.tables.check({report::fault_table(report::ArtifactMap({0, 0}), {})});
  const scene::Scene scene = options.scene.open();
  if (!scene.camera) {
    throw base::InputError(fmt::format(
        "{}: the scene has no camera: add camera(eye=[x, y, z], look_at=[x, y, z]);", scene.name));
  }
  if (scene.lights.empty()) {
    fmt::print(stderr,
               "{}: warning: no light, so only ambient light shows: add light(position="
               "[x, y, z]);\n",
               scene.name);
  }
  const trace::NumberChoice number = parse_number(options.number);
  if (!number.make_path) {
    throw base::InputError(
        fmt::format("--number {}: no rays are spawned in it, since the points that they start at "
                    "are no rational ones; choose a rounded number type",
                    options.number));
  }
  const trace::RenderOptions render{parse_method(options.method), trace::parse_spawn(options.spawn),
                                    options.depth};
  const poly::Solvers solvers = options.solvers.solvers();
  const trace::ImageSize size = parse_size(options.size);
  const bool judged = !options.artifacts.empty();
  trace::Image picture(size);
  report::ArtifactMap map(size);
  // That they can be written shows before the work, which replaces what is there.
  trace::require_writable(options.out);
  if (judged) {
    trace::require_writable(options.artifacts);
  }

  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::shared_ptr<Worker>> workers;
  std::mutex workers_mutex;
  const auto make_work = [&]() -> trace::PixelWork {
    const auto worker = std::make_shared<Worker>();
    worker->faults = judged ? std::make_unique<census::FaultFinder>(scene) : nullptr;
    worker->whitted = std::make_unique<trace::Whitted>(scene, number.make_path(scene, solvers),
                                                       render, worker->faults.get());
    const std::lock_guard lock(workers_mutex);
    workers.push_back(worker);
    return [&, worker](int x, int y) {
      picture.set(x, y, worker->whitted->color(trace::pixel_ray(*scene.camera, size, x, y)));
      if (judged) {
        map.set(x, y, worker->faults->counts().first);
        worker->counts.add(worker->faults->counts());
      }
    };
  };
  const bool finished =
      trace::each_pixel(size, options.threads, make_work, progress_bar(scene.name));
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  trace::write_png(picture, options.out);
  if (judged) {
    trace::write_png(map.over(picture), options.artifacts);
    census::FaultCounts counts;
    for (const auto& worker : workers) {
      counts.add(worker->counts);
    }
    print_tables({report::fault_table(map, counts)}, options.tables);
  }
  fmt::print(stderr, "{}: {}, {:.1f} s{}\n", options.out, options.size, spent.count(),
             finished ? "" : "; interrupted: the rows below are black");
}

}  // namespace

void add_render(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("render", "a picture of a scene, and a map of what is wrong with it");
  command->footer(
      "Whitted's shading: ambient and diffuse light, highlights, shadows, mirrors, refraction.\n"
      "--artifacts judges every ray of every pixel's tree against the truth, which takes longer,\n"
      "paints each pixel by the first fault found, and prints the legend with the counts.\n\n"
      "Example: lamina render data/scenes/figure14_torus.csg -o torus.png --method roth\n"
      "         lamina render data/scenes/figure15.csg -o lamina.png --artifacts faults.png");
  options->scene.add_to(*command);
  command->add_option("-o,--out", options->out, "the picture, a PNG file")->required();
  command->add_option("--artifacts", options->artifacts, "the map of artifacts, a PNG file");
  command->add_option("--method", options->method, "see `lamina list methods`")
      ->capture_default_str();
  command->add_option("--number", options->number, "see `lamina list numbers`")
      ->capture_default_str();
  command->add_option("--spawn", options->spawn, "see `lamina list spawns`")->capture_default_str();
  command->add_option("--size", options->size, "WxH in pixels")->capture_default_str();
  command->add_option("--depth", options->depth, "of the ray tree; 0: primary and shadow rays")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  command->add_option("--threads", options->threads, "0: all; the picture does not depend on it")
      ->capture_default_str();
  options->tables.add_to(*command);
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
