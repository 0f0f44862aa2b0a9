// Laws of a solid and the same solid once more, in the truth.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "geometry/ray_text.hpp"
#include "support/class_tally.hpp"
#include "support/law_models.hpp"

namespace lamina::support {

/// Fails, with the ray and both scenes, unless they have the same media along it.
inline void require_equal(const MediaAlongRay& a, const MediaAlongRay& b,
                          const geometry::ExactRay& ray, const TruthBench& first,
                          const TruthBench& second) {
  if (!(a == b)) {
    FAIL("ray \"" << geometry::to_text(ray) << "\": " << a << " is not " << b << "\nin\n"
                  << first.text() << "and\n"
                  << second.text());
  }
}

/// A solid added to itself is itself, and less itself nothing, and `regularized` gets it right. To
/// be counted: "crossed", and "other carrier" where it is not known to be the same surface.
///
/// Arguments: other    the same solid, as it is written the second time.
///            any_ray  is called for each ray; those along a surface are left out.
template <typename AnyRay>
void check_with_itself(const std::string& solid, const std::string& other, int rays,
                       const AnyRay& any_ray, ClassTally& reached) {
  TruthBench plain(solid);
  TruthBench sum(node_text("add", {solid, other}));
  TruthBench difference(node_text("difference", {solid, other}));
  for (int i = 0; i < rays; ++i) {
    const geometry::ExactRay ray = any_ray();
    const MediaAlongRay media = plain.media(ray);
    if (plain.truth().in_some_carrier()) {
      continue;
    }
    require_equal(sum.media(ray), media, ray, sum, plain);
    require_equal(difference.media(ray), {}, ray, difference, plain);
    CHECK(sum.verdict(method::regularized()).right());
    CHECK(difference.verdict(method::regularized()).right());
    reached.add("crossed", !media.changes.empty());
    reached.add("other carrier", !media.changes.empty() &&
                                     sum.scene().carriers.size() > plain.scene().carriers.size());
  }
}

}  // namespace lamina::support
