#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <string>

#include "base/contract.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "scene/writer.hpp"

namespace lamina::cli {
namespace {

struct Options {
  SceneOptions scene;
  std::string out;
};

void run(const Options& options) {
  const scene::Scene scene = options.scene.open();
  const std::string text = fmt::format("// {}: {} half-spaces, {} different surfaces.\n{}{}",
                                       scene.name, scene.leaves.size(), scene.carriers.size(),
                                       text_of(declarations_of(scene)), text_of(syntax_of(scene)));
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else if (!(std::ofstream(options.out, std::ios::binary) << text).flush()) {
    throw base::InputError(fmt::format("'{}' cannot be written", options.out));
  }
}

}  // namespace

void add_convert(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "convert", "a scene as the half-spaces that it is made of, as a scene file");
  command->footer(
      "What is printed reads back as the same leaves, exactly, so that every ray is rounded\n"
      "alike: planes, quadrics, toruses and sweeps under add, difference and intersection, and\n"
      "with them the looks of materials, camera, lights and background.\n\n"
      "Example: lamina convert data/scenes/hashimoto_figure2.csg -o glass.csg");
  options->scene.add_to(*command);
  command->add_option("-o,--out", options->out, "write to this file, not to the terminal");
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
