#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

using census::Artifact;

// From above, up to 60 degrees away from head-on.
geometry::ExactRay at_the_gap(const scene::FamilyMember& member, const scene::Scene&,
                              base::SeededStream& stream) {
  const double cosine = stream.uniform(0.5, 1);
  const double sine = std::sqrt(1 - cosine * cosine);
  const double phi = stream.uniform(0, 2 * M_PI);
  const double x = stream.uniform(-1, 1);
  const double y = stream.uniform(-1, 1);
  constexpr double kDistance = 10;
  const geometry::Vector3<double> origin{x + kDistance * sine * std::cos(phi),
                                         y + kDistance * sine * std::sin(phi), kDistance * cosine};
  return scene::ray_from(member.place(origin), member.place({x, y, 0}), scene::Held::Float);
}

// From above, near the point where the wall has no thickness.
geometry::ExactRay at_the_thin_wall(const scene::FamilyMember& member, const scene::Scene&,
                                    base::SeededStream& stream) {
  constexpr double kRadius = 0.02;
  const double x = stream.uniform(-kRadius, kRadius);
  const double y = stream.uniform(-kRadius, kRadius);
  return scene::ray_from(member.place({x, y, 10}), member.place({x, y, 2}), scene::Held::Float);
}

std::vector<Series> series(const Settings& settings) {
  Settings sweep = settings;
  if (std::any_of(sweep.plan.methods.begin(), sweep.plan.methods.end(), [](const auto& method) {
        return method.grouping != method::Grouping::WithinEpsilon;
      })) {
    settings.warn("epsilon-sweep runs epsilon:1e-16 to epsilon:1e-2, and no other method");
  }
  sweep.plan.methods.clear();
  for (int exponent = 16; exponent >= 2; --exponent) {
    sweep.plan.methods.push_back(method::parse_method(fmt::format("epsilon:1e-{}", exponent)));
  }
  return series_of({{"shared faces", "coincident-faces", coincident_aim()},
                    {"gap of 1e-5", "gap:1e-5", {"gap", at_the_gap}},
                    {"thin wall", "thin-wall", {"thin-wall", at_the_thin_wall}},
                    {"small", "far-origin:scaled:-4", coincident_aim()},
                    {"large", "far-origin:scaled:4", coincident_aim()}},
                   sweep);
}

report::Table sweep_table(const std::vector<report::LabelledCensus>& counted) {
  report::Table table{
      "sweep",
      "epsilon-sweep: what each epsilon gets wrong",
      {{"scene", "scene", ""},
       {"number", "number", ""},
       {"epsilon", "epsilon", ""},
       {"first_wrong", "first wrong", "The first visible interface is wrong."},
       {"hole", "eps-hole", "A hit is missed that this epsilon misses in exact arithmetic too."},
       {"missed", "missed", "A hit is missed although its roots were found."},
       {"ghost", "ghost", "An interface is reported where the truth has none."}},
      {},
      {}};
  // By number type and epsilon: scenes on which it gets nothing wrong.
  std::map<std::pair<std::string, std::string>, std::size_t> clean;
  for (const auto& [labels, census, options] : counted) {
    for (const census::Cell& cell : census.cells) {
      const std::string epsilon = cell.method.substr(cell.method.find(':') + 1);
      table.rows.push_back({report::value_of(labels[0]), cell.number, epsilon,
                            report::Rate{cell[Artifact::FirstWrong], cell.rays},
                            report::Rate{cell[Artifact::EpsilonHole], cell.rays},
                            report::Rate{cell[Artifact::MissedLogic], cell.rays},
                            report::Rate{cell[Artifact::GhostHit], cell.rays}});
      const bool all_right =
          cell[Artifact::FirstWrong] + cell[Artifact::MissedLogic] + cell[Artifact::GhostHit] == 0;
      clean[{cell.number, epsilon}] += all_right ? 1 : 0;
    }
  }
  std::map<std::string, std::pair<std::size_t, std::string>> best;  // by number type
  for (const auto& [key, scenes] : clean) {
    auto& [most, epsilon] = best[key.first];
    if (epsilon.empty() || scenes > most) {
      most = scenes;
      epsilon = key.second;
    }
  }
  for (const auto& [number, found] : best) {
    table.notes.push_back(fmt::format(
        "{}: at most {} of the {} scenes are free of wrong first interfaces, missed and ghost hits "
        "under one epsilon, as under {}.",
        number, found.first, counted.size(), found.second));
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  report::Table artifacts = artifact_table(experiment, counted);
  artifacts.on_request = true;
  return {sweep_table(counted), std::move(artifacts)};
}

}  // namespace

Experiment epsilon_sweep() {
  return {.name = "epsilon-sweep",
          .question = "Is there any epsilon that gets nothing wrong?",
          .source = "Wyvill and Trotman 1990, section 2; Amanatides and Mitchell 1990",
          .labels = {{"scene", "scene",
                      "shared faces: coincident-faces; gap of 1e-5 between two solids; thin wall: "
                      "W&T Figure 9; small and large: coincident-faces times 1e-4 and 1e4."}},
          .default_rays = 4'000,
          .default_methods = "epsilon",
          .default_numbers = "float,double,exact",
          .series = series,
          .tables = tables};
}

}  // namespace lamina::experiments
