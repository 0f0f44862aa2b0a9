#include <algorithm>

#include "method/ray_events.hpp"

namespace lamina::method {

using number::exact;
using number::Rational;
using number::Root;

void RayEvents<exact>::find(const geometry::ExactRay& ray) {
  surface::RayMonomials monomials(ray);
  crossings_.clear();
  carriers_.clear();
  starts_inside_.assign(scene_->leaves.size(), 0);
  in_carrier_.assign(scene_->leaves.size(), 0);
  for (std::size_t c = 0; c < scene_->carriers.size(); ++c) {
    const surface::CarrierOnRay& carrier =
        carriers_.emplace_back(scene_->carriers[c], ray, monomials);
    if (carrier.contains_ray()) {
      for (const csg::LeafIndex leaf : scene_->leaves_of_carrier[c]) {
        in_carrier_[leaf] = 1;
      }
      continue;
    }
    const std::vector<Root> roots = carrier.crossings();
    for (const csg::LeafIndex leaf : scene_->leaves_of_carrier[c]) {
      bool inside = scene_->leaves[leaf].side * carrier.sign_at_minus_infinity() < 0;
      starts_inside_[leaf] = inside ? 1 : 0;
      for (std::size_t i = 0; i < roots.size(); ++i) {
        inside = !inside;
        crossings_.push_back({roots[i], leaf, static_cast<std::uint16_t>(i), inside, inside});
      }
    }
  }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing<exact>& a, const Crossing<exact>& b) {
              const auto order = compare(a.t, b.t);
              return order < 0 || (order == 0 && a.leaf < b.leaf);
            });
}

void RayEvents<exact>::reorder(std::span<const csg::LeafIndex> rank) {
  // Only runs of equal t change: no root is compared with one of another run again.
  for (auto first = crossings_.begin(); first != crossings_.end();) {
    const auto end = std::find_if(first + 1, crossings_.end(),
                                  [first](const auto& later) { return less(first->t, later.t); });
    std::sort(first, end,
              [rank](const auto& a, const auto& b) { return rank[a.leaf] < rank[b.leaf]; });
    first = end;
  }
}

bool RayEvents<exact>::starts_inside(csg::LeafIndex leaf, const Rational& reference) const {
  if (reference.is_zero() || in_carrier_[leaf] != 0) {
    return starts_inside(leaf);
  }
  const auto first = std::find_if(crossings_.begin(), crossings_.end(),
                                  [leaf](const auto& c) { return c.leaf == leaf; });
  return inside_at(leaf, first == crossings_.end() ? Root(Rational(-reference))
                                                   : affine_image(first->t, 1, -reference));
}

bool RayEvents<exact>::inside_at(csg::LeafIndex leaf, const Root& t) const {
  const scene::Leaf& l = scene_->leaves[leaf];
  if (in_carrier_[leaf] != 0 && scene_->carriers[l.carrier].sweep) {
    return false;  // it runs along a part of the sweep only, and by convention is outside
  }
  return l.side * carriers_[l.carrier].sign_at(t) <= 0;
}

bool RayEvents<exact>::within(const Root& first, const Root& later, const Rational& step,
                              bool relative) {
  if (step.is_zero()) {
    return compare(later, first) <= 0;
  }
  // The enclosures decide unless the gap is within rounding of the step.
  const Rational lower(first.lower());
  const Rational upper(first.upper());
  const bool straddles = lower.sign() < 0 && upper.sign() > 0;
  const Rational low =
      straddles ? Rational(0) : std::min(Rational(abs(lower)), Rational(abs(upper)));
  const Rational high = std::max(Rational(abs(lower)), Rational(abs(upper)));
  if (Rational(later.upper()) - lower <= (relative ? Rational(step * low) : step)) {
    return true;
  }
  if (Rational(later.lower()) - upper > (relative ? Rational(step * high) : step)) {
    return false;
  }
  if (!relative) {
    return compare(later, affine_image(first, 1, step)) <= 0;
  }
  // first + step |first|; a relative step is below 1, so the factor is positive.
  const bool negative = compare(first, Rational(0)) < 0;
  return compare(later,
                 affine_image(first, negative ? Rational(1 - step) : Rational(1 + step), 0)) <= 0;
}

}  // namespace lamina::method
