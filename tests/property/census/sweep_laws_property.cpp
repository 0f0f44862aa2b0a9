// Laws of swept contours in the truth: a polygon's sweep is the solid of half-spaces that it looks
// like, and a sweep coincides with itself, however it is written.
#include <catch2/catch.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/class_tally.hpp"
#include "support/itself_laws.hpp"
#include "support/random_sweeps.hpp"
#include "support/sweep_models.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using support::MediaAlongRay;
using support::TruthBench;
using surface::Sweep;

constexpr std::uint64_t kSeed = 7;

bool is_coincident(const TruthBench& bench) {
  const auto& classes = bench.truth().classes();
  return std::any_of(classes.begin(), classes.end(),
                     [](const auto& cls) { return cls.leaves.size() > 1; });
}

TEST_CASE("A polygon's sweep is its half-spaces, interface for interface", "[laws]") {
  constexpr std::uint64_t kSolids = 60;
  constexpr int kRays = 40;
  for (const Sweep sweep : support::kSweeps) {
    const bool turned = sweep == Sweep::Rotational;
    support::ClassTally reached({"crossed", "coincident", "in a surface"});
    for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
      SeededStream stream("sweep-laws/half-spaces", kSeed,
                          static_cast<std::uint64_t>(sweep) * 1000 + solid);
      const PlanePoint centre{support::any_coordinate(stream), support::any_coordinate(stream)};
      const std::vector<PlanePoint> points =
          turned ? support::any_profile(stream) : support::any_star(stream, centre);
      TruthBench swept(support::sweep_text(sweep, points, geometry::ContourKind::Line, !turned));
      TruthBench stated(turned ? support::in_cones(points)
                               : support::in_triangles(sweep, centre, points));
      for (int i = 0; i < kRays; ++i) {
        const ExactRay ray = support::any_ray(stream, sweep, points);
        const MediaAlongRay expected = stated.media(ray);
        const MediaAlongRay actual = swept.media(ray);
        // By convention such a ray is outside of that leaf, which is one of many in one scene and
        // the whole side in the other.
        if (swept.truth().in_some_carrier() || stated.truth().in_some_carrier()) {
          reached.add("in a surface");
          continue;
        }
        support::require_equal(actual, expected, ray, swept, stated);
        CHECK(swept.verdict(method::regularized()).right());
        reached.add("crossed", !expected.changes.empty());
        reached.add("coincident", is_coincident(stated));
      }
    }
    INFO(name_of(sweep) << ": " << reached);
    CHECK(reached.count("crossed") >= kSolids * kRays / 8);
    CHECK(reached.count("coincident") >= kSolids * kRays / 20);
  }
}

// In the local frame, so that the solid is the same as without.
std::string mirrored(const surface::SweptSurface& sweep) {
  const bool turned = sweep.sweep() == Sweep::Rotational;
  const geometry::Contour& contour = sweep.contour();
  std::vector<PlanePoint> points = contour.points();
  for (PlanePoint& p : points) {
    (turned ? p.v : p.u) *= -1;
  }
  const auto mirror = support::swept_surface(sweep.sweep(), std::move(points), contour.kind(),
                                             contour.closed(), sweep.scaling());
  return (turned ? "mirror([0, 0, 1]) " : "mirror([1, 0, 0]) ") +
         support::sweep_text(mirror.value());
}

TEST_CASE("A sweep and itself, as written or as its mirror image's mirror image", "[laws]") {
  constexpr int kRays = 15;
  for (const Sweep sweep : support::kSweepsOfAllKinds) {
    // A ray at a generalised conic sweep takes ten times as long.
    const std::uint64_t solids = sweep == Sweep::GeneralisedConic ? 1 : 4;
    support::ClassTally reached({"crossed", "other carrier"});
    for (const geometry::ContourKind kind : support::kKinds) {
      for (std::uint64_t solid = 0; solid < solids; ++solid) {
        SeededStream stream("sweep-laws/itself", kSeed,
                            static_cast<std::uint64_t>(sweep) * 1000 +
                                static_cast<std::uint64_t>(kind) * 100 + solid);
        std::optional<surface::SweptSurface> surface;
        while (!surface) {
          surface = support::any_swept_surface(stream, sweep, kind);
        }
        const std::string text = support::sweep_text(*surface);
        for (const std::string& other : {text, mirrored(*surface)}) {
          support::check_with_itself(
              text, other, kRays,
              [&] {
                return support::any_ray(stream, sweep, surface->contour().points(),
                                        surface->scaling());
              },
              reached);
        }
      }
    }
    INFO(name_of(sweep) << ": " << reached);
    CHECK(reached.count("crossed") >= 15 * solids);
    CHECK(reached.count("other carrier") >= 7 * solids);
  }
}

}  // namespace
}  // namespace lamina
