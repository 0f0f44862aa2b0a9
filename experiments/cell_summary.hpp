// Experiments whose records fill a cell for each number type and way of doing something.
#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.hpp"

namespace lamina::experiments {

/// The cells of a series, by number type and way in the order of the run.
template <typename Cell>
struct Summary {
  std::vector<census::Label> labels;
  std::vector<std::pair<std::pair<std::string, std::string>, Cell>> cells;
};

/// Adds up the cells of each series, of which every record has a JSON array: `number`, what stands
/// under `way`, and what from_json() reads into a cell.
template <typename Cell>
std::vector<Summary<Cell>> summaries_of(const std::vector<LabelledRecords>& all, const char* way) {
  std::vector<Summary<Cell>> summaries;
  for (const LabelledRecords& of_series : all) {
    Summary<Cell>& summary = summaries.emplace_back(Summary<Cell>{of_series.labels, {}});
    std::map<std::pair<std::string, std::string>, std::size_t> places;
    for (const std::string& record : of_series.records) {
      for (const auto& json : nlohmann::json::parse(record)) {
        Cell cell;
        from_json(json, cell);
        const std::pair key{json.at("number").get<std::string>(), json.at(way).get<std::string>()};
        const auto [place, is_new] = places.try_emplace(key, summary.cells.size());
        if (is_new) {
          summary.cells.emplace_back(key, Cell());
        }
        summary.cells[place->second].second.merge(cell);
      }
    }
  }
  return summaries;
}

/// The experiment's labels, the number type, the way, and `more`.
inline std::vector<report::Column> cell_columns(const Experiment& experiment,
                                                const report::Column& way,
                                                const std::vector<report::Column>& more) {
  std::vector<report::Column> columns = experiment.labels;
  columns.insert(columns.end(), {{"number", "number", ""}, way});
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

/// What a row has in the columns before `more`.
template <typename Cell>
std::vector<report::Value> row_of(const Summary<Cell>& summary, std::size_t cell) {
  std::vector<report::Value> row;
  for (const census::Label& label : summary.labels) {
    row.push_back(report::value_of(label));
  }
  row.emplace_back(summary.cells[cell].first.first);
  row.emplace_back(summary.cells[cell].first.second);
  return row;
}

/// Adds a row for each cell that has a time, in seconds: in nanoseconds, and relative to the least
/// of its number type in the series.
template <typename Cell, typename SecondsOf>
void add_times(report::Table& table, const std::vector<Summary<Cell>>& summaries,
               const SecondsOf& seconds_of) {
  for (const Summary<Cell>& summary : summaries) {
    std::map<std::string, double> fastest;
    for (const auto& [key, cell] : summary.cells) {
      if (const std::optional<double> seconds = seconds_of(cell)) {
        const auto [place, is_new] = fastest.try_emplace(key.first, *seconds);
        place->second = std::min(place->second, *seconds);
      }
    }
    for (std::size_t i = 0; i < summary.cells.size(); ++i) {
      const auto& [key, cell] = summary.cells[i];
      if (const std::optional<double> seconds = seconds_of(cell)) {
        std::vector<report::Value> row = row_of(summary, i);
        row.insert(row.end(), {1e9 * *seconds, *seconds / fastest[key.first]});
        table.rows.push_back(std::move(row));
      }
    }
  }
}

}  // namespace lamina::experiments
