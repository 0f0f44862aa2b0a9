#include <fmt/format.h>

#include <algorithm>

#include "experiments/all_experiments.hpp"
#include "experiments/near-tangent/grazing.hpp"

namespace lamina::experiments {
namespace {

// From above, head-on: through a gap of 2e-6, which few bits do not see.
geometry::ExactRay head_on(const scene::FamilyMember& member, const scene::Scene&,
                           base::SeededStream& stream) {
  const double x = stream.uniform(-1, 1);
  const double y = stream.uniform(-1, 1);
  return scene::ray_from(member.place({x, y, 10}), member.place({x, y, 0}), scene::Held::Float);
}

std::vector<Series> series(const Settings& settings) {
  return series_of({{"gap of 2e-6", "gap:2e-6", {"gap", head_on}},
                    {"grazing 1e-9", "round:ball", grazing_aim("ball", 9, 10)},
                    {"uniform", "coincident-faces", uniform_aim()},
                    {"shared faces", "coincident-faces", coincident_aim()},
                    {"caps in one plane", "ghost-cylinders", coincident_aim()},
                    {"scaled lamina", "self-difference:sphere:scaled", {"lamina", head_on}}},
                   settings);
}

// First visible interface wrong: a row for each scene and method, a column for each precision.
report::Table bits_table(const std::vector<report::LabelledCensus>& counted) {
  report::Table table{"bits",
                      "precision: first visible interface wrong, by significand bits",
                      {{"scene", "scene", ""}, {"method", "method", ""}},
                      {},
                      {}};
  for (const auto& [labels, census, options] : counted) {
    for (std::size_t c = 0; c < census.cells.size(); ++c) {
      const census::Cell& cell = census.cells[c];
      if (c == 0 || cell.method != census.cells[c - 1].method) {
        table.rows.push_back({report::value_of(labels[0]), cell.method});
      }
      table.rows.back().emplace_back(report::Rate{cell[census::Artifact::FirstWrong], cell.rays});
      if (table.rows.size() == 1) {
        table.columns.push_back({cell.number, cell.number, ""});
      }
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  return {bits_table(counted), artifact_table(experiment, counted)};
}

}  // namespace

Experiment precision() {
  return {.name = "precision",
          .question = "Which artifacts does precision cure, and which does it never?",
          .source = "Wyvill and Trotman 1990, sections 1 and 2",
          .labels = {{"scene", "scene",
                      "gap of 2e-6 seen head-on; grazing 1e-9: rays that pass a sphere's surface "
                      "by 1e-9 to 1e-10; uniform and shared faces: coincident-faces, rays at the "
                      "box and at shared faces; caps in one plane: W&T Figure 4; scaled lamina: "
                      "a sphere less itself with its equation times 3."}},
          .default_rays = 15'000,
          .default_numbers = "bin11,bin24,bin53,bin64,bin113,bin237,exact",
          .series = series,
          .tables = tables};
}

}  // namespace lamina::experiments
