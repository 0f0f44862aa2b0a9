#include <fmt/format.h>

#include <algorithm>

#include "base/contract.hpp"
#include "experiments/coincident-faces/coincident_faces.hpp"
#include "experiments/experiment.hpp"
#include "experiments/ghost-cylinders/ghost_cylinders.hpp"
#include "experiments/real-models/real_models.hpp"

namespace lamina::experiments {

const std::vector<Experiment>& all_experiments() {
  static const std::vector<Experiment> all{coincident_faces(), ghost_cylinders(), real_models()};
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
