#pragma once

#include <cmath>

#include "method/classify.hpp"
#include "method/locate.hpp"
#include "method/ray_events.ipp"
#include "method/tracer.hpp"

namespace lamina::method {
namespace detail {

template <number::RealNumber Number>
class TracerOf final : public Tracer {
 public:
  TracerOf(const scene::Scene& scene, const poly::Solvers& solvers)
      : scene_(scene), events_(scene, solvers), state_(scene.tree) {}

  void find(const geometry::ExactRay& ray) override {
    ray_ = ray;
    events_.find(ray);
    identify_crossings();
  }

  void reorder(std::span<const csg::LeafIndex> rank) override {
    events_.reorder(rank);
    identify_crossings();
  }

  void run(const Method& method, Report& report) override {
    Classifier(scene_, events_, state_, report, IgnoreEvents{})
        .run(method, step(method), along_ray(method.reference));
  }

  std::vector<EventRecord> explain(const Method& method, Report& report) override {
    std::vector<EventRecord> records;
    const auto keep = [&records](const EventRecord& record) { records.push_back(record); };
    Classifier(scene_, events_, state_, report, keep)
        .run(method, step(method), along_ray(method.reference));
    return records;
  }

  [[nodiscard]] std::span<const CrossingId> crossings() const override { return crossings_; }
  [[nodiscard]] bool starts_inside(const Method& method, csg::LeafIndex leaf) const override {
    return events_.starts_inside(leaf, along_ray(method.reference));
  }
  [[nodiscard]] bool in_some_carrier() const override { return events_.in_some_carrier(); }

  [[nodiscard]] bool inside_at(csg::LeafIndex leaf, std::size_t crossing) const override {
    return events_.inside_at(
        leaf, crossing == kStart ? Root{Number(0)} : events_.crossings()[crossing].t);
  }

  [[nodiscard]] double t(std::size_t crossing) const override {
    const auto& root = events_.crossings()[crossing].t;
    if constexpr (number::ExactNumber<Number>) {
      return nearest_double(root);
    } else {
      return number::to_double(root);
    }
  }

  [[nodiscard]] bool equal_t(std::size_t a, std::size_t b) const override {
    const auto& ta = events_.crossings()[a].t;
    const auto& tb = events_.crossings()[b].t;
    return !events_.less(ta, tb) && !events_.less(tb, ta);
  }

  [[nodiscard]] HitError error(std::size_t crossing, const number::Root& truth) const override;

  [[nodiscard]] csg::Medium medium_at(const geometry::ExactPoint& point) const override {
    if constexpr (number::ExactNumber<Number>) {
      return locate_exact(scene_, point).medium;
    } else {
      const geometry::Vector3<Number> world = geometry::rounded<Number>(point);
      return csg::evaluate(scene_.tree, [&](csg::LeafIndex leaf) {
        return events_.inside(leaf, world) ? scene_.tree.medium_of(leaf) : csg::kEmpty;
      });
    }
  }

 private:
  using Root = typename RayEvents<Number>::Root;

  void identify_crossings() {
    crossings_.clear();
    for (const Crossing<Number>& c : events_.crossings()) {
      crossings_.push_back({c.leaf, c.index, events_.positive(c.t), c.enters_by_parity});
    }
  }

  // The method's epsilon, in units of t if it is a length.
  [[nodiscard]] Number step(const Method& method) const {
    return method.relative_epsilon ? number::number_traits<Number>::from_exact(method.epsilon)
                                   : along_ray(method.epsilon);
  }

  // A length in units of t: divided by the direction's length in double, once for all number
  // types, so that they all use the same.
  [[nodiscard]] Number along_ray(const number::Rational& length) const {
    if (length.is_zero()) {
      return Number(0);
    }
    const double squared = number::nearest_double(dot(ray_.direction, ray_.direction));
    return number::number_traits<Number>::from_exact(
        number::Rational(number::nearest_double(length) / std::sqrt(squared)));
  }

  const scene::Scene& scene_;
  geometry::ExactRay ray_;
  RayEvents<Number> events_;
  csg::RayState state_;
  std::vector<CrossingId> crossings_;
};

/// The errors of a computed hit: the exact one is enclosed so narrowly that its own width
/// does not show in the first digits.
HitError hit_error(const scene::Scene& scene, const geometry::ExactRay& ray, csg::LeafIndex leaf,
                   const number::Root& truth, const number::Rational& t,
                   const geometry::ExactPoint& point, const geometry::ExactPoint& gradient,
                   int significand_bits);

template <number::RealNumber Number>
HitError TracerOf<Number>::error(std::size_t crossing, const number::Root& truth) const {
  if constexpr (number::ExactNumber<Number>) {
    return {};
  } else {
    const Crossing<Number>& c = events_.crossings()[crossing];
    const geometry::Vector3<Number> point = events_.point(c.t);
    const geometry::Vector3<Number> gradient = events_.gradient(c.leaf, point, events_.place(c));
    const auto exactly = [](const geometry::Vector3<Number>& v) -> geometry::ExactPoint {
      using Traits = number::number_traits<Number>;
      return {Traits::to_exact(v.x), Traits::to_exact(v.y), Traits::to_exact(v.z)};
    };
    return hit_error(scene_, ray_, c.leaf, truth, number::number_traits<Number>::to_exact(c.t),
                     exactly(point), exactly(gradient),
                     number::number_traits<Number>::kSignificandBits);
  }
}

}  // namespace detail

template <number::RealNumber Number>
std::unique_ptr<Tracer> make_tracer(const scene::Scene& scene, const poly::Solvers& solvers) {
  return std::make_unique<detail::TracerOf<Number>>(scene, solvers);
}

}  // namespace lamina::method
