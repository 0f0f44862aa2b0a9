#include "method/spawned_events.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace lamina::method {

using geometry::ExactPoint;
using number::Enclosure;
using number::Interval;
using number::Rational;
using EnclosedPoint = geometry::Vector3<Interval>;

namespace {

constexpr int kFirstBits = 128;

EnclosedPoint point_at(const EnclosedPoint& origin, const ExactPoint& direction,
                       const Interval& t) {
  const auto along = [&](const Interval& from, const Rational& way) {
    return from + Interval(way, t.bits()) * t;
  };
  return {along(origin.x, direction.x), along(origin.y, direction.y), along(origin.z, direction.z)};
}

}  // namespace

ExactStart start_on(const scene::Scene& scene, const geometry::ExactRay& ray,
                    const number::Root& t) {
  ExactStart start;
  start.point = [ray, t](int bits) -> std::optional<EnclosedPoint> {
    const Interval at(enclosure(t, bits), 2 * bits);
    const auto exactly = [&at](const Rational& value) { return Interval(value, at.bits()); };
    return point_at({exactly(ray.origin.x), exactly(ray.origin.y), exactly(ray.origin.z)},
                    ray.direction, at);
  };
  surface::RayMonomials monomials(ray);
  for (surface::CarrierIndex c = 0; c < scene.carriers.size(); ++c) {
    if (surface::CarrierOnRay(scene.carriers[c], ray, monomials).sign_at(t) == 0) {
      start.carriers.push_back(c);
    }
  }
  return start;
}

std::optional<SpawnedEvents::CarrierRoots> SpawnedEvents::roots_of(
    surface::CarrierIndex carrier, surface::EnclosedRayMonomials& ray) const {
  std::vector<Interval> f = ray.restrict(scene_->carriers[carrier]);
  if (std::binary_search(start_.carriers.begin(), start_.carriers.end(), carrier)) {
    f.erase(f.begin());
  }
  const auto is_zero = [](const Interval& coefficient) { return coefficient.sign() == 0; };
  while (!f.empty() && is_zero(f.back())) {
    f.pop_back();
  }
  f.erase(f.begin(), std::find_if_not(f.begin(), f.end(), is_zero));
  if (f.empty()) {
    return CarrierRoots{};
  }
  const auto sign = f.front().sign();
  auto roots = poly::positive_roots(std::move(f));
  if (!roots) {
    return std::nullopt;
  }
  return CarrierRoots{*sign, std::move(*roots)};
}

bool SpawnedEvents::find_with(int bits) {
  const auto origin = start_.point(bits);
  if (!origin) {
    return false;
  }
  surface::EnclosedRayMonomials ray(*origin, direction_);
  classes_.clear();
  starts_inside_.assign(scene_->leaves.size(), 0);
  std::vector<poly::IsolatedRoot> roots;  // of classes_
  for (surface::CarrierIndex c = 0; c < scene_->carriers.size(); ++c) {
    auto found = roots_of(c, ray);
    if (!found) {
      return false;
    }
    for (const csg::LeafIndex leaf : scene_->leaves_of_carrier[c]) {
      starts_inside_[leaf] = scene_->leaves[leaf].side * found->sign < 0 ? 1 : 0;
    }
    for (std::size_t i = 0; i < found->roots.size(); ++i) {
      classes_.push_back({c, i, 0});
      roots.push_back(std::move(found->roots[i]));
    }
  }
  // Insertion sort: comparing may fail.
  for (std::size_t i = 1; i < roots.size(); ++i) {
    for (std::size_t j = i; j > 0; --j) {
      const auto order = compare(roots[j - 1], roots[j]);
      if (!order) {
        return false;
      }
      if (*order < 0) {
        break;
      }
      std::swap(roots[j - 1], roots[j]);
      std::swap(classes_[j - 1], classes_[j]);
    }
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    constexpr int kBitsOfDouble = 60;
    const auto bounds = enclosure(roots[i], kBitsOfDouble);
    if (!bounds) {
      return false;
    }
    classes_[i].s = number::nearest_double(Rational((bounds->lower + bounds->upper) / 2));
  }
  return true;
}

bool SpawnedEvents::find(const ExactStart& start, const ExactPoint& direction) {
  start_ = start;
  direction_ = direction;
  classes_.clear();
  if (std::any_of(scene_->carriers.begin(), scene_->carriers.end(),
                  [](const surface::Carrier& carrier) { return carrier.sweep != nullptr; })) {
    return false;
  }
  for (int bits = kFirstBits; bits <= kMaxBits; bits *= 2) {
    if (find_with(bits)) {
      return true;
    }
  }
  classes_.clear();
  return false;
}

ExactStart SpawnedEvents::start_on(std::size_t cls) const {
  const SpawnedClass at = classes_[cls];
  ExactStart next;
  next.carriers = {at.carrier};
  // A copy answers: this object goes on to other rays. Deeper rays ask again, for more bits.
  struct Known {
    SpawnedEvents events;
    int bits = 0;
    std::optional<EnclosedPoint> point;
  };
  next.point = [known = std::make_shared<Known>(Known{*this, 0, std::nullopt}),
                at](int bits) -> std::optional<EnclosedPoint> {
    // What one hit mostly loses; where it is more, twice as many bits and so on are asked for.
    constexpr int kGuardBits = 16;
    constexpr int kLimit = 4 * kMaxBits;
    if (bits <= known->bits) {
      return known->point;
    }
    const SpawnedEvents& events = known->events;
    for (int guard = kGuardBits; bits + guard <= kLimit; guard *= 2) {
      const auto origin = events.start_.point(bits + guard);
      if (!origin) {
        return std::nullopt;
      }
      surface::EnclosedRayMonomials ray(*origin, events.direction_);
      auto found = events.roots_of(at.carrier, ray);
      if (!found) {
        continue;
      }
      if (const auto s = enclosure(std::move(found->roots[at.root]), bits)) {
        known->bits = bits;
        known->point = point_at(*origin, events.direction_, Interval(*s, origin->x.bits()));
        return known->point;
      }
    }
    return std::nullopt;
  };
  return next;
}

}  // namespace lamina::method
