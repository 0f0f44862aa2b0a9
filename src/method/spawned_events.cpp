#include "method/spawned_events.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace lamina::method {

using geometry::ExactPoint;
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

SpawnedEvents::SpawnedEvents(const scene::Scene& scene) : scene_(&scene) {
  std::vector<std::optional<surface::EnclosedSweep>> sweeps;
  for (const surface::Carrier& carrier : scene.carriers) {
    const bool is_contour =
        carrier.sweep && std::holds_alternative<surface::SweptSurface>(carrier.sweep->surface);
    sweeps.push_back(is_contour ? std::optional<surface::EnclosedSweep>(carrier.sweep)
                                : std::nullopt);
    is_decidable_ = is_decidable_ && (is_contour || !carrier.sweep);
  }
  sweeps_ =
      std::make_shared<const std::vector<std::optional<surface::EnclosedSweep>>>(std::move(sweeps));
}

ExactStart SpawnedEvents::start_on(const geometry::ExactRay& ray, const number::Root& t) const {
  ExactStart start;
  start.point = [ray, t](int bits) -> std::optional<EnclosedPoint> {
    const Interval at(enclosure(t, bits), 2 * bits);
    const auto exactly = [&at](const Rational& value) { return Interval(value, at.bits()); };
    return point_at({exactly(ray.origin.x), exactly(ray.origin.y), exactly(ray.origin.z)},
                    ray.direction, at);
  };
  const EnclosedPoint point = *start.point(kFirstBits);
  surface::RayMonomials monomials(ray);
  for (surface::CarrierIndex c = 0; c < scene_->carriers.size(); ++c) {
    const auto& sweep = (*sweeps_)[c];
    const auto curves =
        sweep ? sweep->curves_at(ray, t, point) : std::vector<surface::EnclosedSweep::CurveIndex>{};
    if (sweep && curves.empty()) {
      continue;
    }
    for (const auto curve : curves) {
      start.curves.push_back({c, curve});
    }
    const surface::CarrierOnRay on_ray(scene_->carriers[c], ray, monomials);
    if (sweep && on_ray.contains_ray()) {
      start.point = [](int) { return std::nullopt; };
    } else if (on_ray.sign_at(t) == 0) {
      start.carriers.push_back(c);
    }
  }
  return start;
}

surface::EnclosedSweep::Start SpawnedEvents::sweep_start(surface::CarrierIndex carrier) const {
  surface::EnclosedSweep::Start start{
      std::binary_search(start_.carriers.begin(), start_.carriers.end(), carrier), {}};
  for (const ExactStart::SweepCurve& at : start_.curves) {
    if (at.carrier == carrier) {
      start.curves.push_back(at.curve);
    }
  }
  return start;
}

std::optional<SpawnedEvents::CarrierRoots> SpawnedEvents::roots_of(
    surface::CarrierIndex carrier, const EnclosedPoint& origin,
    surface::EnclosedRayMonomials& ray) const {
  if (const auto& sweep = (*sweeps_)[carrier]) {
    return sweep->crossings(origin, direction_, sweep_start(carrier));
  }
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
  CarrierRoots result{*sign, {}};
  for (poly::IsolatedRoot& root : *roots) {
    result.crossings.push_back({std::move(root), {}});
  }
  return result;
}

std::optional<poly::IsolatedRoot> SpawnedEvents::root_of(std::size_t cls,
                                                         const EnclosedPoint& origin) const {
  const SpawnedClass& at = classes_[cls];
  if (const auto& sweep = (*sweeps_)[at.carrier]) {
    return sweep->root_at(places_[cls], origin, direction_, sweep_start(at.carrier));
  }
  surface::EnclosedRayMonomials ray(origin, direction_);
  auto found = roots_of(at.carrier, origin, ray);
  return found ? std::optional(std::move(found->crossings[at.root].root)) : std::nullopt;
}

bool SpawnedEvents::find_with(int bits) {
  const auto origin = start_.point(bits);
  if (!origin) {
    return false;
  }
  surface::EnclosedRayMonomials ray(*origin, direction_);
  classes_.clear();
  places_.clear();
  starts_inside_.assign(scene_->leaves.size(), 0);
  struct Found {
    SpawnedClass cls;
    surface::EnclosedSweep::Crossing crossing;
  };
  std::vector<Found> found;
  for (surface::CarrierIndex c = 0; c < scene_->carriers.size(); ++c) {
    auto of_carrier = roots_of(c, *origin, ray);
    if (!of_carrier) {
      return false;
    }
    for (const csg::LeafIndex leaf : scene_->leaves_of_carrier[c]) {
      starts_inside_[leaf] = scene_->leaves[leaf].side * of_carrier->sign < 0 ? 1 : 0;
    }
    for (std::size_t i = 0; i < of_carrier->crossings.size(); ++i) {
      found.push_back({{c, i, 0}, std::move(of_carrier->crossings[i])});
    }
  }
  if (!poly::sort_by_root(found,
                          [](Found& item) -> poly::IsolatedRoot& { return item.crossing.root; })) {
    return false;
  }
  for (auto& [cls, crossing] : found) {
    constexpr int kBitsOfDouble = 60;
    const auto bounds = enclosure(crossing.root, kBitsOfDouble);
    if (!bounds) {
      return false;
    }
    cls.s = number::nearest_double(Rational((bounds->lower + bounds->upper) / 2));
    classes_.push_back(cls);
    places_.push_back(crossing.place);
  }
  return true;
}

bool SpawnedEvents::find(const ExactStart& start, const ExactPoint& direction) {
  start_ = start;
  direction_ = direction;
  classes_.clear();
  for (int bits = kFirstBits; is_decidable_ && bits <= kMaxBits; bits *= 2) {
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
  if (scene_->carriers[at.carrier].sweep) {
    next.curves = {{at.carrier, places_[cls].curve}};
  }
  // A copy answers: this object goes on to other rays. Deeper rays ask again, for more bits.
  struct Known {
    SpawnedEvents events;
    int bits = 0;
    std::optional<EnclosedPoint> point;
  };
  next.point = [known = std::make_shared<Known>(Known{*this, 0, std::nullopt}),
                cls](int bits) -> std::optional<EnclosedPoint> {
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
      auto root = events.root_of(cls, *origin);
      if (!root) {
        continue;
      }
      if (const auto s = enclosure(std::move(*root), bits)) {
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
