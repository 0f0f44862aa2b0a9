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
  bool recentred = false;

  void add_to(CLI::App& command) {
    command.add_option("--solver", names,
                       "root finders of quadrics and tori, separated by commas, in place of the "
                       "default ones (lamina list solvers)");
    command.add_flag("--recentred", recentred,
                     "solve for rays from afar at a torus from their point nearest to its centre");
  }
  /// Those named, in their order; none by default.
  [[nodiscard]] std::vector<poly::Solver> list() const {
    return names.empty() ? std::vector<poly::Solver>() : parse_solver_list(names);
  }
  [[nodiscard]] poly::Solvers solvers() const {
    poly::Solvers solvers = names.empty() ? poly::Solvers() : parse_solvers(names);
    solvers.recentred = recentred;
    return solvers;
  }
};

/// What `lamina explain` needs besides scene and ray to see what these options made of them:
/// those that are not the defaults, each behind a blank.
inline std::string replay_options(const scene::ReadOptions& read, const SolverOptions& solvers) {
  return std::string(read.facets ? " --facets" : "") + (solvers.recentred ? " --recentred" : "") +
         (solvers.names.empty() ? std::string() : " --solver " + solvers.names);
}

}  // namespace lamina::cli
