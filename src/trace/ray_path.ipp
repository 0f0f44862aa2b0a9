#pragma once

#include <cmath>

#include "method/classify.hpp"
#include "method/ray_events.hpp"
#include "trace/ray_path.hpp"

namespace lamina::trace {
namespace detail {

template <number::RoundedNumber Number>
class RayPathOf final : public RayPath {
  using Vector = geometry::Vector3<Number>;
  using Traits = number::number_traits<Number>;
  using Inherited = method::Inherited;

 public:
  RayPathOf(const scene::Scene& scene, const poly::Solvers& solvers)
      : events_(scene, solvers), scene_(scene), state_(scene.tree) {}

  void start(const geometry::ExactRay& primary) override {
    inherited_.clear();
    follow({method::rounded<Number>(primary.origin), method::rounded<Number>(primary.direction)});
  }

  void run(const method::Method& method, method::Report& report) override {
    method::Classifier classifier(scene_, events_, state_, report, method::IgnoreEvents{});
    classifier.inherit({inherited_});
    classifier.stop_at(hit_);
    classifier.run(
        method,
        method.relative_epsilon ? Traits::from_exact(method.epsilon) : along_ray(method.epsilon),
        along_ray(method.reference));
    interface_.reset();
    if (!report.interfaces.empty()) {
      interface_ = report.interfaces.front().crossing;
    }
  }

  [[nodiscard]] std::span<const method::CrossingId> crossings() const override {
    return crossings_;
  }

  [[nodiscard]] double t(std::size_t crossing) const override {
    const Number& root = events_.crossings()[crossing].t;
    return events_.finite(root) ? number::nearest_double(Traits::to_exact(root))
                                : static_cast<double>(root);
  }

  std::optional<geometry::ExactPoint> spawn(const method::Method& method, const Spawn& spawn,
                                            std::span<const CoincidentEvent> coincident) override {
    if (!interface_) {
      return std::nullopt;
    }
    const auto& hit = events_.crossings()[*interface_];
    const Vector point = events_.point(hit.t);
    const Vector gradient = events_.gradient(hit.leaf, point);
    const std::optional<Vector> direction = spawned_direction(spawn, point, gradient);
    if (!direction || !is_finite(*direction) || !is_finite(point)) {
      return std::nullopt;
    }
    hand_on(method, spawn.branch, hit.leaf, coincident);
    follow({start_of(spawn.policy, point, *direction, gradient), *direction});
    return geometry::ExactPoint{Traits::to_exact(direction->x), Traits::to_exact(direction->y),
                                Traits::to_exact(direction->z)};
  }

 private:
  static bool is_finite(const Vector& v) {
    return method::RayEvents<Number>::finite(v.x) && method::RayEvents<Number>::finite(v.y) &&
           method::RayEvents<Number>::finite(v.z);
  }

  static Number length(const Vector& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
  }

  void follow(const geometry::Ray<Number>& ray) {
    ray_ = ray;
    events_.find(ray);
    crossings_.clear();
    for (const auto& c : events_.crossings()) {
      crossings_.push_back({c.leaf, c.index, events_.positive(c.t), c.enters_by_parity});
    }
    interface_.reset();
  }

  // A length in units of t.
  [[nodiscard]] Number along_ray(const number::Rational& value) const {
    return value.is_zero() ? Number(0) : Number(Traits::from_exact(value) / length(ray_.direction));
  }

  [[nodiscard]] std::optional<Vector> spawned_direction(const Spawn& spawn, const Vector& point,
                                                        const Vector& gradient) const {
    const Vector& d = ray_.direction;
    switch (spawn.branch) {
      case Branch::Reflection:
        return d - Number(2 * dot(d, gradient) / dot(gradient, gradient)) * gradient;
      case Branch::Shadow:
        return method::rounded<Number>(spawn.light) - point;
      case Branch::Transmission:
        break;
    }
    if (spawn.index_ratio == 1) {
      return d;
    }
    // Snell's law in vector form, with unit vectors and the normal against the ray.
    using std::sqrt;
    const Number ratio = Traits::from_exact(spawn.index_ratio);
    const Vector unit = Number(1 / length(d)) * d;
    Vector normal = Number(1 / length(gradient)) * gradient;
    Number cosine = -dot(unit, normal);
    if (cosine < 0) {
      normal = Number(-1) * normal;
      cosine = -cosine;
    }
    const Number squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (squared < 0) {
      return std::nullopt;
    }
    return ratio * unit + Number(ratio * cosine - sqrt(squared)) * normal;
  }

  // Where the spawned ray starts.
  [[nodiscard]] Vector start_of(const SpawnPolicy& policy, const Vector& point,
                                const Vector& direction, const Vector& gradient) const {
    if (policy.kind == SpawnPolicy::Kind::None) {
      return point;
    }
    const bool outwards = dot(direction, gradient) >= 0;
    const Vector normal = Number((outwards ? Number(1) : Number(-1)) / length(gradient)) * gradient;
    if (policy.kind == SpawnPolicy::Kind::UlpOffset) {
      const auto moved = [&policy](const Number& p, const Number& n) {
        using std::abs;
        if (abs(p) < Number(1) / 32) {
          return Number(p + n / 65536);
        }
        return Number(p + Number(static_cast<int>(Number(policy.ulps) * n)) * ulp(p));
      };
      return {moved(point.x, normal.x), moved(point.y, normal.y), moved(point.z, normal.z)};
    }
    Number epsilon = Traits::from_exact(policy.epsilon);
    if (policy.relative_epsilon) {
      epsilon = epsilon * largest_coordinate(point);
    }
    return policy.kind == SpawnPolicy::Kind::Offset
               ? point + Number(epsilon / length(direction)) * direction
               : point + epsilon * normal;
  }

  [[nodiscard]] Number largest_coordinate(const Vector& point) const {
    using std::abs;
    Number largest(0);
    for (const Number* value :
         {&point.x, &point.y, &point.z, &ray_.origin.x, &ray_.origin.y, &ray_.origin.z}) {
      const Number size = abs(*value);
      largest = largest < size ? size : largest;
    }
    return largest;
  }

  // The distance from |p| to the next larger number.
  static Number ulp(const Number& p) {
    using std::frexp;
    using std::ldexp;
    int exponent = 0;
    frexp(p, &exponent);
    return ldexp(Number(1), exponent - Traits::kSignificandBits);
  }

  // What the spawned ray takes over from the present one, whose state is that behind the hit.
  void hand_on(const method::Method& method, Branch branch, csg::LeafIndex hit_leaf,
               std::span<const CoincidentEvent> coincident) {
    if (method.status == method::Status::Geometric ||
        method.secondary == method::Secondary::Parity) {
      inherited_.clear();
      return;
    }
    const auto now = [this](csg::LeafIndex leaf) {
      return state_.inside(leaf) ? Inherited::kInside : Inherited::kOutside;
    };
    inherited_.resize(scene_.leaves.size());
    for (csg::LeafIndex leaf = 0; leaf < inherited_.size(); ++leaf) {
      inherited_[leaf] = now(leaf);
    }
    const auto flip = [this](csg::LeafIndex leaf) {
      inherited_[leaf] =
          inherited_[leaf] == Inherited::kInside ? Inherited::kOutside : Inherited::kInside;
    };
    const bool goes_on = branch == Branch::Transmission;
    if (!goes_on) {
      for (const csg::LeafIndex leaf : hit_.passed) {
        flip(leaf);
      }
      if (!method.keeps_hit_leaf) {
        for (const csg::LeafIndex leaf : hit_.group) {
          flip(leaf);
        }
      }
    }
    if (method.secondary == method::Secondary::Cluster) {
      for (const CoincidentEvent& event : coincident) {
        inherited_[event.leaf] = event.enters == goes_on ? Inherited::kInside : Inherited::kOutside;
      }
    } else if (method.secondary == method::Secondary::Hybrid) {
      const std::uint8_t of_hit_leaf = inherited_[hit_leaf];
      inherited_.assign(inherited_.size(), Inherited::kAnew);
      inherited_[hit_leaf] = of_hit_leaf;
    }
  }

  method::RayEvents<Number> events_;
  const scene::Scene& scene_;
  csg::RayState state_;
  geometry::Ray<Number> ray_;
  std::vector<method::CrossingId> crossings_;
  std::vector<std::uint8_t> inherited_;  // by leaf; empty for a primary ray
  method::Hit hit_;
  std::optional<std::uint32_t> interface_;
};

}  // namespace detail

template <number::RoundedNumber Number>
std::unique_ptr<RayPath> make_ray_path(const scene::Scene& scene, const poly::Solvers& solvers) {
  return std::make_unique<detail::RayPathOf<Number>>(scene, solvers);
}

}  // namespace lamina::trace
