// Runs an experiment into a run store, and makes its tables from there.
#pragma once

#include "census/run_store.hpp"
#include "experiments/experiment.hpp"

namespace lamina::experiments {

/// The setting of a store that has what `lamina explain` needs besides to replay a ray.
inline constexpr const char* kOptionsSetting = "options";

/// Counts the blocks that the store does not have. `progress` is told the tasks that are done
/// and those in all, and stops the run between two blocks by returning false.
void run_into(census::RunStore& store, const std::vector<Series>& series,
              const census::Progress& progress);

/// Tables of what the store has: the experiment's own, then on request `paired`, two methods
/// on the same rays, `clock`, how long it took, and `environment`. A run that is not finished says
/// so.
std::vector<report::Table> tables_of(const Experiment& experiment, const census::RunStore& store);

}  // namespace lamina::experiments
