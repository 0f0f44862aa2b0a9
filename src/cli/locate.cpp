#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/options.hpp"
#include "cli/parallel_lines.hpp"
#include "method/locate.hpp"
#include "trace/number_choice.hpp"

namespace lamina::cli {
namespace {

struct Options {
  SceneOptions scene;
  std::string points;
  std::string number = "exact";
};

std::string line_of(const scene::Scene& scene, const method::Location& location,
                    std::size_t point) {
  nlohmann::ordered_json object{{"point", point}, {"medium", nullptr}};
  if (location.medium != csg::kEmpty) {
    object["medium"] = scene.materials[location.medium].name;
  }
  if (location.boundary) {
    object["boundary"] = true;
  }
  if (location.undecided) {
    object["undecided"] = true;
  }
  return object.dump();
}

void run(const Options& options) {
  const scene::Scene scene = options.scene.open();
  const auto points = read_points(options.points);
  const trace::NumberChoice number = parse_number(options.number);
  const bool exact = number.significand_bits == 0;
  print_lines(
      points.size(), [&] { return exact ? nullptr : number.make_tracer(scene, {}); },
      [&](const std::unique_ptr<method::Tracer>& tracer, std::size_t i) {
        const method::Location location =
            exact ? method::locate_exact(scene, points[i])
                  : method::Location{tracer->medium_at(points[i]), false, false};
        return line_of(scene, location, i);
      });
}

}  // namespace

void add_locate(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("locate", "the medium at points: JSON, a point a line");
  command->footer(
      "Each line: {\"point\":0,\"medium\":\"steel\"}; null is empty. A point on the boundary of "
      "the\n"
      "regularized solid has \"boundary\":true; a point on carriers has the medium that all\n"
      "directions around it share, so the plane between two touching boxes is inside. Where "
      "curved\n"
      "surfaces touch at the point, \"undecided\":true says that not all directions could be told\n"
      "apart. Rounded number types test f(p) <= 0 and know no boundary.\n\n"
      "Example: lamina locate data/scenes/figure07.csg --points points.txt");
  options->scene.add_to(*command);
  command
      ->add_option("--points", options->points,
                   "file: a point a line, x y z (decimal or a/b), # comments")
      ->required();
  command->add_option("--number", options->number, "see `lamina list numbers`")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace lamina::cli
