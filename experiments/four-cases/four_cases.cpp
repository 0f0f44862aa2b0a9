#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> gaps{"1e-3", "1e-7", "1e-16"};
  const std::vector<std::string> cases{"i", "ii", "iii", "iv"};
  std::vector<Series> all;
  for (const std::string& gap : gaps) {
    for (const std::string& which : cases) {
      all.push_back(family_series({gap, which}, "four-cases:" + which + ":" + gap, coincident_aim(),
                                  settings.rays / (gaps.size() * cases.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment four_cases() {
  return {.name = "four-cases",
          .question =
              "Is each of the four solids that a difference of touching boxes can be "
              "seen as itself?",
          .source = "Wyvill and Trotman 1990, section 3.4, Figure 12",
          .labels = {{"gap", "gap", "Between the surfaces of A and B."},
                     {"case", "case",
                      "Of A - B: i, B hovers over A; ii, B stands in A; iii, B pokes out of A; iv, "
                      "B ends below the top of A."}},
          .default_rays = 24'000,
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
