#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  std::vector<Subject> subjects;
  for (const char* family : {"coincident-faces", "ghost-cylinders"}) {
    subjects.push_back({family, family, coincident_aim()});
  }
  for (const char* family : {"self-sum:sphere:same", "self-sum:box:same", "touching-stack:10"}) {
    subjects.push_back({family, family, uniform_aim()});
  }
  return series_of(subjects, settings);
}

report::Table outcome_table(const std::vector<report::LabelledCensus>& counted) {
  report::Table table{"orders",
                      "order: answers that hang on the order of the leaves",
                      {{"scene", "scene", ""},
                       {"method", "method", ""},
                       {"number", "number", ""},
                       {"order_sensitive", "order-sensitive",
                        "Rays that are answered differently if the leaves stand in another order."},
                       {"most_outcomes", "outcomes", "Different answers to one ray, at most."}},
                      {},
                      {}};
  for (const auto& [labels, census, options] : counted) {
    for (const census::Cell& cell : census.cells) {
      table.rows.push_back({report::value_of(labels[0]), cell.method, cell.number,
                            report::Rate{cell.order_sensitive, cell.rays},
                            std::uint64_t(cell.most_outcomes)});
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  report::Table artifacts = artifact_table(experiment, counted);
  artifacts.on_request = true;
  return {outcome_table(counted), std::move(artifacts)};
}

}  // namespace

Experiment order() {
  return {.name = "order",
          .question = "How much of what a method sees hangs on the order of the leaves?",
          .source = "Wyvill and Trotman 1990, section 3.4: events at one point, ties by leaf",
          .labels = {{"scene", "scene", "Family; rays at coincident faces, or at the box."}},
          .default_rays = 20'000,
          .default_methods =
              "roth,wyvill-sharp,epsilon,regularized,wyvill-trotman,"
              "wyvill-trotman:no-look-ahead",
          .default_numbers = "float,double,exact",
          .series = series,
          .tables = tables};
}

}  // namespace lamina::experiments
