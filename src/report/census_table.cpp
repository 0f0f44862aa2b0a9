#include "report/census_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "census/statistics.hpp"
#include "geometry/ray_text.hpp"

namespace lamina::report {

namespace {

std::vector<Column> columns(const std::vector<Column>& label_columns) {
  std::vector<Column> all = label_columns;
  all.insert(all.end(),
             {{"method", "method", ""},
              {"number", "number", ""},
              {"bits", "bits", "Significand bits of the number type."},
              {"rays", "rays", "Rays that were judged: those that lie in no carrier.", true},
              {"coincident", "coincident",
               "Of them, those that meet an exact class of two leaves or more.", true}});
  all.insert(all.end(),
             {{"not_spawned", "not spawned",
               "Paths that were wrong, or ended, before the ray that was to be judged."},
              {"undecided", "undecided",
               "Spawned rays whose truth is not certified at 1536 bits: surfaces of different "
               "equations meet there. They are not judged."}});
  for (const census::ArtifactText& text : census::artifact_texts()) {
    all.push_back(
        {std::string(text.name), std::string(text.heading), std::string(text.definition)});
  }
  for (const census::CauseText& text : census::cause_texts()) {
    all.push_back(
        {std::string(text.name), std::string(text.heading), std::string(text.definition)});
  }
  const std::vector<Column> rest{
      {"order_sensitive", "order",
       "The answer hangs on the order of the leaves, which decides ties of t; where more than four "
       "tie, some orders are tried."},
      {"most_outcomes", "outcomes", "The most different answers to one ray over orders of leaves.",
       true},
      {"lamina_front", "lamina front",
       "Laminae that all events enter, seen as a surface, of all such."},
      {"lamina_back", "lamina back",
       "Laminae that all events leave, seen as a surface, of all such."},
      {"speckle", "speckle",
       "4p(1-p) for the part p of such fronts that is seen: 0 is even, 1 noise."},
      {"wrong_length", "wrong length",
       "Total length of bounded intervals with a wrong medium, world units."},
      {"persistence", "persistence",
       "The longest run of exact intervals with a wrong medium on one ray."},
      {"t_ulps", "t ulps", "Largest error of t of a right first hit, in ulps of the number type."},
      {"point_rel", "point", "Largest relative error of its point.", true},
      {"normal_rad", "normal", "Largest angle between its normal and the exact one, radians.",
       true},
      {"worst_scene", "worst scene", "", true},
      {"worst_ray", "worst ray", "", true}};
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

double speckle(const census::Cell& cell) {
  if (cell.lamina_fronts == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double p =
      static_cast<double>(cell.lamina_fronts_seen) / static_cast<double>(cell.lamina_fronts);
  return 4 * p * (1 - p);
}

std::vector<Value> values_of(const std::vector<census::Label>& labels) {
  std::vector<Value> values;
  std::transform(labels.begin(), labels.end(), std::back_inserter(values), value_of);
  return values;
}

std::vector<Value> row_of(const LabelledCensus& labelled, const census::Cell& cell) {
  std::vector<Value> row = values_of(labelled.labels);
  row.emplace_back(cell.method);
  row.emplace_back(cell.number);
  row.push_back(cell.significand_bits == 0 ? Value(std::string("exact"))
                                           : Value(std::uint64_t(cell.significand_bits)));
  row.emplace_back(cell.rays);
  row.emplace_back(labelled.census.with_coincidence);
  const std::uint64_t paths = cell.rays + cell.not_spawned + cell.undecided;
  row.emplace_back(Rate{cell.not_spawned, paths});
  row.emplace_back(Rate{cell.undecided, paths});
  for (const std::uint64_t count : cell.with) {
    row.emplace_back(Rate{count, cell.rays});
  }
  for (const std::uint64_t count : cell.caused) {
    row.emplace_back(Rate{count, cell.rays});
  }
  row.emplace_back(Rate{cell.order_sensitive, cell.rays});
  row.emplace_back(std::uint64_t(cell.most_outcomes));
  row.emplace_back(Rate{cell.lamina_fronts_seen, cell.lamina_fronts});
  row.emplace_back(Rate{cell.lamina_backs_seen, cell.lamina_backs});
  row.emplace_back(speckle(cell));
  row.emplace_back(cell.wrong_length);
  row.emplace_back(std::uint64_t(cell.persistence));
  row.emplace_back(cell.largest.t_ulps);
  row.emplace_back(cell.largest.point_rel);
  row.emplace_back(cell.largest.normal_rad);
  row.emplace_back(cell.worst ? cell.worst->scene : std::string());
  row.emplace_back(cell.worst ? geometry::to_text(cell.worst->ray) : std::string());
  return row;
}

double first_wrong_rate(const census::Cell& cell) {
  return static_cast<double>(cell[census::Artifact::FirstWrong]) /
         static_cast<double>(std::max<std::uint64_t>(1, cell.rays));
}

struct Replay {
  const census::Cell* cell;
  const std::string* options;
};

// For each method, in the order of the censuses, the cell with the most wrong first hits.
std::vector<Replay> cells_to_replay(const std::vector<LabelledCensus>& censuses) {
  std::vector<Replay> chosen;
  for (const LabelledCensus& labelled : censuses) {
    for (const census::Cell& cell : labelled.census.cells) {
      if (!cell.worst) {
        continue;
      }
      const auto known = std::find_if(chosen.begin(), chosen.end(), [&cell](const Replay& other) {
        return other.cell->method == cell.method;
      });
      if (known == chosen.end()) {
        chosen.push_back({&cell, &labelled.options});
      } else if (first_wrong_rate(cell) > first_wrong_rate(*known->cell)) {
        *known = {&cell, &labelled.options};
      }
    }
  }
  return chosen;
}

// Columns that say nothing of primary rays, and those that say nothing of spawned ones.
constexpr std::array<std::string_view, 3> kOfSpawnedRays{"not_spawned", "undecided",
                                                         "self_intersection"};
constexpr std::array<std::string_view, 20> kOfPrimaryRays{
    "epsilon_hole",    "inconsistent",  "wrong_count", "wrong_parity", "model",
    "representation",  "construction",  "computation", "lamina_front", "lamina_back",
    "order_sensitive", "most_outcomes", "speckle",     "wrong_length", "persistence",
    "t_ulps",          "point_rel",     "normal_rad",  "worst_scene",  "worst_ray"};

template <std::size_t Count>
void drop(Table& table, const std::array<std::string_view, Count>& names) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (std::find(names.begin(), names.end(), table.columns[c].name) == names.end()) {
      continue;
    }
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (auto& row : table.rows) {
      row.erase(row.begin() + at);
    }
  }
}

Table table_of(const std::vector<LabelledCensus>& censuses,
               const std::vector<Column>& label_columns, const std::string& title) {
  Table table{"artifacts", title, columns(label_columns), {}, {}};
  for (const LabelledCensus& labelled : censuses) {
    for (const census::Cell& cell : labelled.census.cells) {
      table.rows.push_back(row_of(labelled, cell));
    }
  }
  return table;
}

}  // namespace

Value value_of(const census::Label& label) {
  return std::visit([](const auto& value) -> Value { return value; }, label);
}

Table census_table(const std::vector<LabelledCensus>& censuses,
                   const std::vector<Column>& label_columns, const std::string& title) {
  Table table = table_of(censuses, label_columns, title);
  drop(table, kOfSpawnedRays);
  std::uint64_t rays = 0;
  std::uint64_t in_carrier = 0;
  std::uint64_t coincident = 0;
  for (const LabelledCensus& labelled : censuses) {
    rays += labelled.census.rays;
    in_carrier += labelled.census.in_carrier;
    coincident += labelled.census.with_coincidence;
  }
  table.notes.push_back(
      fmt::format("{} rays in all, the same for all rows with the same labels; {} of them lie in a "
                  "carrier, are "
                  "counted apart and not judged; {} of the others meet coincident surfaces.",
                  rays, in_carrier, coincident));
  for (const auto& [cell, options] : cells_to_replay(censuses)) {
    table.notes.push_back(
        fmt::format("To replay: `lamina explain '{}' --ray \"{}\" --methods {} --numbers {}{}`",
                    cell->worst->scene, geometry::to_text(cell->worst->ray), cell->method,
                    cell->number, *options));
  }
  return table;
}

Table spawned_table(const std::vector<LabelledCensus>& censuses,
                    const std::vector<Column>& label_columns, const std::string& title) {
  Table table = table_of(censuses, label_columns, title);
  drop(table, kOfPrimaryRays);
  table.notes.emplace_back(
      "The rays that are counted are spawned ones. Truth is conditional: each starts at the exact "
      "hit of its exact incident ray, in the direction that the number type holds. Media are those "
      "at its start.");
  return table;
}

Table paired_table(const std::vector<LabelledCensus>& censuses,
                   const std::vector<Column>& label_columns, const std::string& title) {
  Table table{"paired", title, label_columns, {}, {}};
  table.on_request = true;
  table.columns.insert(
      table.columns.end(),
      {{"number", "number", ""},
       {"first", "first", ""},
       {"second", "second", ""},
       {"only_first_wrong", "only first wrong",
        "Rays on which the first visible interface is wrong with the first method only."},
       {"only_second_wrong", "only second wrong", "The same with the second method only."},
       {"p", "p",
        "McNemar's test, exact and two-sided: how likely so uneven a split is between equally good "
        "methods."}});
  for (const LabelledCensus& labelled : censuses) {
    for (const census::Pair& pair : labelled.census.pairs) {
      std::vector<Value> row = values_of(labelled.labels);
      row.insert(row.end(), {pair.number, pair.first, pair.second, pair.only_first_wrong,
                             pair.only_second_wrong,
                             census::mcnemar(pair.only_first_wrong, pair.only_second_wrong)});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace lamina::report
