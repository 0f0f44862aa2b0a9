#include "experiments/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace lamina::experiments {
namespace {

std::size_t blocks_of(const Series& series) {
  return (series.tasks + census::kTasksPerBlock - 1) / census::kTasksPerBlock;
}

std::size_t tasks_in(const Series& series, std::size_t block) {
  return std::min(census::kTasksPerBlock, series.tasks - block * census::kTasksPerBlock);
}

// Settings and, for each session of the run, what it was made with.
report::Table environment_table(const Experiment& experiment, const census::RunStore& store) {
  report::Table table{"environment",
                      experiment.name + ": settings and environment",
                      {{"session", "session", "A run that was gone on with has several."},
                       {"name", "name", ""},
                       {"value", "value", ""}},
                      {},
                      {}};
  table.on_request = true;
  for (const auto& [name, value] : store.settings()) {
    table.rows.push_back({std::string("all"), name, value});
  }
  const std::vector<census::Record> sessions = store.environments();
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    for (const auto& [name, value] : sessions[i]) {
      table.rows.push_back({fmt::format("{}", i + 1), name, value});
    }
  }
  return table;
}

report::Table clock_table(const Experiment& experiment, const census::RunStore& store,
                          const std::vector<census::SeriesRecord>& series) {
  report::Table table{"clock", experiment.name + ": time", experiment.labels, {}, {}};
  table.on_request = true;
  table.columns.insert(table.columns.end(),
                       {{"rays", "rays", ""},
                        {"seconds", "seconds", "By the clock, of all methods and number types."},
                        {"rays_per_second", "rays/s", ""}});
  for (std::size_t s = 0; s < series.size(); ++s) {
    const std::uint64_t rays = store.ray_count(s);
    const double seconds = store.seconds(s);
    std::vector<report::Value> row;
    for (const census::Label& label : series[s].labels) {
      row.push_back(report::value_of(label));
    }
    row.insert(row.end(), {rays, seconds, static_cast<double>(rays) / seconds});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

void run_into(census::RunStore& store, const std::vector<Series>& series,
              const census::Progress& progress) {
  std::vector<census::SeriesRecord> records;
  std::uint64_t total = 0;
  for (const Series& s : series) {
    records.push_back({s.labels, blocks_of(s)});
    total += s.tasks;
  }
  store.set_series(records);
  std::uint64_t done = 0;
  for (std::size_t s = 0; s < series.size(); ++s) {
    for (std::size_t block = 0; block < records[s].blocks; ++block) {
      done += store.has_block(s, block) ? tasks_in(series[s], block) : 0;
    }
  }
  if (!progress(done, total)) {
    return;
  }
  for (std::size_t s = 0; s < series.size(); ++s) {
    for (std::size_t block = 0; block < records[s].blocks; ++block) {
      if (store.has_block(s, block)) {
        continue;
      }
      using Clock = std::chrono::steady_clock;
      const auto start = Clock::now();
      const auto seconds = [start] {
        return std::chrono::duration<double>(Clock::now() - start).count();
      };
      const std::size_t first = block * census::kTasksPerBlock;
      const std::size_t last = first + tasks_in(series[s], block);
      if (series[s].record) {
        const std::string record = series[s].record(first, last);
        store.add_record(s, block, last - first, record, seconds());
      } else {
        const census::Census census = run_tasks(series[s].plan, first, last, series[s].task);
        store.add_block(s, block, census, seconds());
      }
      done += tasks_in(series[s], block);
      if (!progress(done, total)) {
        return;
      }
    }
  }
}

std::vector<report::Table> tables_of(const Experiment& experiment, const census::RunStore& store) {
  const std::vector<census::SeriesRecord> series = store.series();
  std::vector<report::LabelledCensus> counted;
  std::vector<LabelledRecords> records;
  std::string options;
  for (const auto& [name, value] : store.settings()) {
    options = name == kOptionsSetting ? value : options;
  }
  std::uint64_t blocks = 0;
  for (std::size_t s = 0; s < series.size(); ++s) {
    blocks += series[s].blocks;
    if (experiment.record_tables != nullptr) {
      records.push_back({series[s].labels, store.records(s)});
    } else if (auto census = store.census(s)) {
      counted.push_back({series[s].labels, std::move(*census), options});
    }
  }
  std::vector<report::Table> tables;
  if (experiment.record_tables != nullptr) {
    tables = experiment.record_tables(experiment, records);
  } else {
    tables = experiment.tables != nullptr
                 ? experiment.tables(experiment, counted)
                 : std::vector<report::Table>{artifact_table(experiment, counted)};
    tables.push_back(
        report::paired_table(counted, experiment.labels, experiment.name + ": methods in pairs"));
  }
  tables.push_back(clock_table(experiment, store, series));
  tables.push_back(environment_table(experiment, store));
  if (const std::uint64_t done = store.block_count(); done < blocks || blocks == 0) {
    for (report::Table& table : tables) {
      table.notes.push_back(
          fmt::format("Not finished: {} of {} blocks of rays are counted.", done, blocks));
    }
  }
  return tables;
}

}  // namespace lamina::experiments
