#include "scene/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lamina::scene {
namespace {

using geometry::ExactPoint;
using number::Rational;

// f of a plane at a point: negative inside.
Rational value_at(const surface::LocalSurface& plane, const ExactPoint& p) {
  const auto& c = plane.coefficients;
  return c[0] * p.x + c[1] * p.y + c[2] * p.z + c[3];
}

std::vector<std::string> facets_through(const Solid& solid, const ExactPoint& p) {
  std::vector<std::string> names;
  for (const Solid::Part& part : solid.parts) {
    const Rational value = value_at(part.surface, p);
    EXPECT_LE(value, 0) << part.name << " cuts off a vertex";
    if (value == 0) {
      names.push_back(part.name);
    }
  }
  return names;
}

FacetSettings settings(const Rational& fn, const Rational& fa = 12, const Rational& fs = 2) {
  return {fn, fa, fs};
}

using Names = std::vector<std::string>;

TEST(VerticesOfCircleTest, FollowsOpenScad) {
  EXPECT_EQ(vertices_of_circle(10, settings(50)), 50);
  EXPECT_EQ(vertices_of_circle(10, settings(Rational(79) / 10)), 7);
  EXPECT_EQ(vertices_of_circle(10, settings(1)), 3);
  EXPECT_EQ(vertices_of_circle(100, settings(0)), 30);
  EXPECT_EQ(vertices_of_circle(100, settings(-1)), 30);
  EXPECT_EQ(vertices_of_circle(5, settings(0)), 16);  // ceil(5 pi)
  EXPECT_EQ(vertices_of_circle(1, settings(0)), 5);
  EXPECT_EQ(vertices_of_circle(100, settings(0, 7, Rational(1) / 10)), 52);  // ceil(360 / 7)
  EXPECT_EQ(vertices_of_circle(100, settings(0, 0, 0)), 36'000);             // $fa at least 0.01
  EXPECT_EQ(vertices_of_circle(Rational(1) / 2'000'000, settings(50)), 3);
  EXPECT_EQ(vertices_of_circle(1, settings(pow(number::Integer(10), 300))), kMaxFacets);
}

TEST(FacetedCylinderTest, HasItsVerticesAtMultiplesOfTheAngle) {
  const Solid solid = faceted_cylinder({2, 0}, {2, 5}, 4);
  ASSERT_EQ(solid.parts.size(), 6U);
  EXPECT_EQ(facets_through(solid, {2, 0, 0}), (Names{"side[1]", "side[4]", "bottom"}));
  EXPECT_EQ(facets_through(solid, {0, 2, 5}), (Names{"side[1]", "side[2]", "top"}));
  EXPECT_EQ(facets_through(solid, {-2, 0, 5}), (Names{"side[2]", "side[3]", "top"}));
  EXPECT_EQ(facets_through(solid, {0, -2, 0}), (Names{"side[3]", "side[4]", "bottom"}));
  EXPECT_EQ(facets_through(solid, {1, 1, 1}), (Names{"side[1]"}));
  EXPECT_TRUE(facets_through(solid, {0, 0, 1}).empty());
}

TEST(FacetedCylinderTest, AHexagonHasItsCornerOnTheXAxis) {
  const Solid solid = faceted_cylinder({1, 0}, {1, 1}, 6);
  const Rational height = Rational(std::sqrt(0.75));
  EXPECT_EQ(facets_through(solid, {1, 0, 0}), (Names{"side[1]", "side[6]", "bottom"}));
  EXPECT_EQ(facets_through(solid, {Rational(1) / 2, height, 0}),
            (Names{"side[1]", "side[2]", "bottom"}));
  EXPECT_EQ(facets_through(solid, {0, height, 1}), (Names{"side[2]", "top"}));
}

TEST(FacetedCylinderTest, ATruncatedConeHasPlanarSides) {
  const Solid solid = faceted_cylinder({3, -1}, {1, 2}, 5);
  for (int k = 0; k < 5; ++k) {
    const geometry::CosSin a = geometry::cos_sin_degrees(72 * k);
    const std::string here = "side[" + std::to_string(k + 1) + "]";
    const std::string before = "side[" + std::to_string(k == 0 ? 5 : k) + "]";
    for (const Rim& rim : {Rim{3, -1}, Rim{1, 2}}) {
      const Names names = facets_through(solid, {rim.radius * a.cos, rim.radius * a.sin, rim.z});
      EXPECT_EQ(names.size(), 3U);
      EXPECT_NE(std::find(names.begin(), names.end(), here), names.end());
      EXPECT_NE(std::find(names.begin(), names.end(), before), names.end());
    }
  }
}

TEST(FacetedCylinderTest, AConeEndsInItsApex) {
  const Solid up = faceted_cylinder({1, 0}, {0, 2}, 3);
  EXPECT_EQ(facets_through(up, {0, 0, 2}), (Names{"side[1]", "side[2]", "side[3]"}));
  EXPECT_EQ(up.parts.back().name, "bottom");
  const Solid down = faceted_cylinder({0, 0}, {1, 2}, 3);
  EXPECT_EQ(facets_through(down, {0, 0, 0}), (Names{"side[1]", "side[2]", "side[3]"}));
  EXPECT_EQ(down.parts.back().name, "top");
}

TEST(FacetedSphereTest, HasItsRingsHalfAStepFromThePoles) {
  // Four vertices in each of two rings, at the polar angles 45 and 135.
  const Solid solid = faceted_sphere(1, 4);
  const Rational s = geometry::cos_sin_degrees(45).sin;
  ASSERT_EQ(solid.parts.size(), 6U);
  EXPECT_EQ(facets_through(solid, {s, 0, s}), (Names{"top", "ring[1][1]", "ring[1][4]"}));
  EXPECT_EQ(facets_through(solid, {0, s, -s}), (Names{"ring[1][1]", "ring[1][2]", "bottom"}));
}

TEST(FacetedSphereTest, AnOddRingIsOnTheEquator) {
  // Five vertices in each of three rings, at the polar angles 30, 90 and 150.
  const Solid solid = faceted_sphere(2, 5);
  const Rational height = 2 * geometry::cos_sin_degrees(30).cos;
  ASSERT_EQ(solid.parts.size(), 12U);
  EXPECT_EQ(facets_through(solid, {1, 0, height}), (Names{"top", "ring[1][1]", "ring[1][5]"}));
  EXPECT_EQ(facets_through(solid, {2, 0, 0}),
            (Names{"ring[1][1]", "ring[1][5]", "ring[2][1]", "ring[2][5]"}));
  EXPECT_EQ(facets_through(solid, {1, 0, -height}), (Names{"ring[2][1]", "ring[2][5]", "bottom"}));
}

TEST(FacetedSphereTest, EveryVertexIsOnItsFacetsAndInsideTheOthers) {
  constexpr int kVertices = 14;
  const Solid solid = faceted_sphere(Rational(7) / 3, kVertices);
  const int rings = rings_of_sphere(kVertices);
  EXPECT_EQ(solid.parts.size(), static_cast<std::size_t>(kVertices * (rings - 1) + 2));
  for (int i = 0; i < rings; ++i) {
    const geometry::CosSin polar = geometry::cos_sin_degrees(Rational(180 * i + 90) / rings);
    const Rational radius = Rational(7) / 3 * polar.sin;
    for (int k = 0; k < kVertices; ++k) {
      const geometry::CosSin a = geometry::cos_sin_degrees(Rational(360 * k) / kVertices);
      const bool pole = i == 0 || i + 1 == rings;
      EXPECT_EQ(facets_through(solid, {radius * a.cos, radius * a.sin, Rational(7) / 3 * polar.cos})
                    .size(),
                pole ? 3U : 4U)
          << "ring " << i << " vertex " << k;
    }
  }
}

}  // namespace
}  // namespace lamina::scene
