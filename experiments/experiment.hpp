// What every experiment is, and the list of them.
#pragma once

#include <string>
#include <vector>

#include "census/census.hpp"
#include "report/table.hpp"

namespace lamina::experiments {

/// What the user asks for.
struct Settings {
  census::Plan plan;        ///< methods and number types of the run
  scene::ReadOptions read;  ///< for experiments that read scene files
  std::uint64_t rays = 0;   ///< in all
  std::uint64_t seed = 1;
  census::Progress progress;  ///< tasks done and in all; false stops
};

struct Result {
  std::vector<report::Table> tables;
  bool interrupted = false;
};

struct Experiment {
  std::string name;      ///< also its folder
  std::string question;  ///< one sentence
  std::string source;    ///< paper and section
  std::uint64_t default_rays = 0;
  std::vector<std::string> default_numbers;  ///< empty: all number types
  Result (*run)(const Settings&) = nullptr;
};

const std::vector<Experiment>& all_experiments();

/// Throws base::InputError that lists the names.
const Experiment& find_experiment(const std::string& name);

}  // namespace lamina::experiments
