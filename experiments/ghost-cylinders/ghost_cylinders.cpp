#include "experiments/ghost-cylinders/ghost_cylinders.hpp"

#include "experiments/family_census.hpp"
#include "report/census_table.hpp"

namespace lamina::experiments {
namespace {

Result run(const Settings& settings) {
  const census::Census census = family_census({"ghost-cylinders", scene::ghost_cylinders},
                                              Aim::Coincident, settings.rays, settings);
  return {{report::census_table({{aim_name(Aim::Coincident), census}}, aim_column(),
                                "ghost-cylinders")},
          census.interrupted};
}

}  // namespace

Experiment ghost_cylinders() {
  return {"ghost-cylinders",
          "Which methods report the cap plane of one cylinder as the top of another?",
          "Wyvill and Trotman 1990, section 2, Figure 4",
          10'000,
          {},
          run};
}

}  // namespace lamina::experiments
