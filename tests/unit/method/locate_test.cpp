#include "method/locate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "base/seeded_stream.hpp"
#include "method/tracer.hpp"
#include "support/class_tally.hpp"
#include "support/number_types.hpp"
#include "support/random_csg.hpp"
#include "support/scenes.hpp"

namespace lamina::method {
namespace {

using geometry::ExactPoint;
using number::Rational;
using support::scene_of;

// `steel`, `boundary`, `steel?` where undecided; `-` for nothing.
std::string place(const scene::Scene& scene, const ExactPoint& point) {
  const Location location = locate_exact(scene, point);
  EXPECT_FALSE(location.boundary && location.undecided);
  EXPECT_TRUE(!location.boundary || location.medium == csg::kEmpty);
  const std::string& name = scene.materials[location.medium].name;
  return location.boundary ? "boundary"
                           : (name.empty() ? "-" : name) + (location.undecided ? "?" : "");
}

TEST(LocateTest, OffAllCarriersItIsTheTree) {
  const scene::Scene scene = scene_of(R"(material("m") cube(2);)");
  EXPECT_EQ(place(scene, {1, 1, 1}), "m");
  EXPECT_EQ(place(scene, {1, 1, 3}), "-");
  EXPECT_EQ(place(scene_of(""), {0, 0, 0}), "-");
}

TEST(LocateTest, FreeFacesEdgesAndCornersAreBoundary) {
  const scene::Scene scene = scene_of(R"(material("m") rotate([17, 29, 43]) cube(2);)");
  const geometry::AffineMap to_world = inverse(scene.frames[0]).value();
  for (const ExactPoint& local : {ExactPoint{1, 1, 0}, ExactPoint{1, 0, 0}, ExactPoint{0, 0, 2}}) {
    EXPECT_EQ(place(scene, apply(to_world, local)), "boundary");
  }
  // On a carrier, away from the face.
  EXPECT_EQ(place(scene, apply(to_world, {3, 1, 0})), "-");
  EXPECT_EQ(place(scene, apply(to_world, {1, 1, 1})), "m");
}

TEST(LocateTest, TheFaceOfTouchingBoxesIsInside) {
  const scene::Scene scene =
      scene_of(R"(material("m") { cube(1); translate([1, 0, 0]) cube(1); })");
  EXPECT_EQ(place(scene, {1, Rational(1) / 2, Rational(1) / 2}), "m");
  EXPECT_EQ(place(scene, {1, 0, Rational(1) / 2}), "boundary");
  EXPECT_EQ(place(scene, {1, 0, 0}), "boundary");
}

TEST(LocateTest, TheCommonEdgeAndCornerOfEightBoxesAreInside) {
  std::string boxes;
  for (int i = 0; i < 8; ++i) {
    boxes += fmt::format("translate([{}, {}, {}]) cube(1);", i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  const scene::Scene scene = scene_of("material(\"m\") { " + boxes + "}");
  EXPECT_EQ(place(scene, {1, 1, 1}), "m");
  EXPECT_EQ(place(scene, {1, 1, Rational(1) / 3}), "m");
  EXPECT_EQ(place(scene, {1, 1, 0}), "boundary");
}

TEST(LocateTest, WallsInsideAUnionAreNone) {
  const scene::Scene scene =
      scene_of(R"(material("m") { cube(2); translate([1, 1/2, 1/2]) cube([2, 1, 1]); })");
  EXPECT_EQ(place(scene, {1, 1, 1}), "m");  // a face of the second box
  EXPECT_EQ(place(scene, {2, 1, 1}), "m");  // a face of the first
  EXPECT_EQ(place(scene, {2, Rational(1) / 2, 1}), "boundary");
}

TEST(LocateTest, DifferencesShareFaces) {
  const scene::Scene standing =
      scene_of(R"(material("m") difference() { cube(2); translate([1/2, 1/2, 2]) cube(1); })");
  EXPECT_EQ(place(standing, {1, 1, 2}), "boundary");
  const scene::Scene open =
      scene_of(R"(material("m") difference() { cube(2); translate([1/2, 1/2, 1]) cube(1); })");
  EXPECT_EQ(place(open, {1, 1, 2}), "-");
  EXPECT_EQ(place(open, {1, 1, 1}), "boundary");
  EXPECT_EQ(place(open, {Rational(1) / 2, 1, 2}), "boundary");
  const scene::Scene nothing = scene_of(R"(difference() { sphere(2); sphere(2); })");
  EXPECT_EQ(place(nothing, {0, 0, 2}), "-");
}

TEST(LocateTest, BetweenMaterialsTheClosedHalfSpacesDecide) {
  const std::string a = R"(material("a") halfspace([1, 0, 0], 0);)";
  const std::string b = R"(material("b") halfspace([-1, 0, 0], 0);)";
  EXPECT_EQ(place(scene_of(a + b), {0, 0, 0}), "b");
  EXPECT_EQ(place(scene_of(b + a), {0, 0, 0}), "a");
  // Here they give nothing at all, so it is the material that is named last.
  const std::string without_a =
      R"(difference() { material("b") halfspace([0, 0, 1], 9); halfspace([1, 0, 0], 0); })";
  const std::string without_b =
      R"(difference() { material("a") halfspace([0, 0, 1], 9); halfspace([-1, 0, 0], 0); })";
  EXPECT_EQ(place(scene_of(without_b + without_a), {0, 0, 0}), "b");
}

TEST(LocateTest, ApexOfACone) {
  const scene::Scene scene = scene_of(R"(material("m") cylinder(h=1, r1=1, r2=0);)");
  EXPECT_EQ(place(scene, {0, 0, 1}), "boundary");
  EXPECT_EQ(place(scene, {0, 0, 0}), "boundary");
  EXPECT_EQ(place(scene, {0, 0, Rational(1) / 2}), "m");
}

TEST(LocateTest, ApexOfAFacetedCone) {
  const std::string cone = "cylinder(h=1, r1=1, r2=0, $fn=128);";
  EXPECT_EQ(place(scene_of("material(\"m\") " + cone, true), {0, 0, 1}), "boundary");
  // All cells of the 128 planes have to be looked at.
  const scene::Scene filled = scene_of(
      "material(\"m\") { difference() { cube(4, center=true); " + cone + "} " + cone + "}", true);
  EXPECT_EQ(place(filled, {0, 0, 1}), "m");
}

TEST(LocateTest, TouchingSpheres) {
  const std::string a = R"(material("m") sphere(1);)";
  const std::string outside = R"(material("m") translate([2, 0, 0]) sphere(1);)";
  const std::string around = R"(material("m") translate([1, 0, 0]) sphere(2);)";
  const scene::Scene beside = scene_of(a + outside);
  EXPECT_EQ(place(beside, {1, 0, 0}), "boundary");
  // Wyvill and Trotman's Figure 9: between the spheres the shell is as thin as one likes.
  const scene::Scene shell = scene_of("difference() { " + around + a + "}");
  EXPECT_EQ(place(shell, {-1, 0, 0}), "boundary");
  EXPECT_EQ(place(scene_of("difference() { " + a + around + "}"), {-1, 0, 0}), "-?");
  EXPECT_EQ(
      place(scene_of(R"(material("m") { cube(9, center=true); )" + a + outside + "}"), {1, 0, 0}),
      "m?");
}

// Three tangent planes meet in the z axis; only the curvature of the third surface leaves
// room between them: x > 0, y > 0, x + y < z^2.
TEST(LocateTest, SphereSweepsAreOpenWhereOneOfTheirBallsEnds) {
  const scene::Scene scene = scene_of(
      R"(material("m") sphere_sweep(1) contour([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]);)");
  EXPECT_EQ(place(scene, {0, -1, 0}), "m");
  EXPECT_EQ(place(scene, {0, -1, 1}), "boundary");
  // As far from all four sides: whether the hole is closed here, one ball does not tell.
  EXPECT_EQ(place(scene, {0, 0, 0}), "m?");
  EXPECT_EQ(place(scene, {0, 0, 1}), "-");
}

TEST(LocateTest, CellsThatNoTangentPlaneShows) {
  const scene::Scene scene = scene_of(R"(material("m") intersection() {
    halfspace([-1, 0, 0], 0);
    halfspace([0, -1, 0], 0);
    quadric([[0, 0, 0, 1/2], [0, 0, 0, 1/2], [0, 0, -1, 0], [1/2, 1/2, 0, 0]]);
  })");
  EXPECT_EQ(place(scene, {0, 0, 0}), "boundary");
}

// Curved surfaces that share a line, or cross in general position, are told apart for sure.
TEST(LocateTest, CurvedSurfacesThatCrossAreDecided) {
  const scene::Scene lens = scene_of(R"(material("m") {
    difference() { cube(9, center=true); infinite_cylinder(1); }
    intersection() { cube(8, center=true); infinite_cylinder(1); halfspace([0, 1, 0], 0); }
    intersection() { cube(8, center=true); infinite_cylinder(1); halfspace([0, -1, 0], 0); }
  })");
  EXPECT_EQ(place(lens, {1, 0, 0}), "m");
  EXPECT_EQ(place(lens, {0, 1, 2}), "m");
}

// The text of an expression whose leaf i is texts[i].
std::string text_of(const csg::Expression& expression, const std::vector<std::string>& texts) {
  if (expression.kind == csg::Expression::Kind::Leaf) {
    return texts[expression.leaf];
  }
  constexpr std::array kNames{"add", "difference", "intersection"};
  std::string text = fmt::format("{}() {{ ", kNames[static_cast<std::size_t>(expression.op)]);
  for (const csg::Expression& operand : expression.operands) {
    text += text_of(operand, texts);
  }
  return text + "} ";
}

// Directions into all cells of the planes, by brute force: sums of three edges, since a cell
// has three or more; and random ones, for planes that all share a line.
std::vector<ExactPoint> directions_around(const std::vector<ExactPoint>& normals,
                                          base::SeededStream& stream) {
  std::vector<ExactPoint> edges;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = i + 1; j < normals.size(); ++j) {
      edges.push_back(cross(normals[i], normals[j]));
      edges.push_back(cross(normals[j], normals[i]));
    }
  }
  std::vector<ExactPoint> directions;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      for (std::size_t k = j + 1; k < edges.size(); ++k) {
        directions.push_back(edges[i] + edges[j] + edges[k]);
      }
    }
  }
  for (int i = 0; i < 500; ++i) {
    directions.push_back(
        {stream.integer(-99, 99), stream.integer(-99, 99), stream.integer(-99, 99)});
  }
  return directions;
}

TEST(LocateTest, RandomPlanesThroughOnePointMatchBruteForce) {
  support::ClassTally reached({"boundary", "one_medium", "several_media"});
  for (std::uint64_t case_id = 0; case_id < 100; ++case_id) {
    base::SeededStream stream("method/locate", 1, case_id);
    const ExactPoint point{Rational(stream.integer(-9, 9)) / 7, Rational(stream.integer(-9, 9)) / 3,
                           stream.integer(-9, 9)};
    std::vector<ExactPoint> normals;
    std::vector<std::string> texts;
    for (std::uint64_t k = 2 + stream.below(4); texts.size() < k;) {
      const ExactPoint n{stream.integer(-2, 2), stream.integer(-2, 2), stream.integer(-2, 2)};
      if (n == ExactPoint{}) {
        continue;
      }
      normals.push_back(n);
      texts.push_back(fmt::format("material(\"m{}\") halfspace([{}, {}, {}], {}); ",
                                  stream.below(2), number::to_text(n.x), number::to_text(n.y),
                                  number::to_text(n.z), number::to_text(dot(n, point))));
    }
    const auto count = static_cast<csg::LeafIndex>(texts.size());
    // Some cases are filled up, so that they are not all boundary.
    const std::string filling =
        stream.chance(0.4) ? "material(\"m0\") halfspace([0, 0, 1], 9999); " : "";
    const std::string text = filling + text_of(support::random_expression(stream, 0, count), texts);
    const scene::Scene scene = scene_of(text);

    std::set<std::string> found;
    for (const ExactPoint& direction : directions_around(normals, stream)) {
      if (const auto name = support::material_at(scene, point + direction)) {
        found.insert(*name);
      }
    }
    const bool boundary = found.size() > 1 && found.contains("");
    const std::string said = place(scene, point);
    EXPECT_TRUE(boundary ? said == "boundary" : found.contains(said == "-" ? "" : said))
        << "case " << case_id << " says " << said << ": " << text;
    reached.add("boundary", boundary);
    reached.add("one_medium", found.size() == 1);
    reached.add("several_media", found.size() > 1 && !boundary);
  }
  EXPECT_TRUE(reached.each_at_least(15)) << reached;
}

template <typename Number>
class LocateInTest : public ::testing::Test {};

using AllNumberTypes = support::TypesOf<number::AllNumbers>::type;
TYPED_TEST_SUITE(LocateInTest, AllNumberTypes, support::NumberNames);

TYPED_TEST(LocateInTest, EveryNumberTypeSeesTheMediumAwayFromCarriers) {
  const scene::Scene scene = scene_of(R"(rotate([17, 29, 43]) difference() {
    material("a") cube(2);
    material("b") translate([1, 1, 1]) sphere(3/4);
    material("b") translate([1, 1, 1]) torus(R=1, r=1/4);
  })");
  const auto tracer = make_tracer<TypeParam>(scene, {});
  const geometry::AffineMap to_world = inverse(scene.frames[0]).value();
  base::SeededStream stream("method/locate_in", 1, 0);
  const Rational eps = Rational(1) / 64;  // coarser than bin11 rounds here
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&stream] { return Rational(stream.integer(-16, 48)) / 16; };
    const ExactPoint local{coordinate(), coordinate(), coordinate()};
    const ExactPoint point = apply(to_world, local);
    const csg::Medium medium = locate_exact(scene, point).medium;
    bool near = false;
    for (int n = 0; n < 27; ++n) {
      const ExactPoint step{(n % 3 - 1) * eps, (n / 3 % 3 - 1) * eps, (n / 9 - 1) * eps};
      const Location there = locate_exact(scene, point + step);
      near = near || there.medium != medium || there.boundary;
    }
    if (!near) {
      ++checked;
      EXPECT_EQ(tracer->medium_at(point), medium);
    }
  }
  EXPECT_GT(checked, 100);
}

TYPED_TEST(LocateInTest, ACommonFaceThatIsRepresentableIsInside) {
  const scene::Scene scene =
      scene_of(R"(material("m") { cube(1); translate([1, 0, 0]) cube(1); })");
  const auto tracer = make_tracer<TypeParam>(scene, {});
  EXPECT_EQ(tracer->medium_at({1, Rational(1) / 2, Rational(1) / 2}), scene.leaves[0].medium);
  EXPECT_EQ(tracer->medium_at({3, 0, 0}), csg::kEmpty);
}

}  // namespace
}  // namespace lamina::method
