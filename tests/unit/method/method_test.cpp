#include "method/method.hpp"

#include <gtest/gtest.h>

#include "base/contract.hpp"
#include "method/tracer.hpp"
#include "support/scenes.hpp"

namespace lamina::method {
namespace {

using geometry::ExactRay;
using number::Rational;

std::string error_of(const std::string& text) {
  try {
    parse_method(text);
    return "";
  } catch (const base::InputError& error) {
    return error.what();
  }
}

TEST(MethodTest, ReadsAReferenceDistance) {
  EXPECT_EQ(parse_method("wyvill-trotman").reference, 0);
  const Method plain = parse_method("wyvill-trotman:reference:1e6");
  EXPECT_EQ(plain.reference, 1'000'000);
  EXPECT_EQ(plain.name, "wyvill-trotman:reference:1e6");
  EXPECT_EQ(plain.sense, Sense::Normal);
  EXPECT_EQ(plain.look_ahead, LookAhead::Literal);
  const Method parity = parse_method("wyvill-trotman:parity:reference:1/3:no-look-ahead");
  EXPECT_EQ(parity.reference, Rational(1, 3));
  EXPECT_EQ(parity.sense, Sense::Parity);
  EXPECT_EQ(parity.look_ahead, LookAhead::None);
}

TEST(MethodTest, ReadsWhatSpawnedRaysTakeOver) {
  EXPECT_EQ(parse_method("regularized").secondary, Secondary::Parity);
  EXPECT_EQ(parse_method("wyvill-trotman").secondary, Secondary::Inherit);
  EXPECT_FALSE(parse_method("wyvill-trotman").keeps_hit_leaf);
  const Method all = parse_method("wyvill-trotman:look-ahead-all:secondary:hybrid:keeps-hit-leaf");
  EXPECT_EQ(all.look_ahead, LookAhead::All);
  EXPECT_EQ(parse_method("wyvill-trotman:look-ahead-class").look_ahead, LookAhead::Class);
  EXPECT_EQ(all.secondary, Secondary::Hybrid);
  EXPECT_TRUE(all.keeps_hit_leaf);
  EXPECT_EQ(parse_method("wyvill-trotman:secondary:cluster").secondary, Secondary::Cluster);
  for (const char* text : {"wyvill-trotman:secondary", "wyvill-trotman:secondary:none",
                           "regularized:secondary:cluster", "roth:keeps-hit-leaf"}) {
    EXPECT_NE(error_of(text).find("\n  wyvill-trotman:secondary:S"), std::string::npos) << text;
  }
}

TEST(MethodTest, RefusesAReferenceThatIsNone) {
  for (const char* text :
       {"wyvill-trotman:reference", "wyvill-trotman:reference:0", "wyvill-trotman:reference:-1"}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("state the reference point's distance"), std::string::npos) << error;
    EXPECT_NE(error.find("\n  wyvill-trotman:reference:D"), std::string::npos) << error;
  }
  EXPECT_NE(error_of("wyvill-trotman:reference:far").find("far"), std::string::npos);
  for (const char* text : {"roth:reference:1", "regularized:reference:1",
                           "wyvill-sharp:reference:1", "epsilon:1:reference:1"}) {
    EXPECT_NE(error_of(text).find("methods are:"), std::string::npos) << text;
  }
}

// So near to the surface that t - D rounds to t, the reference point is on it, and f <= 0.
TEST(MethodTest, AReferenceThatRoundingSwallowsIsOnTheSurface) {
  const scene::Scene scene = support::scene_of("halfspace([0, 0, 1], 0);");
  const ExactRay down{{0, 0, 8}, {0, 0, -1}};
  const auto starts_inside = [&](const char* method, auto tracer) {
    tracer->find(down);
    return tracer->starts_inside(parse_method(method), 0);
  };
  constexpr const char* kTooNear = "wyvill-trotman:reference:1e-16";
  constexpr const char* kFarEnough = "wyvill-trotman:reference:1e-3";
  EXPECT_TRUE(starts_inside(kTooNear, make_tracer<double>(scene, {})));  // wrong
  EXPECT_FALSE(starts_inside(kFarEnough, make_tracer<double>(scene, {})));
  EXPECT_FALSE(starts_inside("wyvill-trotman", make_tracer<double>(scene, {})));
  EXPECT_FALSE(starts_inside(kTooNear, make_tracer<number::exact>(scene, {})));
  EXPECT_TRUE(starts_inside(kFarEnough, make_tracer<number::bin<11>>(scene, {})));  // wrong

  // Its consequence: entering is refused.
  const auto tracer = make_tracer<double>(scene, {});
  tracer->find(down);
  Report report;
  tracer->run(parse_method(kTooNear), report);
  EXPECT_TRUE(report.interfaces.empty());
  EXPECT_EQ(report.rejected, 1U);
  tracer->run(parse_method(kFarEnough), report);
  EXPECT_EQ(report.interfaces.size(), 1U);
  EXPECT_EQ(report.rejected, 0U);
}

// D is a length: with a direction of length 4 it is a quarter of it in t. The ray does not meet
// the cylinder's surface, and the point is before the origin of the ray.
TEST(MethodTest, TheReferenceIsALengthBeforeTheOriginWhereNothingIsCrossed) {
  const scene::Scene scene = support::scene_of(
      "halfspace([0, 0, 1], 0); quadric([[1,0,0,0], [0,1,0,0], [0,0,-1,0], "
      "[0,0,0,-1/4]]);");
  // The hyperboloid x^2 + y^2 - z^2 <= 1/4 along a line through its waist: never left.
  const auto tracer = make_tracer<double>(scene, {});
  tracer->find({{0, 0, 8}, {0, 0, -4}});
  EXPECT_FALSE(tracer->starts_inside(parse_method("wyvill-trotman:reference:7"), 0));
  EXPECT_TRUE(tracer->starts_inside(parse_method("wyvill-trotman:reference:7"), 1));
  EXPECT_TRUE(tracer->starts_inside(parse_method("wyvill-trotman"), 1));
}

// Equal t of one leaf: if it were left before it is entered, W&T 3.5 would reject the one and be
// stuck inside by the other. Many crossings, as short ranges are sorted stably anyway.
TEST(TracerTest, RootsOfALeafThatCoincideStayInTheirOrder) {
  constexpr int kBalls = 20;
  std::string text;
  for (int i = 1; i <= kBalls; ++i) {
    text += "sphere(" + std::to_string(i) + ");";
  }
  const scene::Scene scene = support::scene_of(text);
  const auto tracer = make_tracer<double>(
      scene, poly::Solvers{.fault = {.kind = poly::RootFault::Kind::Double, .rate = 1}});
  tracer->find({{0, 0, -50}, {0, 0, 1}});
  std::vector<csg::LeafIndex> backwards(kBalls);
  for (int i = 0; i < kBalls; ++i) {
    backwards[i] = static_cast<csg::LeafIndex>(kBalls - i);
  }
  for (int round = 0; round < 2; ++round) {
    ASSERT_EQ(tracer->crossings().size(), 3U * kBalls);
    std::vector<int> next(kBalls, 0);
    for (const CrossingId& crossing : tracer->crossings()) {
      EXPECT_EQ(crossing.index, next[crossing.leaf]++);
    }
    tracer->reorder(backwards);
  }
}

}  // namespace
}  // namespace lamina::method
