// Rays at sweeps for which the order, the start or the normal hangs on a special case: in rounded
// numbers as they are by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/ray_text.hpp"
#include "method/tracer.hpp"
#include "support/scenes.hpp"

namespace lamina::method {
namespace {

constexpr const char* kL = "contour([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]);";
constexpr const char* kSquare = "contour([[-1, -1], [1, -1], [1, 1], [-1, 1]]);";

struct Seen {
  bool in_carrier = false;
  bool starts_inside = false;
  std::vector<double> t;  // where the medium changes

  friend bool operator==(const Seen&, const Seen&) = default;
};

std::ostream& operator<<(std::ostream& out, const Seen& seen) {
  out << (seen.in_carrier ? "in a carrier" : seen.starts_inside ? "inside" : "outside");
  for (const double t : seen.t) {
    out << ' ' << t;
  }
  return out;
}

template <typename Number>
Seen seen_in(const std::string& text, const std::string& ray) {
  const scene::Scene scene = support::scene_of(text);
  const auto tracer = make_tracer<Number>(scene, {});
  tracer->find(geometry::parse_ray(ray));
  Report report;
  tracer->run(regularized(), report);
  Seen seen{tracer->in_some_carrier(), tracer->starts_inside(regularized(), 0), {}};
  for (const Interface& interface : report.interfaces) {
    seen.t.push_back(tracer->t(interface.crossing));
  }
  return seen;
}

void expect_seen(const std::string& text, const std::string& ray, const Seen& expected) {
  EXPECT_EQ(seen_in<number::exact>(text, ray), expected) << text << ray;
  EXPECT_EQ(seen_in<double>(text, ray), expected) << text << ray;
  EXPECT_EQ(seen_in<float>(text, ray), expected) << text << ray;
}

TEST(SweepEventsTest, APointBesideAFlatSideIsInside) {
  // v = 1 is a side of the L, further right.
  expect_seen(std::string("translational_sweep() ") + kL, "1/2 1 -5 0 0 1", {false, true, {5, 6}});
  expect_seen(std::string("conic_sweep(capped=false) ") + kL, "0 0 1 1/2 1 1", {false, true, {}});
}

TEST(SweepEventsTest, ARayAlongAWallIsOutsideOfIt) {
  expect_seen(std::string("translational_sweep() ") + kSquare, "1 1/2 -5 0 0 1", {true, false, {}});
  expect_seen(std::string("translational_sweep() ") + kSquare, "1 -5 1/2 0 1 0", {true, false, {}});
}

// u = (t - 5) / t is above 1 far behind, comes back from -infinity behind the apex, and is -1 at
// t = 5/2; far ahead it is below 1.
TEST(SweepEventsTest, ARayParallelToARulingStartsWhereItIs) {
  expect_seen(std::string("conic_sweep(capped=false) ") + kSquare, "-5 0 0 1 0 1",
              {false, false, {2.5}});
}

TEST(SweepEventsTest, AFlatTopIsEnteredAndLeftOnItsAxis) {
  const scene::Scene scene =
      support::scene_of("rotational_sweep() contour([[0, 0], [1, 0], [1, 1], [0, 1]]);");
  const auto tracer = make_tracer<double>(scene, {});
  tracer->find(geometry::parse_ray("0 0 5 0 0 -1"));
  Report report;
  tracer->run(parse_method("wyvill-trotman"), report);
  ASSERT_EQ(report.interfaces.size(), 2U);
  EXPECT_EQ(report.interfaces[0].transition.from, csg::kEmpty);
  EXPECT_EQ(report.inconsistent, 0U);
}

TEST(SweepEventsTest, ABallAlongALineIsEnteredAndLeft) {
  const std::string capsule = "sphere_sweep(1) contour([[0, 0, 0], [4, 0, 0]], closed=false);";
  expect_seen(capsule, "-5 0 0 1 0 0", {false, false, {4, 10}});
  expect_seen("difference() {" + capsule + "sphere(1); }", "-5 0 0 1 0 0", {false, false, {6, 10}});
  // Along its wall, and touching it.
  expect_seen(capsule, "-5 0 1 1 0 0", {true, false, {}});
  expect_seen(capsule, "2 -5 1 0 1 0", {false, false, {}});
}

TEST(SweepEventsTest, NumbersBeyondTheRangeBreakNothing) {
  const scene::Scene scene =
      support::scene_of("translational_sweep() contour([[0, 0], [1e39, 0], [0, 1e39]]);");
  const auto tracer = make_tracer<float>(scene, {});
  tracer->find(geometry::parse_ray("1 1 -5 0 0 1"));
  Report report;
  tracer->run(regularized(), report);
}

}  // namespace
}  // namespace lamina::method
