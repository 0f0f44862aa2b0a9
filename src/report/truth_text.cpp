#include "report/truth_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report/page.hpp"
#include "surface/carrier.hpp"

namespace lamina::report {
namespace {

using census::Truth;
using census::TruthClass;
using fmt::format;

std::string names(const std::vector<csg::LeafIndex>& leaves, const Legend& legend) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(leaves.size(), kMost); ++i) {
    text += (i == 0 ? "" : ", ") + legend.name(leaves[i]);
  }
  return leaves.size() <= kMost ? text : text + format(" and {} more", leaves.size() - kMost);
}

// What a class does, in words.
std::string effect(const scene::Scene& scene, const TruthClass& cls, const Legend& legend) {
  const csg::CoincidentClass& does = cls.effect;
  if (cls.is_interface()) {
    return format("interface {} -> {}, owned by {}", medium_name(scene, does.transition.from),
                  medium_name(scene, does.transition.to), names(does.owners, legend));
  }
  if (does.lamina) {
    return "lamina of no thickness: nothing changes";
  }
  return cls.leaves.size() > 1 ? "nothing changes" : "";
}

std::string event_text(const Truth& truth, std::size_t crossing, const Legend& legend) {
  const auto& event = truth.crossings()[crossing];
  return format("{} {}", legend.name(event.leaf), event.enters_by_parity ? "enters" : "leaves");
}

bool shown(const TruthClass& cls, const Legend& legend) {
  return cls.is_interface() ||
         std::any_of(cls.leaves.begin(), cls.leaves.end(),
                     [&legend](csg::LeafIndex leaf) { return legend.shows(leaf); });
}

void add_class(const scene::Scene& scene, const Truth& truth, const TruthClass& cls,
               bool same_double, const Legend& legend, Columns& columns) {
  std::vector<std::size_t> events;
  for (std::size_t i = 0; i < cls.leaves.size(); ++i) {
    if (legend.shows(cls.leaves[i])) {
      events.push_back(cls.first_crossing + i);
    }
  }
  if (events.empty()) {
    events.push_back(cls.first_crossing);
  }
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool last = i + 1 == events.size();
    std::string remark = last ? effect(scene, cls, legend) : "";
    if (last && events.size() < cls.leaves.size()) {
      remark += format(" (with {})", counted(cls.leaves.size() - events.size(), "more event"));
    }
    if (last && same_double) {
      remark +=
          format("{}behind the event above, by less than double tells", remark.empty() ? "" : "; ");
    }
    columns.add({i == 0 ? shortest_text(nearest_double(truth.t(cls)), 0) : "",
                 bracket(i, events.size()), event_text(truth, events[i], legend),
                 last ? medium_name(scene, cls.effect.transition.to) : "", remark});
  }
}

std::string events_text(const scene::Scene& scene, const Truth& truth, const Legend& legend) {
  Columns columns;
  columns.add({"t", "", "event", "medium", ""});
  columns.add({"start", "", "", medium_name(scene, truth.start()), ""});
  std::size_t skipped = 0;
  const auto note_skipped = [&] {
    if (skipped > 0) {
      columns.add({"..", "", "", "", format("{}: nothing changes", counted(skipped, "event"))});
    }
    skipped = 0;
  };
  const TruthClass* previous = nullptr;
  for (const TruthClass& cls : truth.classes()) {
    if (!shown(cls, legend)) {
      skipped += cls.leaves.size();
    } else {
      note_skipped();
      const bool same_double =
          previous != nullptr && nearest_double(truth.t(*previous)) == nearest_double(truth.t(cls));
      add_class(scene, truth, cls, same_double, legend, columns);
    }
    previous = &cls;
  }
  note_skipped();
  return columns.text(2);
}

// Touches, and carriers that the ray lies in: neither is an event.
std::string remarks(const scene::Scene& scene, const geometry::ExactRay& ray,
                    const Legend& legend) {
  surface::RayMonomials monomials(ray);
  std::string text;
  for (std::size_t c = 0; c < scene.carriers.size(); ++c) {
    const surface::CarrierOnRay carrier(scene.carriers[c], ray, monomials);
    const std::vector<csg::LeafIndex>& leaves = scene.leaves_of_carrier[c];
    if (carrier.contains_ray()) {
      text +=
          paragraph(format("The ray lies in the surface of {}: by convention it is outside of it "
                           "all along. The census counts such rays apart and does not judge them.",
                           names(leaves, legend)),
                    "", 2);
      continue;
    }
    for (const number::Root& root : carrier.touches()) {
      if (compare(root, number::Rational(0)) > 0) {
        text += paragraph(format("The ray touches {} at t = {} and does not cross it there.",
                                 names(leaves, legend), shortest_text(nearest_double(root), 0)),
                          "", 2);
      }
    }
  }
  return text;
}

}  // namespace

std::string bracket(std::size_t row, std::size_t count) {
  if (count < 2) {
    return "";
  }
  return row == 0 ? "/" : row + 1 == count ? "\\" : "|";
}

std::string truth_text(const scene::Scene& scene, const geometry::ExactRay& ray, const Truth& truth,
                       const Legend& legend) {
  std::string text =
      "The truth, t as the nearest double; brackets join events at exactly the same t\n";
  text += events_text(scene, truth, legend);
  text += remarks(scene, ray, legend);
  const auto crossings = truth.crossings();
  const std::size_t behind =
      truth.classes().empty() ? crossings.size() : truth.classes().front().first_crossing;
  if (behind > 0) {
    text += format("  Behind the start, at t <= 0: {}.\n", counted(behind, "event"));
  }
  return text;
}

}  // namespace lamina::report
