#pragma once

#include "experiments/experiment.hpp"

namespace lamina::experiments {

/// See README.md in this folder.
Experiment coincident_faces();

}  // namespace lamina::experiments
