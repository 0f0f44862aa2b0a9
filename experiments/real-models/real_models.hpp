#pragma once

#include "experiments/experiment.hpp"

namespace lamina::experiments {

/// See README.md in this folder.
Experiment real_models();

}  // namespace lamina::experiments
