// Rays that rays spawn, against the truth conditional on where they start.
#pragma once

#include "census/census.hpp"

namespace lamina::census {

/// Judges the last ray of each path of one task. Number types without spawned rays get no
/// counts. An incident ray must hit where it hits in truth (spawns_at_truth), and the ray must be
/// spawned at all (RayPath::spawn). Else its path is counted as not spawned.
Census run_spawned(const Plan& plan, const Task& task);

}  // namespace lamina::census
