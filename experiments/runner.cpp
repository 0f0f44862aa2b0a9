#include "experiments/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace lamina::experiments {
namespace {

std::size_t blocks_of(const Series& series) {
  return (series.tasks + census::kTasksPerBlock - 1) / census::kTasksPerBlock;
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
    const auto census = store.census(s);
    const std::uint64_t rays = census ? census->rays : 0;
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
      const std::size_t first = block * census::kTasksPerBlock;
      const std::size_t last = std::min(first + census::kTasksPerBlock, series[s].tasks);
      if (!store.has_block(s, block)) {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        const census::Census census =
            census::run_tasks(series[s].plan, first, last, series[s].task);
        store.add_block(s, block, census,
                        std::chrono::duration<double>(Clock::now() - start).count());
      }
      done += last - first;
      if (!progress(done, total)) {
        return;
      }
    }
  }
}

std::vector<report::Table> tables_of(const Experiment& experiment, const census::RunStore& store) {
  const std::vector<census::SeriesRecord> series = store.series();
  std::vector<report::LabelledCensus> counted;
  std::uint64_t blocks = 0;
  for (std::size_t s = 0; s < series.size(); ++s) {
    blocks += series[s].blocks;
    if (auto census = store.census(s)) {
      counted.push_back({series[s].labels, std::move(*census)});
    }
  }
  std::vector<report::Table> tables =
      experiment.tables != nullptr
          ? experiment.tables(experiment, counted)
          : std::vector<report::Table>{artifact_table(experiment, counted)};
  tables.push_back(
      report::paired_table(counted, experiment.labels, experiment.name + ": methods in pairs"));
  tables.push_back(clock_table(experiment, store, series));
  if (const std::uint64_t done = store.block_count(); done < blocks) {
    for (report::Table& table : tables) {
      table.notes.push_back(
          fmt::format("Not finished: {} of {} blocks of rays are counted.", done, blocks));
    }
  }
  return tables;
}

}  // namespace lamina::experiments
