// What is wrong with a picture: its map, with the legend and the counts.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "census/artifact_map.hpp"
#include "report/table.hpp"
#include "trace/image.hpp"

namespace lamina::report {

/// Each pixel's first fault. Different pixels can be set by different threads.
class ArtifactMap {
 public:
  explicit ArtifactMap(const trace::ImageSize& size);

  /// The pixel is done, with its tree's first fault or none.
  void set(int x, int y, std::optional<census::Fault> first);

  /// A picture of faults in their colours, and of what is right in grey, with the given picture
  /// faintly in it; pixels that are not done are black. Below it is a square for each fault in
  /// the order of the table.
  [[nodiscard]] trace::Image over(const trace::Image& picture) const;

  /// Pixels that are done, by their fault; the last are those without any.
  [[nodiscard]] std::array<std::uint64_t, census::kFaultCount + 1> pixels() const;

 private:
  int width_;
  std::vector<std::uint8_t> states_;  // by pixel: its fault, or right, or not done
};

/// A row for each fault: its colour, its pixels, and its rays by their kind.
///
/// Arguments: counts  of all pixels that are done
Table fault_table(const ArtifactMap& map, const census::FaultCounts& counts);

}  // namespace lamina::report
