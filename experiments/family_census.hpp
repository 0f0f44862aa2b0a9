// The census over a family of scenes: the part that family experiments share.
#pragma once

#include <functional>
#include <string>

#include "experiments/experiment.hpp"
#include "scene/families.hpp"

namespace lamina::experiments {

/// Where a family's rays go. The two are never pooled.
enum class Aim {
  Uniform,     ///< at a uniformly random point of the scene's bounding box
  Coincident,  ///< at a uniformly random point of a patch where leaves coincide
};

std::string aim_name(Aim aim);

/// The column of census tables that says where rays went.
report::Column aim_column();

struct Family {
  std::string name;
  scene::FamilyMember (*member)(std::uint64_t seed, std::uint64_t case_id);
};

/// Judges `rays` rays, a few for each member of the family, members 0, 1, ... of the seed.
census::Census family_census(const Family& family, Aim aim, std::uint64_t rays,
                             const Settings& settings);

}  // namespace lamina::experiments
