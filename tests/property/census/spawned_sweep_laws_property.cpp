// The truth of rays spawned at a swept polygon is that at the half-spaces or cones that it looks
// like, interface for interface: their roots share no code with a sweep's.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "census/path_truth.hpp"
#include "geometry/ray_text.hpp"
#include "support/class_tally.hpp"
#include "support/sweep_models.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using census::PathClass;
using census::PathTruth;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using surface::Sweep;
using Vector = geometry::Vector3<double>;

constexpr std::uint64_t kSeed = 5;

struct Solid {
  explicit Solid(const std::string& spelling)
      : text(spelling), scene(scene::parse_scene(spelling, "scene")), truth(scene) {}

  // Of the present ray.
  [[nodiscard]] std::vector<PathClass> interfaces() const {
    std::vector<PathClass> result;
    for (const PathClass& cls : truth.classes()) {
      if (cls.is_interface()) {
        result.push_back(cls);
      }
    }
    return result;
  }

  std::string text;
  scene::Scene scene;
  PathTruth truth;
};

// What differs, or nothing.
std::string difference(const Solid& a, const Solid& b) {
  if (a.truth.start_medium() != b.truth.start_medium()) {
    return "the start";
  }
  const auto of_a = a.interfaces();
  const auto of_b = b.interfaces();
  if (of_a.size() != of_b.size()) {
    return fmt::format("{} interfaces, {} in the other", of_a.size(), of_b.size());
  }
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    // Each is within 2^-60 max(1, s) of the root, and rounded to 53 bits.
    if (of_a[i].effect.transition != of_b[i].effect.transition ||
        std::abs(of_a[i].s - of_b[i].s) > std::ldexp(std::max(1.0, of_a[i].s), -51)) {
      return fmt::format("interface {}", i);
    }
  }
  return "";
}

enum class Way : std::uint8_t { Reflected, On, Any, Level, Upright };

// Of the surface of the first interface, about where it is; of a plane exactly.
ExactPoint normal_near(const Solid& solid, const Vector& at) {
  const csg::LeafIndex leaf = solid.truth.first()->effect.owners.front();
  const surface::Carrier& carrier = solid.scene.carriers[solid.scene.leaves[leaf].carrier];
  return gradient_at(carrier, {Rational(at.x), Rational(at.y), Rational(at.z)});
}

ExactPoint reflected(const ExactPoint& direction, const ExactPoint& normal) {
  const Vector d = nearest_double(direction);
  const Vector n = normalised(nearest_double(normal));
  const Vector out = d - (2 * dot(d, n)) * n;
  return {Rational(out.x), Rational(out.y), Rational(out.z)};
}

support::ClassTally new_tally() {
  return {"spawned",   "reflected",        "on",          "any",
          "level",     "upright",          "crossed",     "twice",
          "undecided", "stated undecided", "in a surface"};
}

// Spawns the same rays in both, up to three times one from the other.
void walk(SeededStream& stream, Solid& swept, Solid& stated, const ExactRay& ray,
          support::ClassTally& tally) {
  swept.truth.start(ray);
  stated.truth.start(ray);
  if (swept.truth.in_some_carrier() || stated.truth.in_some_carrier()) {
    tally.add("in a surface");
    return;
  }
  Vector at = nearest_double(ray.origin);
  ExactPoint direction = ray.direction;
  std::string ways;
  for (int depth = 0; depth < 4; ++depth) {
    if (const std::string what = difference(swept, stated); !what.empty()) {
      FAIL(what << ", ray \"" << geometry::to_text(ray) << "\", then" << ways << "\nin\n"
                << swept.text << "and\n"
                << stated.text);
    }
    tally.add("twice", depth > 1);
    const PathClass* first = stated.truth.first();
    tally.add("crossed", depth > 0 && first != nullptr);
    if (first == nullptr) {
      return;
    }
    at = at + first->s * nearest_double(direction);
    const auto any = [&stream] { return Rational(stream.uniform(-1, 1)); };
    const ExactPoint normal = normal_near(stated, at);
    auto way = static_cast<Way>(stream.chance(0.5) ? 0 : stream.below(5));
    switch (way) {
      case Way::Reflected:
        direction = reflected(direction, normal);
        break;
      case Way::On:
        break;
      case Way::Any:
        direction = {any(), any(), any()};
        break;
      case Way::Level:
        direction = {any(), any(), 0};
        break;
      case Way::Upright:
        direction = {0, 0, stream.chance(0.5) ? 1 : -1};
        break;
    }
    // By convention a ray in a surface is outside of that leaf, which is one of many in one scene
    // and the whole side in the other.
    if (dot(direction, normal).is_zero()) {
      way = Way::Any;
      direction = {any(), any(), any()};
    }
    ways += fmt::format(" ({}, {}, {})", number::to_text(direction.x), number::to_text(direction.y),
                        number::to_text(direction.z));
    const bool is_swept_decided = swept.truth.spawn(direction);
    const bool is_stated_decided = stated.truth.spawn(direction);
    if (!is_stated_decided) {
      tally.add("stated undecided");
      return;
    }
    if (!is_swept_decided) {
      tally.add("undecided");
      return;
    }
    tally.add("spawned");
    constexpr std::array kNames{"reflected", "on", "any", "level", "upright"};
    tally.add(kNames.at(static_cast<std::size_t>(way)));
  }
}

void require_classes(const support::ClassTally& tally) {
  CHECK(tally.count("reflected") >= 1000);
  for (const char* reached : {"on", "any", "level", "upright"}) {
    CHECK(tally.count(reached) >= 50);
  }
  CHECK(tally.count("crossed") >= 500);
  CHECK(tally.count("twice") >= 300);
  // Rays that go on through an edge, or to the axis.
  CHECK(tally.count("undecided") * 100 <= tally.count("spawned"));
}

TEST_CASE("Rays spawned at a polygon's sweep meet what they do at its half-spaces", "[laws]") {
  constexpr std::uint64_t kSolids = 110;
  constexpr int kRays = 40;
  const Sweep sweep = support::kSweeps[GENERATE(range(0, 3))];
  const bool turned = sweep == Sweep::Rotational;
  support::ClassTally tally = new_tally();
  for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
    SeededStream stream("spawned-sweep-laws/half-spaces", kSeed,
                        static_cast<std::uint64_t>(sweep) * 1000 + solid);
    const PlanePoint centre{support::any_coordinate(stream), support::any_coordinate(stream)};
    const std::vector<PlanePoint> points =
        turned ? support::any_profile(stream) : support::any_star(stream, centre);
    Solid swept(support::sweep_text(sweep, points, geometry::ContourKind::Line, !turned));
    Solid stated(turned ? support::in_cones(points) : support::in_triangles(sweep, centre, points));
    for (int i = 0; i < kRays; ++i) {
      walk(stream, swept, stated, support::any_ray(stream, sweep, points), tally);
    }
  }
  INFO(name_of(sweep) << ": " << tally);
  require_classes(tally);
}

// Flat rings and upright walls: a closed rectangle, turned, is a tube, or from the axis a cylinder.
TEST_CASE("Rays spawned at a turned rectangle meet what they do at cylinders", "[laws]") {
  constexpr std::uint64_t kSolids = 60;
  constexpr int kRays = 40;
  support::ClassTally tally = new_tally();
  for (std::uint64_t solid = 0; solid < kSolids; ++solid) {
    SeededStream stream("spawned-sweep-laws/rectangles", kSeed, solid);
    const bool is_tube = stream.chance(0.5);
    const Rational inner = is_tube ? support::any_dyadic(stream, 0.25, 1) : Rational(0);
    const Rational outer = inner + support::any_dyadic(stream, 0.25, 1);
    const Rational bottom = support::any_dyadic(stream, -1, 0);
    const Rational height = support::any_dyadic(stream, 0.5, 2);
    const std::vector<PlanePoint> points{
        {inner, bottom}, {outer, bottom}, {outer, bottom + height}, {inner, bottom + height}};
    const auto cylinder = [&](const Rational& radius) {
      return fmt::format("cylinder(h={}, r={});", number::to_text(height), number::to_text(radius));
    };
    Solid swept(support::sweep_text(Sweep::Rotational, points, geometry::ContourKind::Line, true));
    Solid stated(fmt::format("translate([0, 0, {}]) difference() {{ {} {} }}\n",
                             number::to_text(bottom), cylinder(outer),
                             is_tube ? cylinder(inner) : ""));
    for (int i = 0; i < kRays; ++i) {
      walk(stream, swept, stated, support::any_ray(stream, Sweep::Rotational, points), tally);
    }
  }
  INFO(tally);
  require_classes(tally);
}

}  // namespace
}  // namespace lamina
