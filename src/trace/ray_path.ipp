#pragma once

#include <cmath>

#include "base/contract.hpp"
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
      : events_(scene, solvers), scene_(scene), state_(scene.tree), levels_(1) {
    if (scene.bounds) {
      for (const geometry::ExactPoint* corner : {&scene.bounds->lower, &scene.bounds->upper}) {
        scene_size_ = largest_coordinate(scene_size_, geometry::rounded<Number>(*corner));
      }
    }
  }

  void start(const geometry::ExactRay& primary) override {
    depth_ = 0;
    present().inherited.clear();
    present().validated = false;
    follow(geometry::rounded<Number>(primary), {});
  }

  void run(const method::Method& method, method::Report& report, Extent extent) override {
    LAMINA_REQUIRE(followed_ == depth_, "after back() a ray only spawns others");
    Level& level = present();
    method::Classifier classifier(scene_, events_, state_, report, method::IgnoreEvents{});
    classifier.inherit({level.inherited, level.validated});
    if (extent == Extent::FirstInterface) {
      classifier.stop_at(level.changed);
    }
    classifier.run(
        method,
        method.relative_epsilon ? Traits::from_exact(method.epsilon) : along_ray(method.epsilon),
        along_ray(method.reference));
    level.is_hit = extent == Extent::FirstInterface && !report.interfaces.empty();
    if (level.is_hit) {
      record_hit(report.interfaces.front());
    }
  }

  [[nodiscard]] std::span<const method::CrossingId> crossings() const override {
    return crossings_;
  }

  [[nodiscard]] double t(std::size_t crossing) const override {
    return number::to_double(events_.crossings()[crossing].t);
  }

  [[nodiscard]] std::optional<PathHit> hit() const override {
    const Level& level = levels_[depth_];
    if (!level.is_hit) {
      return std::nullopt;
    }
    return PathHit{to_double(level.point), to_double(level.gradient)};
  }

  std::optional<geometry::ExactPoint> spawn(const method::Method& method,
                                            const Spawn& spawn) override {
    if (!present().is_hit) {
      return std::nullopt;
    }
    const std::optional<Vector> direction = spawned_direction(spawn);
    if (!direction || !is_finite(*direction)) {
      return std::nullopt;
    }
    const Vector start = start_of(spawn.policy, *direction);
    if (!is_finite(start)) {
      return std::nullopt;
    }
    if (levels_.size() == depth_ + 1) {
      levels_.emplace_back();
    }
    const csg::LeafIndex left = present().leaf;
    hand_on(method, spawn);
    ++depth_;
    follow({start, *direction}, spawn.policy.kind == SpawnPolicy::Kind::DivideOut
                                    ? leaves_on_surface_of(left)
                                    : std::span<const csg::LeafIndex>{});
    return geometry::ExactPoint{Traits::to_exact(direction->x), Traits::to_exact(direction->y),
                                Traits::to_exact(direction->z)};
  }

  void back() override {
    LAMINA_REQUIRE(depth_ > 0, "a primary ray is spawned from none");
    --depth_;
  }

 private:
  /// A ray of the path.
  struct Level {
    geometry::Ray<Number> ray;
    std::vector<std::uint8_t> inherited;  // by leaf; empty for a primary ray
    bool validated = false;               // see method::Inherited
    bool is_hit = false;                  // is the rest known, of the ray's first interface?
    csg::LeafIndex leaf = 0;
    csg::Transition transition;
    Vector point;
    typename method::RayEvents<Number>::Place place;
    Vector gradient;
    std::vector<std::uint8_t> states;  // of the leaves, behind the hit
    method::Hit changed;
  };

  Level& present() { return levels_[depth_]; }

  void record_hit(const method::Interface& interface) {
    Level& level = present();
    const auto& crossing = events_.crossings()[interface.crossing];
    level.leaf = crossing.leaf;
    level.transition = interface.transition;
    level.point = events_.point(crossing.t);
    level.place = events_.place(crossing);
    level.gradient = events_.gradient(crossing.leaf, level.point, level.place);
    level.states.resize(scene_.leaves.size());
    for (csg::LeafIndex leaf = 0; leaf < level.states.size(); ++leaf) {
      level.states[leaf] = state_.inside(leaf) ? Inherited::kInside : Inherited::kOutside;
    }
    const Number squared = dot(level.gradient, level.gradient);
    level.is_hit =
        is_finite(level.point) && squared > 0 && method::RayEvents<Number>::finite(squared);
  }

  [[nodiscard]] std::span<const csg::LeafIndex> leaves_on_surface_of(csg::LeafIndex leaf) const {
    return scene_.leaves_of_carrier[scene_.leaves[leaf].carrier];
  }

  static bool is_finite(const Vector& v) {
    return method::RayEvents<Number>::finite(v.x) && method::RayEvents<Number>::finite(v.y) &&
           method::RayEvents<Number>::finite(v.z);
  }

  static Number length(const Vector& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
  }

  static geometry::Vector3<double> to_double(const Vector& v) {
    return {number::to_double(v.x), number::to_double(v.y), number::to_double(v.z)};
  }

  // Leaves in `left` share the surface that the ray leaves: its root s = 0 is divided out.
  void follow(const geometry::Ray<Number>& ray, std::span<const csg::LeafIndex> left) {
    present().ray = ray;
    present().is_hit = false;
    followed_ = depth_;
    events_.find(ray, left);
    crossings_.clear();
    for (const auto& c : events_.crossings()) {
      crossings_.push_back({c.leaf, c.index, events_.positive(c.t), c.enters_by_parity});
    }
  }

  // A length in units of t.
  [[nodiscard]] Number along_ray(const number::Rational& value) const {
    return value.is_zero()
               ? Number(0)
               : Number(Traits::from_exact(value) / length(levels_[depth_].ray.direction));
  }

  [[nodiscard]] std::optional<Vector> spawned_direction(const Spawn& spawn) {
    const Vector& d = present().ray.direction;
    const Vector& gradient = present().gradient;
    switch (spawn.branch) {
      case Branch::Reflection:
        return d - Number(2 * dot(d, gradient) / dot(gradient, gradient)) * gradient;
      case Branch::Shadow: {
        const Vector towards = geometry::rounded<Number>(spawn.light) - present().point;
        // A light behind the surface does not shine on it.
        const bool behind = (dot(towards, gradient) < 0) == (dot(d, gradient) < 0);
        return behind ? std::nullopt : std::optional(towards);
      }
      case Branch::Transmission:
        break;
    }
    const auto index = [this](csg::Medium medium) {
      return scene_.materials[medium].refractive_index;
    };
    const number::Rational exact_ratio =
        index(present().transition.from) / index(present().transition.to);
    if (exact_ratio == 1) {
      return d;
    }
    // Snell's law in vector form, with unit vectors and the normal against the ray.
    using std::sqrt;
    const Number ratio = Traits::from_exact(exact_ratio);
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
  [[nodiscard]] Vector start_of(const SpawnPolicy& policy, const Vector& direction) {
    using Kind = SpawnPolicy::Kind;
    const Vector& point = present().point;
    if (policy.kind == Kind::None || policy.kind == Kind::LeafState ||
        policy.kind == Kind::DivideOut) {
      return point;
    }
    if (policy.kind == Kind::Offset) {
      return point + Number(offset_length(policy) / length(direction)) * direction;
    }
    const Vector& gradient = present().gradient;
    const bool outwards = dot(direction, gradient) >= 0;
    const Vector normal = Number((outwards ? Number(1) : Number(-1)) / length(gradient)) * gradient;
    if (policy.kind == Kind::NormalOffset) {
      return point + offset_length(policy) * normal;
    }
    if (policy.kind == Kind::ErrorBound) {
      Number distance(0);
      for (const csg::LeafIndex leaf : leaves_on_surface_of(present().leaf)) {
        const Number bound = events_.distance_bound(leaf, point, present().place);
        distance = distance < bound ? bound : distance;
      }
      const auto moved = [&distance](const Number& p, const Number& n) {
        const Number q = p + distance * n;
        return q == 0 || n == 0 ? q : n > 0 ? Number(q + ulp(q)) : Number(q - ulp(q));
      };
      return {moved(point.x, normal.x), moved(point.y, normal.y), moved(point.z, normal.z)};
    }
    const auto moved = [&policy](const Number& p, const Number& n) {
      using std::abs;
      if (abs(p) < Number(1) / 32) {
        return Number(p + n / 65536);
      }
      return Number(p + Number(static_cast<int>(Number(policy.ulps) * n)) * ulp(p));
    };
    return {moved(point.x, normal.x), moved(point.y, normal.y), moved(point.z, normal.z)};
  }

  [[nodiscard]] Number offset_length(const SpawnPolicy& policy) {
    const Number epsilon = Traits::from_exact(policy.epsilon);
    return policy.relative_epsilon
               ? Number(epsilon *
                        largest_coordinate(largest_coordinate(scene_size_, present().ray.origin),
                                           present().point))
               : epsilon;
  }

  // The largest of a size and the coordinates of a point.
  static Number largest_coordinate(Number size, const Vector& point) {
    using std::abs;
    for (const Number* value : {&point.x, &point.y, &point.z}) {
      const Number coordinate = abs(*value);
      size = size < coordinate ? coordinate : size;
    }
    return size;
  }

  // The distance from |p| to the next larger number.
  static Number ulp(const Number& p) {
    using std::frexp;
    using std::ldexp;
    int exponent = 0;
    frexp(p, &exponent);
    return ldexp(Number(1), exponent - Traits::kSignificandBits);
  }

  // What the next ray takes over from the present one.
  void hand_on(const method::Method& method, const Spawn& spawn) {
    using method::Secondary;
    const Level& level = levels_[depth_];
    Level& next = levels_[depth_ + 1];
    const bool leaf_state = spawn.policy.kind == SpawnPolicy::Kind::LeafState;
    // What is carried anew along each ray has no leaf state to take over but the hit leaf's.
    const Secondary secondary =
        leaf_state && method.secondary == Secondary::Parity ? Secondary::Hybrid : method.secondary;
    next.validated = leaf_state;
    if (method.status == method::Status::Geometric || secondary == Secondary::Parity) {
      next.inherited.clear();
      return;
    }
    const auto opposite = [](std::uint8_t state) {
      return state == Inherited::kInside ? Inherited::kOutside : Inherited::kInside;
    };
    const bool goes_on = spawn.branch == Branch::Transmission;
    next.inherited = level.states;
    if (!goes_on) {
      for (const csg::LeafIndex leaf : level.changed.passed) {
        next.inherited[leaf] = opposite(next.inherited[leaf]);
      }
      if (!method.keeps_hit_leaf) {
        for (const csg::LeafIndex leaf : level.changed.group) {
          next.inherited[leaf] = opposite(next.inherited[leaf]);
        }
      }
    }
    if (secondary == Secondary::Cluster) {
      // Leaves coincide exactly if they share the hit leaf's carrier. All of them have been
      // crossed where the ray goes on, none where it does not.
      const scene::Leaf& hit = scene_.leaves[level.leaf];
      const std::uint8_t behind = level.states[level.leaf];
      for (const csg::LeafIndex leaf : leaves_on_surface_of(level.leaf)) {
        const bool alike = scene_.leaves[leaf].side == hit.side;
        next.inherited[leaf] = alike == goes_on ? behind : opposite(behind);
      }
    } else if (secondary == Secondary::Hybrid) {
      const std::uint8_t of_hit_leaf = next.inherited[level.leaf];
      next.inherited.assign(next.inherited.size(), Inherited::kAnew);
      next.inherited[level.leaf] = of_hit_leaf;
    }
  }

  method::RayEvents<Number> events_;
  const scene::Scene& scene_;
  csg::RayState state_;
  Number scene_size_{0};
  std::vector<Level> levels_;  // from the primary ray down; those below depth_ are spare
  std::size_t depth_ = 0;
  std::size_t followed_ = 0;  // the depth whose ray events_ and crossings_ are of
  std::vector<method::CrossingId> crossings_;
};

}  // namespace detail

template <number::RoundedNumber Number>
std::unique_ptr<RayPath> make_ray_path(const scene::Scene& scene, const poly::Solvers& solvers) {
  return std::make_unique<detail::RayPathOf<Number>>(scene, solvers);
}

}  // namespace lamina::trace
