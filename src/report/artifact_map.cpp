#include "report/artifact_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace lamina::report {
namespace {

constexpr std::uint8_t kRight = census::kFaultCount;
constexpr std::uint8_t kNotDone = kRight + 1;

trace::Color of_right_pixel(const std::array<std::uint8_t, 3>& seen) {
  const double grey = 0.08 + 0.35 * (0.3 * seen[0] + 0.6 * seen[1] + 0.1 * seen[2]) / 255;
  return {grey, grey, grey};
}

}  // namespace

ArtifactMap::ArtifactMap(const trace::ImageSize& size)
    : width_(size.width), states_(static_cast<std::size_t>(size.width) * size.height, kNotDone) {}

void ArtifactMap::set(int x, int y, std::optional<census::Fault> first) {
  states_[static_cast<std::size_t>(y) * width_ + x] =
      first ? static_cast<std::uint8_t>(*first) : kRight;
}

trace::Image ArtifactMap::over(const trace::Image& picture) const {
  constexpr int kSquare = 14;
  constexpr int kGap = 2;
  const trace::ImageSize& size = picture.size();
  trace::Image map({size.width, size.height + kSquare});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::uint8_t state = states_[static_cast<std::size_t>(y) * width_ + x];
      if (state != kNotDone) {
        map.set(x, y,
                state == kRight ? of_right_pixel(picture.at(x, y))
                                : census::fault_texts()[state].color);
      }
    }
  }
  const int squares = std::min(static_cast<int>(census::kFaultCount), size.width / kSquare);
  for (int y = kGap; y < kSquare; ++y) {
    for (int x = 0; x < squares * kSquare; ++x) {
      if (x % kSquare >= kGap) {
        map.set(x, size.height + y, census::fault_texts()[x / kSquare].color);
      }
    }
  }
  return map;
}

std::array<std::uint64_t, census::kFaultCount + 1> ArtifactMap::pixels() const {
  std::array<std::uint64_t, census::kFaultCount + 1> pixels{};
  for (const std::uint8_t state : states_) {
    if (state != kNotDone) {
      ++pixels[state];
    }
  }
  return pixels;
}

Table fault_table(const ArtifactMap& map, const census::FaultCounts& counts) {
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
  const auto pixels = map.pixels();
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
