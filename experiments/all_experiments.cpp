#include "experiments/all_experiments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.hpp"

namespace lamina::experiments {

report::Table artifact_table(const Experiment& experiment,
                             const std::vector<report::LabelledCensus>& counted) {
  return report::census_table(counted, experiment.labels, experiment.name);
}

const std::vector<Experiment>& all_experiments() {
  static const std::vector<Experiment> all{coincident_faces(),
                                           ghost_cylinders(),
                                           self_sum(),
                                           self_difference(),
                                           touching_stack(),
                                           thin_wall(),
                                           epsilon_gap(),
                                           epsilon_sweep(),
                                           precision(),
                                           far_origin(),
                                           start_state(),
                                           near_tangent(),
                                           order(),
                                           four_cases(),
                                           coincident_reflection(),
                                           coincident_glass(),
                                           self_intersection(),
                                           grazing_spawn(),
                                           bubble(),
                                           media(),
                                           ray_tree_depth(),
                                           same_medium(),
                                           root_faults(),
                                           sweep_coincidence(),
                                           sweep_race(),
                                           gap_ulps(),
                                           real_models(),
                                           solver_accuracy(),
                                           solver_effect(),
                                           sweep_accuracy(),
                                           printed_formulas()};
  return all;
}

const Experiment& find_experiment(const std::string& name) {
  const auto& all = all_experiments();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; });
  if (found == all.end()) {
    std::string names;
    for (const Experiment& experiment : all) {
      names += fmt::format("\n  {:<18} {}", experiment.name, experiment.question);
    }
    throw base::InputError(fmt::format("no experiment '{}'; there are:{}", name, names));
  }
  return *found;
}

}  // namespace lamina::experiments
