// Series of rays through the members of a family: what most experiments are made of.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "scene/families.hpp"
#include "scene/rays.hpp"

namespace lamina::experiments {

/// Draws one ray at a member of a family.
using DrawRay = std::function<geometry::ExactRay(const scene::FamilyMember&, const scene::Scene&,
                                                 base::SeededStream&)>;

/// Where rays go. Kinds of rays are never pooled.
struct Aim {
  std::string name;  ///< of the random stream, and in tables
  DrawRay draw;
};

/// At a uniformly random point of the scene's bounding box, from outside.
Aim uniform_aim();
/// At a uniformly random point of a patch where leaves coincide, from outside.
Aim coincident_aim();

/// The label column that says where rays went: one of the two above.
report::Column aim_column();

/// `rays` rays, `rays_per_scene` of them for each member 0, 1, ... of the seed. The plan is
/// that of the settings.
Series family_series(std::vector<census::Label> labels, const std::string& family, const Aim& aim,
                     std::uint64_t rays, const Settings& settings,
                     std::uint64_t rays_per_scene = 20);

/// The same rays, each followed along a path of spawned ones, the last of which is judged, in the
/// number types that have spawned rays.
Series spawned_series(std::vector<census::Label> labels, const std::string& family, const Aim& aim,
                      const std::vector<trace::Spawn>& spawns, std::uint64_t rays,
                      const Settings& settings, std::uint64_t rays_per_scene = 100);

/// The table of an experiment on spawned rays.
std::vector<report::Table> spawned_tables(const Experiment& experiment,
                                          const std::vector<report::LabelledCensus>& counted);

/// At a uniformly random point of a patch, from the side that its normal side1 x side2 points
/// to, in a uniformly random direction.
Aim above_patch_aim();

/// A family as it is called in tables, and where its rays go.
struct Subject {
  std::string label;
  std::string family;
  Aim aim;
};

/// A series for each subject, with equal parts of the rays.
std::vector<Series> series_of(const std::vector<Subject>& subjects, const Settings& settings);

/// The methods with one absolute epsilon of this tolerance for all that there are.
std::vector<method::Method> with_epsilon(const std::vector<method::Method>& methods,
                                         const std::string& tolerance);

}  // namespace lamina::experiments
