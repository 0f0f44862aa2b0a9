#pragma once

#include "experiments/experiment.hpp"

namespace lamina::experiments {

/// See README.md in this folder.
Experiment ghost_cylinders();

}  // namespace lamina::experiments
