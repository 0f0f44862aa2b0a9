#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/parallel_lines.hpp"
#include "trace/number_choice.hpp"

namespace lamina::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  SceneOptions scene;
  SolverOptions solvers;
  std::string rays;
  std::string method = "wyvill-trotman";
  std::string number = "double";
  bool truth = false;
};

struct Worker {
  std::unique_ptr<method::Tracer> tracer;
  method::Report report;
};

Json medium_json(const scene::Scene& scene, csg::Medium medium) {
  return medium == csg::kEmpty ? Json(nullptr) : Json(scene.materials[medium].name);
}

std::string line_of(const scene::Scene& scene, const Worker& worker, std::size_t ray) {
  Json transitions = Json::array();
  for (const method::Interface& seen : worker.report.interfaces) {
    transitions.push_back({{"t", worker.tracer->t(seen.crossing)},
                           {"from", medium_json(scene, seen.transition.from)},
                           {"to", medium_json(scene, seen.transition.to)},
                           {"leaf", worker.tracer->crossings()[seen.crossing].leaf}});
  }
  Json object{{"ray", ray},
              {"start", medium_json(scene, worker.report.start)},
              {"transitions", std::move(transitions)}};
  if (worker.tracer->in_some_carrier()) {
    object["in_carrier"] = true;
  }
  return object.dump();
}

void run(const Options& options) {
  const scene::Scene scene = options.scene.open();
  const auto rays = read_rays(options.rays);
  const method::Method method =
      options.truth ? method::regularized() : parse_method(options.method);
  const trace::NumberChoice number = parse_number(options.truth ? "exact" : options.number);
  const poly::Solvers solvers = options.solvers.solvers();
  print_lines(
      rays.size(),
      [&] {
        return Worker{number.make_tracer(scene, solvers), {}};
      },
      [&](Worker& worker, std::size_t i) {
        worker.tracer->find(rays[i]);
        worker.tracer->run(method, worker.report);
        return line_of(scene, worker, i);
      });
}

}  // namespace

void add_trace(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("trace", "what a method sees along rays: JSON, a ray a line");
  command->footer(
      "Each line: {\"ray\":0,\"start\":null,\"transitions\":[{\"t\":1.25,\"from\":null,"
      "\"to\":\"steel\",\"leaf\":3}]}\n"
      "start is the medium at t = 0+, null is empty; transitions have t > 0 in the method's "
      "order;\n"
      "t is the nearest double; leaf counts from 0 in the order of the scene. A ray that lies in "
      "a\n"
      "carrier, and by convention is outside of it, has \"in_carrier\":true besides.\n\n"
      "Example: lamina trace data/scenes/figure04.csg --rays rays.txt --truth");
  options->scene.add_to(*command);
  command
      ->add_option("--rays", options->rays,
                   "file: a ray a line, ox oy oz dx dy dz (decimal or a/b), # comments")
      ->required();
  command->add_option("--method", options->method, "see `lamina list methods`")
      ->capture_default_str();
  command->add_option("--number", options->number, "see `lamina list numbers`")
      ->capture_default_str();
  command->add_flag("--truth", options->truth, "the same as --method regularized --number exact");
  options->solvers.add_to(*command);
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
