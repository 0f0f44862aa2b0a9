#include "experiments/printed-formulas/capped_sweep.hpp"

#include <algorithm>
#include <array>

#include "surface/parity_trimming.hpp"

namespace lamina::experiments {

using number::Rational;
using surface::SweptSurface;

std::optional<std::vector<SolidCrossing>> solid_crossings(const SweptSurface& surface,
                                                          const geometry::ExactRay& local) {
  const Rational& o_z = local.origin.z;
  const Rational& d_z = local.direction.z;
  const bool capped = surface.sweep() != surface::Sweep::Rotational;
  const SweptSurface::Crossings sides = surface.crossings(local);
  if (sides.in_boundary || (capped && d_z == 0 && (o_z == 0 || o_z == 1))) {
    return std::nullopt;
  }
  std::vector<SolidCrossing> all;
  for (const SweptSurface::Crossing& side : sides.crossings) {
    all.push_back({side.t, side.piece});
  }
  if (!capped) {
    return all;
  }
  // Of the surface, of z >= 0 and of z <= 1, for t towards -infinity.
  std::array inside{sides.starts_inside, d_z == 0 ? o_z > 0 : d_z < 0,
                    d_z == 0 ? o_z < 1 : d_z > 0};
  if (d_z != 0) {
    all.push_back({number::Root(Rational(-o_z / d_z)), surface::kBasePlane});
    all.push_back({number::Root(Rational((1 - o_z) / d_z)), surface::kCapPlane});
  }
  std::sort(all.begin(), all.end(), [](const SolidCrossing& a, const SolidCrossing& b) {
    const auto order = compare(a.t, b.t);
    return order < 0 || (order == 0 && a.piece < b.piece);
  });
  const auto in_all = [&inside] { return inside[0] && inside[1] && inside[2]; };
  std::vector<SolidCrossing> of_solid;
  for (auto first = all.begin(); first != all.end();) {
    const bool before = in_all();
    auto end = first;
    for (; end != all.end() && compare(first->t, end->t) == 0; ++end) {
      bool& one = inside[end->piece == surface::kBasePlane  ? 1
                         : end->piece == surface::kCapPlane ? 2
                                                            : 0];
      one = !one;
    }
    if (in_all() != before) {
      of_solid.push_back(*first);
    }
    first = end;
  }
  return of_solid;
}

}  // namespace lamina::experiments
