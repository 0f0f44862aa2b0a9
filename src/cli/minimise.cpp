#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "base/contract.hpp"
#include "census/minimise.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "geometry/ray_text.hpp"
#include "report/explain.hpp"
#include "report/symptom.hpp"
#include "trace/number_choice.hpp"

namespace lamina::cli {
namespace {

struct Options {
  SceneOptions scene;
  SolverOptions solvers;
  std::string ray;
  std::string method;
  std::string number;
  std::string out;
};

// Lines of comment in the scene language.
std::string commented(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    result += line.empty() ? "//\n" : fmt::format("// {}\n", line);
  }
  return result;
}

// The small case as a scene file that says what it shows and how to replay it.
std::string document(const Options& options, const census::Case& small,
                     const report::Symptom& symptom, std::size_t leaves_before,
                     std::span<const method::Method> methods,
                     std::span<const trace::NumberChoice> numbers, const poly::Solvers& solvers) {
  const std::string file = options.out.empty() ? "FILE" : fmt::format("'{}'", options.out);
  std::string text = fmt::format("// {} in {}: {}\n// leaves: {} of the {} of {}\n",
                                 methods[0].name, numbers[0].name, report::text_of(symptom),
                                 small.scene.leaves.size(), leaves_before, options.scene.path);
  text += small.text;
  text += fmt::format("// lamina explain {} --ray \"{}\" --methods {} --numbers {}", file,
                      geometry::to_text(small.ray), methods[0].name, numbers[0].name);
  // The small scene is made of half-spaces: there is nothing to facet.
  text += replay_options({}, options.solvers);
  scene::Scene named = small.scene;
  named.name = options.out.empty() ? file : options.out;
  return text + "\n//\n" + commented(report::explain(named, small.ray, methods, numbers, solvers));
}

void run(const Options& options) {
  const std::array methods{parse_method(options.method)};
  const std::array numbers{parse_number(options.number)};
  const poly::Solvers solvers = options.solvers.solvers();
  const geometry::ExactRay ray = parse_ray(options.ray);
  const scene::Scene scene = options.scene.open();
  const auto symptom_of = [&](const scene::Scene& s, const geometry::ExactRay& r) {
    return report::symptom(s, r, methods[0], numbers[0], solvers);
  };
  const auto symptom = symptom_of(scene, ray);
  if (!symptom) {
    throw base::InputError(fmt::format(
        "minimise: nothing is wrong to keep: on this ray {} in {} is right, or the ray lies in a "
        "surface; `lamina census` prints rays on which something is wrong",
        methods[0].name, numbers[0].name));
  }
  // Asked before the work, so that a wrong name does not cost it; nothing is lost yet.
  if (!options.out.empty() && !std::ofstream(options.out, std::ios::app)) {
    throw base::InputError(fmt::format("'{}' cannot be written", options.out));
  }
  catch_interrupts();
  const census::Case small = census::minimise(
      scene, ray,
      [&](const auto& s, const auto& r) {
        const auto found = symptom_of(s, r);
        return found && found->shows(*symptom);
      },
      progress_bar());
  const std::string text = document(options, small, *symptom_of(small.scene, small.ray),
                                    scene.leaves.size(), methods, numbers, solvers);
  fmt::print("{}", text);
  if (!options.out.empty() && !(std::ofstream(options.out, std::ios::binary) << text).flush()) {
    throw base::InputError(fmt::format("'{}' cannot be written", options.out));
  }
}

}  // namespace

void add_minimise(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "minimise", "a small scene and ray on which a method shows the same artifact");
  command->footer(
      "Prints a scene file: comments say what it shows, how to replay it, and explain it.\n"
      "Example: lamina minimise model.csg --ray \"0 -5 1/2 0.1 1 0\" --method roth --number float "
      "-o small.csg\n"
      "`lamina census` prints rays on which something is wrong. Ctrl-C ends with the smallest case "
      "so far.");
  options->scene.add_to(*command);
  command->add_option("--ray", options->ray, "\"ox oy oz dx dy dz\" (decimal or a/b)")->required();
  command->add_option("--method", options->method, "see `lamina list methods`")->required();
  command->add_option("--number", options->number, "see `lamina list numbers`")->required();
  command->add_option("-o,--out", options->out, "also write the small scene to this file");
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
