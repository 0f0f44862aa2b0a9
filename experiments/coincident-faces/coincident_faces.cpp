#include "experiments/coincident-faces/coincident_faces.hpp"

#include "experiments/family_census.hpp"
#include "report/census_table.hpp"

namespace lamina::experiments {
namespace {

Result run(const Settings& settings) {
  const Family family{"coincident-faces", scene::coincident_faces};
  std::vector<report::LabelledCensus> censuses;
  bool interrupted = false;
  for (const Aim aim : {Aim::Coincident, Aim::Uniform}) {
    if (!interrupted) {
      censuses.push_back({aim_name(aim), family_census(family, aim, settings.rays / 2, settings)});
      interrupted = censuses.back().census.interrupted;
    }
  }
  return {{report::census_table(censuses, aim_column(), "coincident-faces")}, interrupted};
}

}  // namespace

Experiment coincident_faces() {
  return {"coincident-faces",
          "What does each method see where two or three solids share faces?",
          "Wyvill and Trotman 1990, sections 1 to 3",
          12'000,
          {},
          run};
}

}  // namespace lamina::experiments
