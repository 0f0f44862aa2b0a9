#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

std::vector<Series> series(const Settings& settings) {
  using Kind = poly::RootFault::Kind;
  const std::vector<std::pair<std::string, Kind>> faults{{"dropped", Kind::Drop},
                                                         {"doubled", Kind::Double}};
  const std::vector<std::pair<std::string, double>> rates{
      {"0", 0}, {"1e-3", 1e-3}, {"1e-2", 1e-2}, {"1e-1", 1e-1}};
  const std::vector<Subject> subjects{{"one ball", "single:ball:0", uniform_aim()},
                                      {"one ring", "single:ring:0", uniform_aim()},
                                      {"some solids", "coincident-faces", uniform_aim()}};
  std::vector<Series> all;
  for (const Subject& subject : subjects) {
    for (const auto& [fault, kind] : faults) {
      for (const auto& [label, rate] : rates) {
        Series one = family_series({subject.label, fault, label}, subject.family, subject.aim,
                                   settings.rays / (subjects.size() * faults.size() * rates.size()),
                                   settings);
        one.plan.solvers.fault = {kind, rate};
        all.push_back(std::move(one));
      }
    }
  }
  return all;
}

}  // namespace

Experiment root_faults() {
  return {
      .name = "root-faults",
      .question = "How far does a method carry the error of one lost or doubled root?",
      .source = "Wyvill and Trotman 1990, section 3.3",
      .labels = {{"scene", "scene", ""},
                 {"fault", "fault", "What is done on purpose to one root of a leaf."},
                 {"rate", "rate", "Of the leaves that the ray crosses, the part it is done to."}},
      .default_rays = 48'000,
      .default_methods = "roth,wyvill-sharp,regularized,wyvill-trotman,wyvill-trotman:parity",
      .default_numbers = "bin11,float,double,longdouble,bin113,bin237",
      .series = series};
}

}  // namespace lamina::experiments
