#include "scene/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "method/locate.hpp"
#include "support/scenes.hpp"

namespace lamina::scene {
namespace {

using number::Rational;
using Point = geometry::Vector3<double>;

bool solid_at(const Scene& scene, const Point& p) {
  return method::locate_exact(scene, {Rational(p.x), Rational(p.y), Rational(p.z)}).medium !=
         csg::kEmpty;
}

// The box 1 <= x <= 2, 3 <= y <= 5, 7 <= z <= 10, as the text places it, and its points near
// its faces, as `apply` does.
template <typename Placed>
void expect_text_and_apply_to_agree(const Placed& placed, base::SeededStream& stream) {
  const Scene scene = support::scene_of(placed.text() + "translate([1, 3, 7]) cube([1, 2, 3]);");
  constexpr double kNear = 1e-6;
  const Point low{1, 3, 7};
  const Point high{2, 5, 10};
  for (int i = 0; i < 12; ++i) {
    const auto between = [&](double a, double b) { return stream.uniform(a + kNear, b - kNear); };
    Point inside{between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
    EXPECT_TRUE(solid_at(scene, placed.apply(inside))) << placed.text();
    Point outside = inside;
    switch (i % 6) {
      case 0:
        inside.x = low.x + kNear;
        outside.x = low.x - kNear;
        break;
      case 1:
        inside.x = high.x - kNear;
        outside.x = high.x + kNear;
        break;
      case 2:
        inside.y = low.y + kNear;
        outside.y = low.y - kNear;
        break;
      case 3:
        inside.y = high.y - kNear;
        outside.y = high.y + kNear;
        break;
      case 4:
        inside.z = low.z + kNear;
        outside.z = low.z - kNear;
        break;
      default:
        inside.z = high.z - kNear;
        outside.z = high.z + kNear;
        break;
    }
    EXPECT_TRUE(solid_at(scene, placed.apply(inside))) << placed.text();
    EXPECT_FALSE(solid_at(scene, placed.apply(outside))) << placed.text();
  }
}

TEST(LengthTest, IsTheRationalThatItSpells) {
  const auto spelled = [](const Length& length) { return number::parse_rational(length.text()); };
  base::SeededStream stream("scene/placement_test", 1, 0);
  for (int i = 0; i < 100; ++i) {
    const Length a = random_length(stream, -3, 2);
    const Length b = random_length(stream, 1, 4);
    EXPECT_EQ(spelled(a), Rational(a.numerator, a.denominator));
    EXPECT_GE(spelled(a), -3);
    EXPECT_LE(spelled(a), 2);
    EXPECT_EQ(spelled(a + b), Rational(spelled(a) + spelled(b)));
    EXPECT_EQ(spelled(-a), Rational(-spelled(a)));
    EXPECT_EQ(spelled(b / 3), Rational(spelled(b) / 3));
    EXPECT_EQ(spelled(a * 3), Rational(spelled(a) * 3));
    EXPECT_EQ(Rational((b / 3).value()), Rational(number::nearest_double(spelled(b / 3))));
  }
  EXPECT_EQ(Length({-7, 1}).text(), "-7");
  EXPECT_EQ(Length({3, 10}).text(), "3/10");
}

TEST(PlacementTest, RotationsApplyAsTheyAreSpelled) {
  std::size_t aligned = 0;
  for (std::uint64_t case_id = 0; case_id < 40; ++case_id) {
    base::SeededStream stream("scene/placement_test/rotation", 1, case_id);
    const Rotation rotation(stream);
    aligned += rotation.text().empty() ? 1 : 0;
    expect_text_and_apply_to_agree(rotation, stream);
  }
  EXPECT_GE(aligned, 1U);
  EXPECT_LE(aligned, 15U);
}

TEST(PlacementTest, PlacementsApplyAsTheyAreSpelled) {
  for (std::uint64_t case_id = 0; case_id < 40; ++case_id) {
    base::SeededStream stream("scene/placement_test/placement", 1, case_id);
    expect_text_and_apply_to_agree(Placement(stream), stream);
    const Placement aligned = Placement::aligned(stream);
    EXPECT_EQ(aligned.text().find("rotate"), std::string::npos);
    expect_text_and_apply_to_agree(aligned, stream);
  }
}

TEST(PlacementTest, PatchesAreTurnedWithTheirSides) {
  base::SeededStream stream("scene/placement_test/patch", 1, 3);
  const Rotation rotation(stream);
  ASSERT_FALSE(rotation.text().empty());
  const Point corner{1, 2, 3};
  const Point side1{4, 0, 1};
  const Point side2{0, -2, 5};
  const FamilyMember::Patch patch = rotation.patch(corner, side1, side2);
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.25, 0.75}}) {
    const Point expected = rotation.apply(corner + u * side1 + v * side2);
    const Point actual = patch.corner + u * patch.side1 + v * patch.side2;
    EXPECT_NEAR(actual.x, expected.x, 1e-12);
    EXPECT_NEAR(actual.y, expected.y, 1e-12);
    EXPECT_NEAR(actual.z, expected.z, 1e-12);
  }
}

}  // namespace
}  // namespace lamina::scene
