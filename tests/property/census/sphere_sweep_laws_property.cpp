// Laws of sphere sweeps in the truth: along a polygon they are balls and cylinders, and a sweep
// coincides with itself, however it is written.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "support/class_tally.hpp"
#include "support/itself_laws.hpp"
#include "support/random_trajectories.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using number::Rational;
using number::to_text;
using support::MediaAlongRay;
using support::TruthBench;

constexpr std::uint64_t kSeed = 7;

std::string text_of(const ExactPoint& p) {
  return fmt::format("[{}, {}, {}]", to_text(p.x), to_text(p.y), to_text(p.z));
}

std::string sweep_text(const Rational& radius, const std::vector<ExactPoint>& points,
                       ContourKind kind, bool closed) {
  std::vector<std::string> texts;
  for (const ExactPoint& p : points) {
    texts.push_back(text_of(p));
  }
  return fmt::format("sphere_sweep({}) contour([{}], kind=\"{}\", closed={});\n", to_text(radius),
                     fmt::join(texts, ", "), name_of(kind), closed);
}

// A way along the edges of a lattice, each at right angles to the one before it.
std::vector<ExactPoint> any_lattice_way(SeededStream& stream) {
  std::vector<ExactPoint> points{{0, 0, 0}};
  std::uint64_t axis = stream.below(3);
  const std::int64_t edges = stream.integer(1, 5);
  for (std::int64_t i = 0; i < edges; ++i) {
    const Rational step = Rational(stream.integer(1, 3)) * (stream.chance(0.5) ? 1 : -1);
    ExactPoint next = points.back();
    (axis == 0 ? next.x : axis == 1 ? next.y : next.z) += step;
    points.push_back(next);
    axis = (axis + 1 + stream.below(2)) % 3;
  }
  return points;
}

std::string in_balls_and_cylinders(const Rational& radius, const std::vector<ExactPoint>& points) {
  std::string text = "add() {\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("translate({}) sphere({});\n", text_of(points[i]), to_text(radius));
    if (i == 0) {
      continue;
    }
    const ExactPoint d = points[i] - points[i - 1];
    const Rational length = abs(Rational(d.x + d.y + d.z));
    // The z axis to that of the edge, by quarters of a turn, which are exact.
    const std::string turn = d.x != 0   ? "rotate(quaternion=[1, 0, 1, 0]) "
                             : d.y != 0 ? "rotate(quaternion=[1, 1, 0, 0]) "
                                        : "";
    text += fmt::format("translate({}) {}cylinder(h={}, r={}, center=true);\n",
                        text_of(Rational(1, 2) * (points[i] + points[i - 1])), turn,
                        to_text(length), to_text(radius));
  }
  return text + "}\n";
}

Rational any(SeededStream& stream) { return support::any_dyadic(stream, -2, 2); }

// At a point of the trajectory, or a quarter of the radius or the radius beside it; some along an
// axis.
ExactRay any_ray(SeededStream& stream, const std::vector<ExactPoint>& points,
                 const Rational& radius) {
  const std::size_t i = stream.below(points.size());
  const ExactPoint& p = points[i];
  const ExactPoint& q = points[(i + 1) % points.size()];
  ExactPoint target = p + Rational(stream.integer(0, 2), 2) * (q - p);
  const Rational off = radius * Rational(stream.integer(-4, 4), 4);
  const std::uint64_t axis = stream.below(3);
  (axis == 0 ? target.x : axis == 1 ? target.y : target.z) += off;
  ExactPoint direction{any(stream), any(stream), any(stream)};
  if (stream.chance(0.4)) {
    const std::uint64_t along = stream.below(3);
    direction = {along == 0 ? 1 : 0, along == 1 ? 1 : 0, along == 2 ? 1 : 0};
  }
  if (direction == ExactPoint{}) {
    direction.x = 1;
  }
  return {target - Rational(stream.integer(1, 4)) * direction, direction};
}

TEST_CASE("A ball along a polygon is balls and cylinders, interface for interface", "[laws]") {
  constexpr std::uint64_t kSolids = 40;
  constexpr int kRays = 20;
  support::ClassTally reached({"crossed", "crossed often", "in a surface"});
  for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
    SeededStream stream("sphere-sweep-laws/balls-and-cylinders", kSeed, solid);
    const std::vector<ExactPoint> points = any_lattice_way(stream);
    const Rational radius(stream.integer(1, 6), 4);
    const std::string turn =
        fmt::format("rotate(quaternion=[{}, {}, {}, {}]) ", stream.integer(1, 4),
                    stream.integer(-3, 3), stream.integer(-3, 3), stream.integer(-3, 3));
    TruthBench swept(turn + sweep_text(radius, points, ContourKind::Line, false));
    TruthBench stated(turn + in_balls_and_cylinders(radius, points));
    const geometry::AffineMap to_world =
        inverse(swept.scene().frames[swept.scene().leaves.front().frame]).value();
    for (int i = 0; i < kRays; ++i) {
      const ExactRay local = any_ray(stream, points, radius);
      const ExactRay ray{apply(to_world, local.origin),
                         apply_to_direction(to_world, local.direction)};
      const MediaAlongRay expected = stated.media(ray);
      const MediaAlongRay actual = swept.media(ray);
      // By convention such a ray is outside of that leaf, which is one of many in one scene.
      if (swept.truth().in_some_carrier() || stated.truth().in_some_carrier()) {
        reached.add("in a surface");
        continue;
      }
      support::require_equal(actual, expected, ray, swept, stated);
      CHECK(swept.verdict(method::regularized()).right());
      reached.add("crossed", !expected.changes.empty());
      reached.add("crossed often", expected.changes.size() > 2);
    }
  }
  INFO(reached);
  CHECK(reached.count("crossed") >= kSolids * kRays / 4);
  CHECK(reached.count("crossed often") >= kSolids * kRays / 40);
  CHECK(reached.count("in a surface") >= 5);
}

TEST_CASE("A sphere sweep and itself, as written or as its mirror image's mirror image", "[laws]") {
  constexpr std::uint64_t kSolids = 3;
  constexpr int kRays = 10;
  support::ClassTally reached({"crossed", "other carrier"});
  for (const ContourKind kind : support::kKinds) {
    for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
      SeededStream stream("sphere-sweep-laws/itself", kSeed,
                          static_cast<std::uint64_t>(kind) * 100 + solid);
      const auto trajectory = support::any_trajectory(stream, kind);
      const Rational radius(stream.integer(1, 6), 8);
      const std::string text = sweep_text(radius, trajectory->points(), kind, trajectory->closed());
      std::vector<ExactPoint> mirrored = trajectory->points();
      for (ExactPoint& p : mirrored) {
        p.x = -p.x;
      }
      const std::string again =
          "mirror([1, 0, 0]) " + sweep_text(radius, mirrored, kind, trajectory->closed());
      for (const std::string& other : {text, again}) {
        support::check_with_itself(
            text, other, kRays, [&] { return any_ray(stream, trajectory->points(), radius); },
            reached);
      }
    }
  }
  INFO(reached);
  CHECK(reached.count("crossed") >= 60);
  CHECK(reached.count("other carrier") >= 30);
}

// With planes and balls that cut it, or touch it: what is regularized is the truth.
TEST_CASE("Scenes with sphere sweeps, regularized, show no artifact", "[laws]") {
  constexpr std::uint64_t kScenes = 12;
  constexpr int kRays = 8;
  std::uint64_t interfaces = 0;
  for (std::uint64_t scene = 0; scene < kScenes; ++scene) {
    SeededStream stream("sphere-sweep-laws/scenes", kSeed, scene);
    const auto trajectory =
        support::any_trajectory(stream, support::kKinds.at(scene % support::kKinds.size()));
    const Rational radius(stream.integer(2, 6), 8);
    const std::string swept =
        sweep_text(radius, trajectory->points(), trajectory->kind(), trajectory->closed());
    const std::string ball = fmt::format("translate({}) sphere({});\n",
                                         text_of(trajectory->points().front()), to_text(radius));
    TruthBench bench(support::node_text(
        stream.chance(0.5) ? "difference" : "add",
        {"material(\"a\") " + swept, "material(\"b\") " + ball,
         fmt::format("material(\"c\") halfspace([0, 0, 1], {});\n", to_text(any(stream))),
         "material(\"d\") translate([1/8, 0, 0]) " + swept}));
    for (int i = 0; i < kRays; ++i) {
      bench.find(any_ray(stream, trajectory->points(), radius));
      CHECK(bench.verdict(method::regularized()).right());
      interfaces += bench.media().changes.size();
    }
  }
  CHECK(interfaces >= kScenes * kRays);
}

}  // namespace
}  // namespace lamina
