// What every experiment is, and the list of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "census/census.hpp"
#include "report/census_table.hpp"
#include "report/table.hpp"

namespace lamina::experiments {

/// What the user asks for.
struct Settings {
  census::Plan plan;                  ///< methods and number types of the run
  scene::ReadOptions read;            ///< for experiments that read scene files
  std::uint64_t rays = 0;             ///< in all
  std::vector<poly::Solver> solvers;  ///< to be compared; empty: all
  std::uint64_t seed = 1;
  std::function<void(const std::string&)> warn;  ///< told what is left out of the run
};

/// Rays of one kind through scenes of one kind: their counts are added up. Or else polynomials of
/// one kind, which `record` counts.
struct Series {
  std::vector<census::Label> labels;  ///< one for each label column of the experiment
  census::Plan plan;
  std::size_t tasks = 0;
  census::TaskMaker task{};  ///< task 0 .. tasks-1; keeps what it needs by value
  /// What the experiment has to say of tasks first .. last-1, for its record_tables.
  std::function<std::string(std::size_t first, std::size_t last)> record{};
};

/// The records of a series, one for each block.
struct LabelledRecords {
  std::vector<census::Label> labels;
  std::vector<std::string> records;
};

struct Experiment {
  std::string name;                    ///< also its folder
  std::string question;                ///< one sentence
  std::string source;                  ///< paper and section
  std::vector<report::Column> labels;  ///< what sets series apart
  std::uint64_t default_rays = 0;
  std::string default_methods = "all";  ///< empty: it compares no methods
  std::string default_numbers = "all";
  bool compares_solvers = false;  ///< takes the user's solvers as the ones to be compared
  std::vector<Series> (*series)(const Settings&) = nullptr;
  /// The tables of what has been counted so far, in the order of the series. Null:
  /// artifact_table alone.
  std::vector<report::Table> (*tables)(const Experiment&,
                                       const std::vector<report::LabelledCensus>&) = nullptr;
  /// The same for an experiment whose series make records.
  std::vector<report::Table> (*record_tables)(const Experiment&,
                                              const std::vector<LabelledRecords>&) = nullptr;
};

/// The table that every experiment has.
report::Table artifact_table(const Experiment& experiment,
                             const std::vector<report::LabelledCensus>& counted);

const std::vector<Experiment>& all_experiments();

/// Throws base::InputError that lists the names.
const Experiment& find_experiment(const std::string& name);

}  // namespace lamina::experiments
