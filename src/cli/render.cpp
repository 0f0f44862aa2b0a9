#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>

#include "base/contract.hpp"
#include "census/artifact_map.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "report/fault_table.hpp"
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

// What is right is grey and dark, with the scene faintly in it.
trace::Color of_right_pixel(const std::array<std::uint8_t, 3>& seen) {
  const double grey = 0.08 + 0.35 * (0.3 * seen[0] + 0.6 * seen[1] + 0.1 * seen[2]) / 255;
  return {grey, grey, grey};
}

// A map of each pixel's first fault, made with the picture.
class ArtifactMap {
 public:
  explicit ArtifactMap(const trace::ImageSize& size)
      : width_(size.width), states_(static_cast<std::size_t>(size.width) * size.height, kNotDone) {}

  void set(int x, int y, const census::FaultCounts& counts) {
    states_[static_cast<std::size_t>(y) * width_ + x] =
        counts.first ? static_cast<std::uint8_t>(*counts.first) : kRight;
  }

  // The map, and below it a square for each fault in the order of the table.
  [[nodiscard]] trace::Image over(const trace::Image& picture) const {
    constexpr int kSquare = 14;
    const trace::ImageSize& size = picture.size();
    trace::Image map({size.width, size.height + kSquare});
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const std::uint8_t state = states_[static_cast<std::size_t>(y) * width_ + x];
        if (state != kNotDone) {
          map.set(x, y,
                  state == kRight ? of_right_pixel(picture.at(x, y))
                                  : census::fault_texts()[state].color);
        }
      }
    }
    const int squares = std::min(static_cast<int>(census::kFaultCount), size.width / kSquare);
    for (int y = 2; y < kSquare; ++y) {
      for (int x = 0; x < squares * kSquare; ++x) {
        if (x % kSquare >= 2) {
          map.set(x, size.height + y, census::fault_texts()[x / kSquare].color);
        }
      }
    }
    return map;
  }

  // Of the pixels that are done.
  [[nodiscard]] report::FaultPixels pixels() const {
    report::FaultPixels pixels{};
    for (const std::uint8_t state : states_) {
      if (state != kNotDone) {
        ++pixels[state];
      }
    }
    return pixels;
  }

 private:
  static constexpr std::uint8_t kRight = census::kFaultCount;
  static constexpr std::uint8_t kNotDone = kRight + 1;

  int width_;
  std::vector<std::uint8_t> states_;  // by pixel: a fault, or one of the two above
};

// Renders pixels, and counts their faults if they are asked for.
struct Worker {
  std::unique_ptr<census::FaultFinder> faults;
  std::unique_ptr<trace::Whitted> whitted;
  census::FaultCounts counts;
};

void run(const Options& options) {
  options.tables.check({report::fault_table({}, {})});
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
  ArtifactMap map(size);
  // That they can be written shows before the work.
  trace::write_png(picture, options.out);
  if (judged) {
    trace::write_png(picture, options.artifacts);
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
        map.set(x, y, worker->faults->counts());
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
    print_tables({report::fault_table(map.pixels(), counts)}, options.tables);
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
