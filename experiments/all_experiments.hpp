// One function for each experiment: see README.md in the folder of its name.
#pragma once

#include "experiments/experiment.hpp"

namespace lamina::experiments {

Experiment bubble();
Experiment coincident_faces();
Experiment coincident_glass();
Experiment coincident_reflection();
Experiment epsilon_gap();
Experiment epsilon_sweep();
Experiment far_origin();
Experiment four_cases();
Experiment gap_ulps();
Experiment ghost_cylinders();
Experiment grazing_spawn();
Experiment media();
Experiment near_tangent();
Experiment order();
Experiment precision();
Experiment printed_formulas();
Experiment ray_tree_depth();
Experiment real_models();
Experiment root_faults();
Experiment same_medium();
Experiment self_difference();
Experiment self_intersection();
Experiment self_sum();
Experiment solver_accuracy();
Experiment solver_effect();
Experiment start_state();
Experiment sweep_accuracy();
Experiment sweep_coincidence();
Experiment sweep_race();
Experiment thin_wall();
Experiment touching_stack();

}  // namespace lamina::experiments
