#include "report/symptom.hpp"
#include "trace/number_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace lamina::report {
namespace {

using census::Artifact;

// What is wrong in one number type, apart from whether it is in exact numbers too.
std::optional<Symptom> symptom_in(const scene::Scene& scene, const geometry::ExactRay& ray,
                                  const census::Truth& truth, const method::Method& method,
                                  const trace::NumberChoice& number, const poly::Solvers& solvers) {
  Lane lane(scene, ray, truth, number, solvers);
  const Outcome outcome(scene, ray, truth, method, lane);
  const auto& count = outcome.verdict.count;
  const auto& findings = outcome.findings;
  if (outcome.verdict.right()) {
    return std::nullopt;
  }
  Symptom symptom;
  symptom.first_wrong = outcome.verdict[Artifact::FirstWrong] > 0;
  const auto nearest = std::min_element(findings.begin(), findings.end(),
                                        [](const auto& a, const auto& b) { return a.cls < b.cls; });
  std::size_t first_counted = 0;
  while (count[first_counted] == 0) {
    ++first_counted;
  }
  symptom.artifact =
      nearest != findings.end() ? nearest->artifact : static_cast<Artifact>(first_counted);
  symptom.cause = first_divergence(outcome).cause;
  return symptom;
}

}  // namespace

std::optional<Symptom> symptom(const scene::Scene& scene, const geometry::ExactRay& ray,
                               const method::Method& method, const trace::NumberChoice& number,
                               const poly::Solvers& solvers) {
  census::Truth truth(scene);
  truth.find(ray);
  if (truth.in_some_carrier()) {
    return std::nullopt;
  }
  auto found = symptom_in(scene, ray, truth, method, number, solvers);
  if (found) {
    const auto exact =
        symptom_in(scene, ray, truth, method, trace::number_choice<number::exact>(), solvers);
    found->in_exact =
        exact && exact->artifact == found->artifact && exact->first_wrong == found->first_wrong;
  }
  return found;
}

std::string text_of(const Symptom& symptom) {
  const auto& texts = census::artifact_texts();
  const auto heading = [&texts](Artifact artifact) {
    return texts[static_cast<std::size_t>(artifact)].heading;
  };
  return fmt::format("{}{}{}; {}", symptom.first_wrong ? heading(Artifact::FirstWrong) : "",
                     symptom.first_wrong ? ", " : "", heading(symptom.artifact),
                     symptom.in_exact ? "in exact numbers too" : "not in exact numbers");
}

}  // namespace lamina::report
