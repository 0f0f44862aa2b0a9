#include "report/fault_table.hpp"

#include <fmt/format.h>

#include <numeric>

namespace lamina::report {

Table fault_table(const FaultPixels& pixels, const census::FaultCounts& counts) {
  constexpr std::array<const char*, census::kRayKindCount> kKinds{"primary", "reflected",
                                                                  "transmitted", "shadow"};
  Table table;
  table.name = "artifact-map";
  table.title = "artifact map";
  table.columns = {
      {"fault", "fault", "What is wrong with a ray up to its first interface."},
      {"color", "colour", "Of the pixels: of the first fault of a pixel's tree, depth first."},
      {"pixels", "pixels %", "Pixels of that colour."}};
  for (const char* kind : kKinds) {
    table.columns.push_back({fmt::format("{}_rays", kind), fmt::format("{} rays %", kind),
                             fmt::format("Of the {} rays that were judged.", kind)});
  }
  const std::uint64_t all = std::accumulate(pixels.begin(), pixels.end(), std::uint64_t{0});
  for (std::size_t f = 0; f < census::kFaultCount; ++f) {
    const census::FaultText& text = census::fault_texts()[f];
    std::vector<Value> row{std::string(text.name), std::string(text.color_name),
                           Rate{pixels[f], all}};
    for (std::size_t kind = 0; kind < census::kRayKindCount; ++kind) {
      row.emplace_back(Rate{counts.with[kind][f], counts.rays[kind] - counts.unjudged[kind]});
    }
    table.rows.push_back(std::move(row));
    table.notes.push_back(fmt::format("{}: {}.", text.name, text.definition));
  }
  table.notes.push_back(
      fmt::format("Pixels without a fault, grey: {} of {}.", pixels[census::kFaultCount], all));
  std::string rays = "Rays that were judged, of all:";
  for (std::size_t kind = 0; kind < census::kRayKindCount; ++kind) {
    rays += fmt::format("{} {} of {} {}", kind == 0 ? "" : ",",
                        counts.rays[kind] - counts.unjudged[kind], counts.rays[kind], kKinds[kind]);
  }
  table.notes.push_back(
      rays +
      "; the others come after a ray with a fault, where the truth has none to compare with.");
  return table;
}

}  // namespace lamina::report
