// A tracer that is right, but for the errors that it is told to make.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "method/tracer.hpp"
#include "trace/number_choice.hpp"

namespace lamina::support {

/// The truth of every ray, whatever the method: `regularized` in exact numbers. Errors are
/// put in afterwards, and may depend on nothing but the ray.
class SyntheticTracer final : public method::Tracer {
 public:
  struct Errors {
    /// What is said of a crossing; nothing where it is lost, and interfaces at it with it.
    std::function<std::optional<method::CrossingId>(const geometry::ExactRay&, const Tracer& right,
                                                    std::size_t crossing)>
        crossing = [](const auto&, const Tracer& right, std::size_t i) {
          return std::optional(right.crossings()[i]);
        };
    /// Changes the right answer; crossings are this tracer's.
    std::function<void(const geometry::ExactRay&, const SyntheticTracer&, method::Report&)> report =
        [](const auto&, const auto&, auto&) {};
  };

  SyntheticTracer(const scene::Scene& scene, Errors errors)
      : right_(method::make_tracer<number::exact>(scene, {})), errors_(std::move(errors)) {}

  void find(const geometry::ExactRay& ray) override {
    ray_ = ray;
    right_->find(ray);
    find_crossings();
  }

  void reorder(std::span<const csg::LeafIndex> rank) override {
    right_->reorder(rank);
    find_crossings();
  }

  void run(const method::Method&, method::Report& report) override {
    right_->run(method::regularized(), report);
    std::vector<method::Interface> known;
    for (method::Interface interface : report.interfaces) {
      for (std::uint32_t i = 0; i < right_index_.size(); ++i) {
        if (right_index_[i] == interface.crossing) {
          known.push_back({i, interface.transition});
        }
      }
    }
    report.interfaces = std::move(known);
    errors_.report(ray_, *this, report);
  }

  std::vector<method::EventRecord> explain(const method::Method&, method::Report&) override {
    throw std::logic_error("a synthetic answer has no explanation");
  }
  [[nodiscard]] std::span<const method::CrossingId> crossings() const override {
    return crossings_;
  }
  [[nodiscard]] bool starts_inside(const method::Method& method,
                                   csg::LeafIndex leaf) const override {
    return right_->starts_inside(method, leaf);
  }
  [[nodiscard]] bool in_some_carrier() const override { return right_->in_some_carrier(); }
  [[nodiscard]] bool inside_at(csg::LeafIndex leaf, std::size_t crossing) const override {
    return right_->inside_at(leaf, crossing == kStart ? kStart : right_index_.at(crossing));
  }
  [[nodiscard]] double t(std::size_t crossing) const override {
    return right_->t(right_index_.at(crossing));
  }
  [[nodiscard]] bool equal_t(std::size_t a, std::size_t b) const override {
    return right_->equal_t(right_index_.at(a), right_index_.at(b));
  }
  [[nodiscard]] method::HitError error(std::size_t crossing,
                                       const number::Root& truth) const override {
    return right_->error(right_index_.at(crossing), truth);
  }
  [[nodiscard]] csg::Medium medium_at(const geometry::ExactPoint& point) const override {
    return right_->medium_at(point);
  }

 private:
  void find_crossings() {
    crossings_.clear();
    right_index_.clear();
    for (std::size_t i = 0; i < right_->crossings().size(); ++i) {
      if (const auto said = errors_.crossing(ray_, *right_, i)) {
        crossings_.push_back(*said);
        right_index_.push_back(i);
      }
    }
  }

  std::unique_ptr<method::Tracer> right_;
  Errors errors_;
  geometry::ExactRay ray_;
  std::vector<method::CrossingId> crossings_;
  std::vector<std::size_t> right_index_;  // by crossing, the right tracer's
};

/// A number type whose tracers make these errors.
inline trace::NumberChoice synthetic_number(const SyntheticTracer::Errors& errors) {
  return {"synthetic", 0,
          [errors](const scene::Scene& scene, const poly::Solvers&) {
            return std::make_unique<SyntheticTracer>(scene, errors);
          },
          scene::rounding<number::exact>};
}

}  // namespace lamina::support
