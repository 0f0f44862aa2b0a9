// Laws of swept contours in the truth: a polygon's sweep is the solid of half-spaces that it looks
// like, and a sweep coincides with itself, however it is written.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "geometry/ray_text.hpp"
#include "support/class_tally.hpp"
#include "support/law_models.hpp"
#include "support/random_sweeps.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using number::to_text;
using support::MediaAlongRay;
using support::TruthBench;
using surface::Sweep;

constexpr std::uint64_t kSeed = 7;

std::string text_of(const std::vector<PlanePoint>& points) {
  std::vector<std::string> pairs;
  for (const PlanePoint& p : points) {
    pairs.push_back(fmt::format("[{}, {}]", to_text(p.u), to_text(p.v)));
  }
  return fmt::format("[{}]", fmt::join(pairs, ", "));
}

std::string sweep_text(Sweep sweep, const std::vector<PlanePoint>& points,
                       geometry::ContourKind kind, bool closed) {
  return fmt::format("{}() contour({}, kind=\"{}\", closed={});\n", name_of(sweep), text_of(points),
                     name_of(kind), closed);
}

// n.p <= offset.
std::string plane(const ExactPoint& n, const Rational& offset) {
  return fmt::format("halfspace([{}, {}, {}], {});\n", to_text(n.x), to_text(n.y), to_text(n.z),
                     to_text(offset));
}

// The triangles from a centre to the sides of a polygon that goes around it counterclockwise, each
// swept: three planes, and what caps the sweep.
std::string in_triangles(Sweep sweep, const PlanePoint& centre,
                         const std::vector<PlanePoint>& points) {
  std::string text = "add() {\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlanePoint& a = points[i];
    const PlanePoint& b = points[(i + 1) % points.size()];
    text += "intersection() {\n" + plane({0, 0, -1}, 0) + plane({0, 0, 1}, 1);
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, centre), std::pair(centre, a)}) {
      const ExactPoint outward{q.v - p.v, p.u - q.u, 0};
      const Rational offset = outward.x * p.u + outward.y * p.v;
      text += sweep == Sweep::Translational ? plane(outward, offset)
                                            : plane({outward.x, outward.y, -offset}, 0);
    }
    text += "}\n";
  }
  return text + "}\n";
}

// The truncated cones of a profile's sides.
std::string in_cones(const std::vector<PlanePoint>& profile) {
  std::string text = "add() {\n";
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const PlanePoint& a = profile[i];
    const PlanePoint& b = profile[i + 1];
    text += fmt::format("translate([0, 0, {}]) cylinder(h={}, r1={}, r2={});\n", to_text(a.v),
                        to_text(b.v - a.v), to_text(a.u), to_text(b.u));
  }
  return text + "}\n";
}

Rational any(SeededStream& stream) { return support::any_dyadic(stream, -2, 2); }

// Through a point of the contour, where the sweep has it, or not; some along an axis, some level.
ExactRay any_ray(SeededStream& stream, Sweep sweep, const std::vector<PlanePoint>& points) {
  ExactPoint target{any(stream), any(stream), any(stream)};
  if (stream.chance(0.5)) {
    const auto i = static_cast<std::size_t>(stream.below(points.size()));
    const PlanePoint& p = points[i];
    const PlanePoint& q = points[(i + 1) % points.size()];
    const Rational s(stream.integer(0, 2), 2);  // a vertex, or the middle of a side
    const PlanePoint at{p.u + s * (q.u - p.u), p.v + s * (q.v - p.v)};
    const Rational z(stream.integer(-1, 5), 4);
    target = sweep == Sweep::Translational ? ExactPoint{at.u, at.v, z}
             : sweep == Sweep::Conic       ? ExactPoint{at.u * z, at.v * z, z}
                                           : ExactPoint{at.u, 0, at.v};
  }
  ExactPoint direction{any(stream), any(stream), any(stream)};
  if (stream.chance(0.1)) {
    direction.z = 0;
  } else if (stream.chance(0.1)) {
    direction = {0, 0, 1};
  }
  if (direction == ExactPoint{}) {
    direction.x = 1;
  }
  return {target - Rational(stream.integer(1, 4)) * direction, direction};
}

bool is_coincident(const TruthBench& bench) {
  const auto& classes = bench.truth().classes();
  return std::any_of(classes.begin(), classes.end(),
                     [](const auto& cls) { return cls.leaves.size() > 1; });
}

void require_equal(const MediaAlongRay& a, const MediaAlongRay& b, const ExactRay& ray,
                   const TruthBench& first, const TruthBench& second) {
  if (!(a == b)) {
    FAIL("ray \"" << geometry::to_text(ray) << "\": " << a << " is not " << b << "\nin\n"
                  << first.text() << "and\n"
                  << second.text());
  }
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
      const PlanePoint centre{any(stream), any(stream)};
      const std::vector<PlanePoint> points =
          turned ? support::any_profile(stream) : support::any_star(stream, centre);
      TruthBench swept(sweep_text(sweep, points, geometry::ContourKind::Line, !turned));
      TruthBench stated(turned ? in_cones(points) : in_triangles(sweep, centre, points));
      for (int i = 0; i < kRays; ++i) {
        const ExactRay ray = any_ray(stream, sweep, points);
        const MediaAlongRay expected = stated.media(ray);
        const MediaAlongRay actual = swept.media(ray);
        // By convention such a ray is outside of that leaf, which is one of many in one scene and
        // the whole side in the other.
        if (swept.truth().in_some_carrier() || stated.truth().in_some_carrier()) {
          reached.add("in a surface");
          continue;
        }
        require_equal(actual, expected, ray, swept, stated);
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
std::string mirrored(Sweep sweep, std::vector<PlanePoint> points, geometry::ContourKind kind,
                     bool closed) {
  const bool turned = sweep == Sweep::Rotational;
  for (PlanePoint& p : points) {
    (turned ? p.v : p.u) *= -1;
  }
  return (turned ? "mirror([0, 0, 1]) " : "mirror([1, 0, 0]) ") +
         sweep_text(sweep, points, kind, closed);
}

TEST_CASE("A sweep and itself, as written or as its mirror image's mirror image", "[laws]") {
  constexpr std::uint64_t kSolids = 4;
  constexpr int kRays = 15;
  for (const Sweep sweep : support::kSweeps) {
    support::ClassTally reached({"crossed", "other carrier"});
    for (const geometry::ContourKind kind : support::kKinds) {
      for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
        SeededStream stream("sweep-laws/itself", kSeed,
                            static_cast<std::uint64_t>(sweep) * 1000 +
                                static_cast<std::uint64_t>(kind) * 100 + solid);
        std::optional<surface::SweptSurface> surface;
        while (!surface) {
          surface = support::any_swept_surface(stream, sweep, kind);
        }
        const std::vector<PlanePoint>& points = surface->contour().points();
        const bool closed = surface->contour().closed();
        const std::string text = sweep_text(sweep, points, kind, closed);
        TruthBench plain(text);
        for (const std::string& other : {text, mirrored(sweep, points, kind, closed)}) {
          TruthBench sum(support::node_text("add", {text, other}));
          TruthBench difference(support::node_text("difference", {text, other}));
          for (int i = 0; i < kRays; ++i) {
            const ExactRay ray = any_ray(stream, sweep, points);
            const MediaAlongRay media = plain.media(ray);
            if (plain.truth().in_some_carrier()) {
              continue;
            }
            require_equal(sum.media(ray), media, ray, sum, plain);
            require_equal(difference.media(ray), {}, ray, difference, plain);
            CHECK(sum.verdict(method::regularized()).right());
            CHECK(difference.verdict(method::regularized()).right());
            reached.add("crossed", !media.changes.empty());
            reached.add("other carrier",
                        !media.changes.empty() &&
                            sum.scene().carriers.size() > plain.scene().carriers.size());
          }
        }
      }
    }
    INFO(name_of(sweep) << ": " << reached);
    CHECK(reached.count("crossed") >= 60);
    CHECK(reached.count("other carrier") >= 30);
  }
}

}  // namespace
}  // namespace lamina
