// A tracer that finds what it is told to.
#pragma once

#include <stdexcept>
#include <vector>

#include "method/tracer.hpp"

namespace lamina::support {

class FakeTracer final : public method::Tracer {
 public:
  /// One crossing and where it is said to be.
  struct Found {
    method::CrossingId id;
    double t = 0;
  };

  void set(const std::vector<Found>& found) {
    crossings_.clear();
    t_.clear();
    for (const Found& crossing : found) {
      crossings_.push_back(crossing.id);
      t_.push_back(crossing.t);
    }
  }

  void find(const geometry::ExactRay&) override {}
  void run(const method::Method&, method::Report&) override { unused(); }
  std::vector<method::EventRecord> explain(const method::Method&, method::Report&) override {
    unused();
  }
  [[nodiscard]] std::span<const method::CrossingId> crossings() const override {
    return crossings_;
  }
  [[nodiscard]] bool starts_inside(const method::Method&, csg::LeafIndex) const override {
    unused();
  }
  [[nodiscard]] bool in_some_carrier() const override { return false; }
  [[nodiscard]] bool inside_at(csg::LeafIndex, std::size_t) const override { unused(); }
  void reorder(std::span<const csg::LeafIndex>) override { unused(); }
  [[nodiscard]] double t(std::size_t crossing) const override { return t_.at(crossing); }
  [[nodiscard]] bool equal_t(std::size_t a, std::size_t b) const override {
    return t_.at(a) == t_.at(b);
  }
  /// Told from one another by the crossing: 1 ulp for the first, 2 for the second, ...
  [[nodiscard]] method::HitError error(std::size_t crossing, const number::Root&) const override {
    return {static_cast<double>(crossing + 1), 0.25, 0.5};
  }
  [[nodiscard]] csg::Medium medium_at(const geometry::ExactPoint&) const override { unused(); }

 private:
  [[noreturn]] static void unused() { throw std::logic_error("nobody asks a fake for this"); }

  std::vector<method::CrossingId> crossings_;
  std::vector<double> t_;
};

}  // namespace lamina::support
