// Options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "cli/registry.hpp"
#include "scene/families.hpp"
#include "scene/scene.hpp"

namespace lamina::cli {

struct SceneOptions {
  std::string path;
  scene::ReadOptions read;

  void add_to(CLI::App& command) {
    command.add_option("scene", path, "a scene file (.csg), or family:NAME:SEED:CASE")->required();
    add_facets_to(command);
  }
  void add_facets_to(CLI::App& command) {
    command.add_flag("--facets", read.facets,
                     "read spheres, cylinders and cones as OpenSCAD facets them");
  }
  /// Opens the scene; its warnings go to standard error.
  [[nodiscard]] scene::Scene open() const {
    scene::Scene scene = scene::open_scene(path, read);
    for (const std::string& warning : scene.warnings) {
      std::fprintf(stderr, "%s\n", warning.c_str());
    }
    return scene;
  }
};

struct SolverOptions {
  std::string names;
  std::string recentred{poly::name_of(poly::Solvers().recentring)};
  std::string search{poly::name_of(poly::Solvers().search)};

  void add_to(CLI::App& command) {
    command.add_option(
        "--solver", names,
        "root finders of quadrics, tori and sweeps, separated by commas, in place of the "
        "default ones (lamina list solvers)");
    command
        .add_option("--recentred", recentred,
                    "whose rays are solved for from their point nearest to the surface's centre: "
                    "none, tori (from afar), all (quadrics too)")
        ->capture_default_str();
    command
        .add_option("--search", search,
                    "how sweeps of splines are searched for crossings: polynomial (by --solver), "
                    "subdivision, strip-tree")
        ->capture_default_str();
  }
  /// Those named, in their order; none by default.
  [[nodiscard]] std::vector<poly::Solver> list() const {
    return names.empty() ? std::vector<poly::Solver>() : parse_solver_list(names);
  }
  [[nodiscard]] poly::Solvers solvers() const {
    poly::Solvers solvers = names.empty() ? poly::Solvers() : parse_solvers(names);
    solvers.recentring = poly::parse_recentring(recentred);
    solvers.search = poly::parse_sweep_search(search);
    return solvers;
  }
};

/// What `lamina explain` needs besides scene and ray to see what these options made of them:
/// those that are not the defaults, each behind a blank.
inline std::string replay_options(const scene::ReadOptions& read, const SolverOptions& solvers) {
  const SolverOptions as_ever;
  const auto other = [](const char* option, const std::string& given, const std::string& usual) {
    return given == usual ? std::string() : option + given;
  };
  return std::string(read.facets ? " --facets" : "") +
         other(" --recentred ", solvers.recentred, as_ever.recentred) +
         other(" --search ", solvers.search, as_ever.search) +
         (solvers.names.empty() ? std::string() : " --solver " + solvers.names);
}

}  // namespace lamina::cli
