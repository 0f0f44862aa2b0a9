// What one method sees of one ray in one number type, next to the truth.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "census/verdict.hpp"
#include "method/tracer.hpp"
#include "trace/number_choice.hpp"

namespace lamina::report {

/// One number type on the ray.
struct Lane {
  Lane(const scene::Scene& scene, const geometry::ExactRay& ray, const census::Truth& truth,
       const trace::NumberChoice& choice, const poly::Solvers& solvers);

  const trace::NumberChoice* number;
  std::unique_ptr<method::Tracer> tracer;
  census::Judge judge;
  /// By the tracer's crossing, the truth's that it is, or census::kNoCrossing.
  std::vector<std::uint32_t> exact_of;
};

/// One method in one number type.
struct Outcome {
  /// Runs the method on the ray that the truth and the lane have found.
  Outcome(const scene::Scene& scene, const geometry::ExactRay& ray, const census::Truth& truth,
          const method::Method& method, Lane& lane);

  const scene::Scene* scene;
  const census::Truth* truth;
  const method::Method* method;
  const Lane* lane;
  std::vector<method::EventRecord> records;
  method::Report report;
  census::Verdict verdict;
  std::vector<census::Finding> findings;  ///< as census::Judge has them

  /// The truth's crossing that the event is, or census::kNoCrossing.
  [[nodiscard]] std::uint32_t exact_of(const method::EventRecord& record) const {
    return lane->exact_of[record.crossing];
  }
  [[nodiscard]] csg::LeafIndex leaf_of(const method::EventRecord& record) const {
    return lane->tracer->crossings()[record.crossing].leaf;
  }
  [[nodiscard]] bool ahead(const method::EventRecord& record) const {
    return lane->tracer->crossings()[record.crossing].ahead;
  }
  /// The interface that is reported as the event, if any.
  [[nodiscard]] const method::Interface* reported(const method::EventRecord& record) const;

  /// Does the method test points, rather than carry states along?
  [[nodiscard]] bool geometric() const { return method->status == method::Status::Geometric; }
  /// What the method takes the leaf for before its first event.
  [[nodiscard]] bool first_state(csg::LeafIndex leaf) const;
  /// What the method takes the leaf for behind an event, where it is `before` in front of it.
  [[nodiscard]] bool state_behind(const method::EventRecord& record, csg::LeafIndex leaf,
                                  bool before) const;
};

}  // namespace lamina::report
