#include "scene/revolved.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "base/seeded_stream.hpp"
#include "geometry/conic_spline.hpp"
#include "support/class_tally.hpp"
#include "support/glass.hpp"
#include "support/revolved_truth.hpp"

namespace lamina::scene {
namespace {

using geometry::ArcAt;
using geometry::Contour;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::PlanePoint;
using geometry::RevolvedProfile;
using number::Rational;
using surface::Kind;
using Points = std::vector<PlanePoint>;

// f <= 0, as half_space.hpp defines f.
bool contains(const surface::LocalSurface& surface, const ExactPoint& p) {
  const auto& c = surface.coefficients;
  const Rational square = p.x * p.x + p.y * p.y;
  switch (surface.kind) {
    case Kind::Plane:
      return c[0] * p.x + c[1] * p.y + c[2] * p.z + c[3] <= 0;
    case Kind::Quadric:
      return c[0] * p.x * p.x + c[1] * p.y * p.y + c[2] * p.z * p.z + c[3] * p.x * p.y +
                 c[4] * p.x * p.z + c[5] * p.y * p.z + c[6] * p.x + c[7] * p.y + c[8] * p.z +
                 c[9] <=
             0;
    default:
      break;
  }
  const Rational ring = square + p.z * p.z + c[0] * c[0] - c[1] * c[1];
  return ring * ring <= 4 * c[0] * c[0] * square;
}

bool contains(const Solid& solid, ExactPoint p) {
  if (solid.placement) {
    p = apply(inverse(*solid.placement).value(), p);
  }
  std::vector<bool> operands;
  for (const Solid::Part& part : solid.parts) {
    operands.push_back(contains(part.surface, p));
  }
  for (const Solid& operand : solid.solids) {
    operands.push_back(contains(operand, p));
  }
  bool result = operands.at(0);
  for (std::size_t k = 1; k < operands.size(); ++k) {
    switch (solid.op) {
      case csg::Operator::Add:
        result = result || operands[k];
        break;
      case csg::Operator::Difference:
        result = result && !operands[k];
        break;
      case csg::Operator::Intersection:
        result = result && operands[k];
        break;
    }
  }
  return result;
}

struct SurfaceCount {
  int planes = 0;
  int quadrics = 0;
  int toruses = 0;
};

void count(const Solid& solid, SurfaceCount& total) {
  for (const Solid::Part& part : solid.parts) {
    switch (part.surface.kind) {
      case Kind::Plane:
        ++total.planes;
        break;
      case Kind::Quadric:
        ++total.quadrics;
        break;
      default:
        ++total.toruses;
        break;
    }
  }
  for (const Solid& operand : solid.solids) {
    count(operand, total);
  }
}

// At random points, none at the height of a joint: joints have small denominators, these do not.
void expect_region(const RevolvedProfile& profile, const char* name) {
  const Solid solid = revolved_solid(profile);
  const Bounds box = solid.box.value();
  const double radius = number::nearest_double(box.upper.x);
  const double low = number::nearest_double(box.lower.z);
  const double high = number::nearest_double(box.upper.z);
  support::ClassTally reached({"inside", "outside"});
  for (std::uint64_t case_id = 0; case_id < 1000; ++case_id) {
    base::SeededStream stream(name, 0, case_id);
    // On a random meridian with a rational direction.
    const Rational x = stream.uniform(0, 1.1 * radius);
    const Rational z = stream.uniform(low - 0.1, high + 0.1);
    const Rational t = stream.uniform(-1, 1);
    const ExactPoint p{x * (1 - t * t) / (1 + t * t), x * 2 * t / (1 + t * t), z};
    const bool expected = geometry::inside(profile, x, z);
    reached.add(expected ? "inside" : "outside");
    EXPECT_EQ(contains(solid, p), expected) << name << ", case " << case_id;
    if (expected) {
      EXPECT_TRUE(x <= box.upper.x && z >= box.lower.z && z <= box.upper.z);
    }
  }
  EXPECT_TRUE(reached.each_at_least(50)) << reached;
}

Points tenths(const std::vector<std::array<int, 2>>& written) {
  Points points;
  for (const auto& [x, y] : written) {
    points.push_back({Rational(x, 10), Rational(y, 10)});
  }
  return points;
}

TEST(RevolvedSolidTest, IsTheGlassOfTwentyFiveQuadricsAndOneTorus) {
  const RevolvedProfile glass =
      geometry::fit_conic_spline(geometry::glass_points(), geometry::glass_arcs());
  SurfaceCount total;
  count(revolved_solid(glass), total);
  EXPECT_EQ(total.quadrics, 25);
  EXPECT_EQ(total.toruses, 1);
  EXPECT_EQ(total.planes, 51);  // two a quadric, one for the torus
  expect_region(glass, "scene/revolved_glass");
}

TEST(RevolvedSolidTest, HasHollowsBelow) {
  // A foot that stands on its rim, and a bowl.
  const Points points = tenths({{0, 10}, {15, 8}, {30, 0}, {10, 20}, {10, 30}, {30, 60}, {0, 40}});
  const Rational r = Rational(1) / 5;
  expect_region(geometry::fit_conic_spline(points, std::vector<ArcAt>{{3, r, 0}, {6, r, 0}}),
                "scene/revolved_hollow");
}

TEST(RevolvedSolidTest, HasPegsAndGrooves) {
  const Rational r = Rational(1) / 5;
  // Up at 40, down to a trough, and up a peg.
  expect_region(geometry::fit_conic_spline(
                    tenths({{40, 0}, {40, 20}, {35, 50}, {30, 30}, {25, 10}, {20, 30}, {0, 60}}),
                    std::vector<ArcAt>{{3, r, 0}, {5, r, 0}}),
                "scene/revolved_peg");
  // Under a disc, up into a groove, down to its outer wall's foot, and up outside.
  expect_region(
      geometry::fit_conic_spline(
          tenths({{10, 0}, {12, 20}, {20, 40}, {28, 20}, {35, -10}, {40, 20}, {38, 50}, {0, 60}}),
          std::vector<ArcAt>{{3, r, 0}, {5, r, 0}}),
      "scene/revolved_groove");
}

TEST(RevolvedSolidTest, HasTipsThatTouchTheAxis) {
  const Rational third = Rational(1) / 3;
  const RevolvedProfile drop =
      geometry::fit_conic_spline(tenths({{0, 0}, {10, 30}, {25, 50}, {12, 65}, {0, 100}}),
                                 std::vector<ArcAt>{{1, 2, third}, {5, 3, third}});
  expect_region(drop, "scene/revolved_drop");
}

TEST(RevolvedSolidTest, IsThatOfConesInsideAnyContour) {
  const Points vase{{0, 0}, {4, 0}, {3, 4}, {4, 6}, {4, 9}, {3, 9}, {3, 6}, {2, 4}, {0, 2}};
  for (const ContourKind kind :
       {ContourKind::Line, ContourKind::BSpline, ContourKind::CatmullRom}) {
    const Contour contour(vase, kind, false);
    for (const std::size_t pieces : {9U, 26U}) {
      const RevolvedProfile cones = geometry::inscribed_cones(contour, pieces);
      expect_region(cones, "scene/revolved_cones");
      SurfaceCount total;
      count(revolved_solid(cones), total);
      EXPECT_EQ(total.toruses, 0);
      EXPECT_LE(total.quadrics, static_cast<int>(pieces));
    }
  }
}

TEST(RevolvedSolidTest, MeetsItsNeighboursInEqualPlanes) {
  const Solid solid =
      revolved_solid(geometry::fit_conic_spline(geometry::glass_points(), geometry::glass_arcs()));
  // The outer side: eighteen quadrics from the foot to the rim.
  const Solid& outside = solid.solids.at(0);
  for (std::size_t k = 1; k < 18; ++k) {
    const auto& top = outside.solids.at(k - 1).parts.at(2).surface.coefficients;
    const auto& bottom = outside.solids.at(k).parts.at(1).surface.coefficients;
    EXPECT_EQ(top[2], -bottom[2]);
    EXPECT_EQ(top[3], -bottom[3]);
  }
}

}  // namespace
}  // namespace lamina::scene
