// The legend and the counts of an artifact map.
#pragma once

#include <array>

#include "census/artifact_map.hpp"
#include "report/table.hpp"

namespace lamina::report {

/// Pixels of a picture by the first fault of their trees; the last are those without any.
using FaultPixels = std::array<std::uint64_t, census::kFaultCount + 1>;

/// A row for each fault: its colour, its pixels, and its rays by their kind.
///
/// Arguments: counts  of all pixels
Table fault_table(const FaultPixels& pixels, const census::FaultCounts& counts);

}  // namespace lamina::report
