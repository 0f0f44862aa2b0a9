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
  std::string quadratic = "careful";
  std::string quartic = "monotone";

  void add_to(CLI::App& command) {
    command.add_option("--quadratic", quadratic, "quadratic solver: plain, careful")
        ->capture_default_str();
    command.add_option("--quartic", quartic, "quartic solver: ferrari, monotone")
        ->capture_default_str();
  }
  [[nodiscard]] poly::Solvers solvers() const { return parse_solvers(quadratic, quartic); }
};

/// What `lamina explain` needs besides scene and ray to see what these options made of them:
/// those that are not the defaults, each behind a blank.
inline std::string replay_options(const scene::ReadOptions& read, const SolverOptions& solvers) {
  const SolverOptions defaults;
  std::string text = read.facets ? " --facets" : "";
  if (solvers.quadratic != defaults.quadratic) {
    text += " --quadratic " + solvers.quadratic;
  }
  if (solvers.quartic != defaults.quartic) {
    text += " --quartic " + solvers.quartic;
  }
  return text;
}

}  // namespace lamina::cli
