// What is wrong with one ray, in few words: what a smaller case must show too.
#pragma once

#include <optional>
#include <string>

#include "report/divergence.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {

struct Symptom {
  bool first_wrong = false;  ///< what a picture shows is wrong
  /// Of the wrong interface nearest to the start; where no interface is wrong, the first of
  /// those counted, in their order.
  census::Artifact artifact = census::Artifact::GhostHit;
  Divergence::Cause cause = Divergence::Cause::Unknown;
  bool in_exact = false;  ///< the method shows the artifact in exact numbers: it is not rounding

  /// Is it the other one, or the same in the first interface where it was in a later one?
  [[nodiscard]] bool shows(const Symptom& other) const {
    return artifact == other.artifact && cause == other.cause && in_exact == other.in_exact &&
           (first_wrong || !other.first_wrong);
  }
};

/// Returns what is wrong with a ray; nothing if it is right, or lies in a carrier.
std::optional<Symptom> symptom(const scene::Scene& scene, const geometry::ExactRay& ray,
                               const method::Method& method, const trace::NumberChoice& number,
                               const poly::Solvers& solvers);

/// `first wrong, ghost hit; not in exact numbers`.
std::string text_of(const Symptom& symptom);

}  // namespace lamina::report
