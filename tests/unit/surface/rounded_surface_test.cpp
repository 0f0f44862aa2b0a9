#include "surface/rounded_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"
#include "support/number_types.hpp"
#include "support/reference_faces.hpp"
#include "support/reference_surd.hpp"

namespace lamina::surface {
namespace {

using geometry::ExactPoint;
using number::Rational;
using reference::Primitive;
using reference::Surd;

// Whole numbers so small that every type holds them, and the values of all equations at points
// made of them, without rounding: bin<11> has 11 bits.
struct Case {
  Primitive primitive;
  LocalSurface surface;
  std::array<int, 3> origin{};
  std::array<int, 3> direction{};
};

std::array<int, 3> random_vector(base::SeededStream& stream, int most) {
  std::array<int, 3> v{};
  for (int& coordinate : v) {
    coordinate = static_cast<int>(stream.integer(-most, most));
  }
  return v;
}

Case random_case(base::SeededStream& stream, bool with_torus) {
  Case in;
  switch (stream.below(with_torus ? 6 : 5)) {
    case 0: {
      const auto n = random_vector(stream, 3);
      const Rational offset = stream.integer(-5, 5);
      in.primitive = {Primitive::Kind::HalfSpace, {n[0], n[1], n[2], offset}};
      in.surface = plane({n[0], n[1], n[2]}, offset);
      break;
    }
    case 1: {
      const Rational r = stream.integer(1, 4);
      in.primitive = {Primitive::Kind::Sphere, {r}};
      in.surface = sphere(r);
      break;
    }
    case 2: {
      // x^2 + y^2 - r^2, by its matrix.
      const Rational r = stream.integer(1, 4);
      in.primitive = {Primitive::Kind::Quadric,
                      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, -r * r}};
      in.surface = infinite_cylinder(r);
      break;
    }
    case 3: {
      // x^2 + y^2 - s^2 (z - a)^2
      const Rational s = stream.integer(1, 2);
      const Rational a = stream.integer(-2, 2);
      const Rational ss = s * s;
      in.primitive = {Primitive::Kind::Quadric,
                      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -ss, 2 * ss * a, 0, 0, 0, -ss * a * a}};
      in.surface = infinite_cone(s, a);
      break;
    }
    case 4: {
      std::vector<Rational> numbers;
      std::array<std::array<Rational, 4>, 4> matrix;
      for (std::size_t i = 0; i < 16; ++i) {
        numbers.emplace_back(stream.integer(-2, 2));
        matrix[i / 4][i % 4] = numbers.back();
      }
      in.primitive = {Primitive::Kind::Quadric, numbers};
      in.surface = quadric(matrix);
      break;
    }
    default:
      in.primitive = {Primitive::Kind::Torus, {2, 1}};
      in.surface = torus(2, 1);
      break;
  }
  in.origin = random_vector(stream, 3);
  do {
    in.direction = random_vector(stream, 2);
  } while (in.direction == std::array<int, 3>{});
  if (in.surface.kind == Kind::Plane && stream.chance(0.25)) {
    // In the plane z = the origin's.
    const Rational z = in.origin[2];
    in.primitive = {Primitive::Kind::HalfSpace, {0, 0, 1, z}};
    in.surface = plane({0, 0, 1}, z);
    in.direction = {1, static_cast<int>(stream.integer(-2, 2)), 0};
  }
  return in;
}

Rational value_at(const Case& in, const std::array<Rational, 3>& point) {
  return reference::faces_at<Rational>(in.primitive, point)[0];
}

std::array<Rational, 3> point_at(const Case& in, int t) {
  std::array<Rational, 3> point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = in.origin[i] + t * in.direction[i];
  }
  return point;
}

// f = a t^2 + 2 b t + c along the ray, from three of its values.
struct Along {
  Rational a;
  Rational b;
  Rational c;
};
Along along(const Case& in) {
  const Rational c = value_at(in, point_at(in, 0));
  const Rational ahead = value_at(in, point_at(in, 1));
  const Rational behind = value_at(in, point_at(in, -1));
  return {(ahead + behind) / 2 - c, (ahead - behind) / 4, c};
}

template <typename Number>
class RoundedSurfaceTest : public ::testing::Test {
 protected:
  using Traits = number::number_traits<Number>;
  using Vector = geometry::Vector3<Number>;

  static Vector vector(const std::array<int, 3>& v) {
    return {Number(v[0]), Number(v[1]), Number(v[2])};
  }
  static geometry::Ray<Number> ray(const Case& in) {
    return {vector(in.origin), vector(in.direction)};
  }
  static Rational roundoff() {
    return Rational(1) /
           Rational(number::Integer(1) << static_cast<unsigned>(Traits::kSignificandBits));
  }
  // |t - root| <= bound * u * |root|?
  static bool within(const Number& t, const Surd& root, const Rational& bound) {
    const Rational value = Traits::to_exact(t);
    Rational low = value / (1 + bound * roundoff());
    Rational high = value / (1 - bound * roundoff());
    if (value < 0) {
      std::swap(low, high);
    }
    return compare(Surd(low, 0, 0), root) <= 0 && compare(root, Surd(high, 0, 0)) <= 0;
  }
};
TYPED_TEST_SUITE(RoundedSurfaceTest, support::RoundedNumberTypes, support::NumberNames);

// The coefficients along the ray are exact, so that what is off is the solver: one rounding for a
// plane, five units of roundoff for a quadric (quadratic_test derives them).
TYPED_TEST(RoundedSurfaceTest, CrossingsOfPlanesAndQuadricsAreTheExactOnes) {
  constexpr std::uint64_t kCases = 1000;
  support::ClassTally reached{"none",       "one",       "two",           "touch",
                              "in carrier", "never met", "starts inside", "starts outside"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("surface/rounded_surface", 1, case_id);
    const Case in = random_case(stream, false);
    const auto [a, b, c] = along(in);
    SCOPED_TRACE(case_id);
    const auto found = RoundedSurface<TypeParam>(in.surface).crossings(this->ray(in), {});

    EXPECT_EQ(found.in_carrier, a == 0 && b == 0 && c == 0);
    const bool inside = a != 0 ? a < 0 : b != 0 ? b > 0 : c < 0;
    EXPECT_EQ(found.starts_inside, inside);
    std::vector<Surd> roots;
    const Rational d = b * b - a * c;
    if (a == 0 && b != 0) {
      roots.emplace_back(-c / (2 * b), 0, 0);
    } else if (a != 0 && d > 0) {
      const Rational q = 1 / Rational(abs(a));
      roots.emplace_back(-b / a, -q, d);
      roots.emplace_back(-b / a, q, d);
    }
    ASSERT_EQ(found.roots.count, roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      EXPECT_TRUE(this->within(found.roots.t[i], roots[i], a == 0 ? 1 : 5))
          << found.roots.t[i] << " for " << roots[i].approximation();
    }
    reached.add(roots.empty() ? "none" : roots.size() == 1 ? "one" : "two");
    reached.add("touch", a != 0 && d == 0);
    reached.add("in carrier", found.in_carrier);
    reached.add("never met", a == 0 && b == 0 && c != 0);
    reached.add(inside ? "starts inside" : "starts outside");
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 200)) << reached;
}

// From a point of the surface: the other root of the quadratic is -2 b / a, and 0 is given as 0.
TYPED_TEST(RoundedSurfaceTest, TheRootThatARayStartsAtIsDividedOut) {
  constexpr std::uint64_t kCases = 3000;
  support::ClassTally reached{"plane", "ahead", "behind", "touch", "in carrier"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("surface/starts_on", 1, case_id);
    const Case in = random_case(stream, false);
    const auto [a, b, c] = along(in);
    if (c != 0) {
      continue;
    }
    SCOPED_TRACE(case_id);
    const auto found = RoundedSurface<TypeParam>(in.surface).crossings(this->ray(in), {}, true);
    EXPECT_EQ(found.in_carrier, a == 0 && b == 0);
    EXPECT_EQ(found.starts_inside, a != 0 ? a < 0 : b > 0);
    if (b == 0) {
      EXPECT_EQ(found.roots.count, 0);
      reached.add(a == 0 ? "in carrier" : "touch");
      continue;
    }
    ASSERT_EQ(found.roots.count, a == 0 ? 1 : 2);
    const int zero = a != 0 && -b / a < 0 ? 1 : 0;
    EXPECT_EQ(found.roots.t[zero], TypeParam(0));
    if (a != 0) {
      EXPECT_TRUE(this->within(found.roots.t[1 - zero], Surd(-2 * b / a, 0, 0), 2));
    }
    reached.add(a == 0 ? "plane" : zero == 0 ? "ahead" : "behind");
  }
  EXPECT_TRUE(reached.each_at_least(3)) << reached;
}

// Along an axis from its outer circle: t (t - 2)(t - 4)(t - 6) = t (t^3 - 12 t^2 + 44 t - 48),
// whose coefficients are exact. Horner's rule is off by no more than 2 * 3 u times the sum of |c_i
// t^i|, which is 192, 480 and 960 at 2, 4 and 6, where the slopes are 8, 4 and 8: 144, 720 and 720
// u; as much again for what is of second order.
TYPED_TEST(RoundedSurfaceTest, TheRootThatARayStartsAtIsDividedOutOfATorus) {
  const RoundedSurface<TypeParam> ring(torus(2, 1));
  const geometry::Ray<TypeParam> ray{{TypeParam(3), TypeParam(0), TypeParam(0)},
                                     {TypeParam(-1), TypeParam(0), TypeParam(0)}};
  const auto found = ring.crossings(ray, {}, true);
  ASSERT_EQ(found.roots.count, 4);
  EXPECT_EQ(found.roots.t[0], TypeParam(0));
  const TypeParam most = 1440 * number::unit_roundoff<TypeParam>();
  for (const auto& [root, exact] : {std::pair{1, 2}, {2, 4}, {3, 6}}) {
    using std::abs;
    EXPECT_LE(abs(found.roots.t[root] - TypeParam(exact)), most);
  }
}

// Scenes' numbers that are no binary fractions, placed by a map that is rounded, too.
TYPED_TEST(RoundedSurfaceTest, TheRoundingErrorIsBounded) {
  using Exact = typename TestFixture::Traits;
  const auto exactly = [](const geometry::Vector3<TypeParam>& v) {
    return geometry::ExactPoint{Exact::to_exact(v.x), Exact::to_exact(v.y), Exact::to_exact(v.z)};
  };
  const std::vector<LocalSurface> surfaces{
      plane({Rational(1, 3), Rational(-2, 7), 1}, Rational(5, 9)), sphere(Rational(10, 7)),
      infinite_cylinder(Rational(4, 3)), infinite_cone(Rational(3, 7), Rational(1, 3)),
      torus(Rational(5, 3), Rational(1, 3))};
  Rational largest_part = 0;
  for (std::uint64_t case_id = 0; case_id < 300; ++case_id) {
    base::SeededStream stream("surface/rounding_error", 1, case_id);
    geometry::AffineMap to_local;
    for (auto& row : to_local.rows) {
      for (Rational& entry : row) {
        entry = Rational(stream.integer(-20, 20), stream.integer(1, 13));
      }
    }
    const RoundedMap<TypeParam> frame(to_local);
    const auto coordinate = [&stream] {
      return TypeParam(static_cast<int>(stream.integer(-60, 60))) / 13;
    };
    const TypeParam x = coordinate();
    const TypeParam y = coordinate();
    const geometry::Vector3<TypeParam> world{x, y, coordinate()};
    const LocalSurface& exact = surfaces[case_id % surfaces.size()];
    const RoundedSurface<TypeParam> surface(exact);
    const geometry::ExactPoint local = apply(to_local, exactly(world));
    const auto& c = exact.coefficients;
    const Rational squared = dot(local, local);
    Rational value;
    switch (exact.kind) {
      case Kind::Plane:
        value = c[0] * local.x + c[1] * local.y + c[2] * local.z + c[3];
        break;
      case Kind::Quadric:
        value = c[0] * local.x * local.x + c[1] * local.y * local.y + c[2] * local.z * local.z +
                c[6] * local.x + c[7] * local.y + c[8] * local.z + c[9];
        break;
      case Kind::Torus: {
        const Rational k = squared + c[0] * c[0] - c[1] * c[1];
        value = k * k - 4 * c[0] * c[0] * (local.x * local.x + local.y * local.y);
        break;
      }
      case Kind::Sweep:
        FAIL() << "no sweep is in the list";
    }
    const Rational bound = Exact::to_exact(surface.rounding_error(frame.magnitude(world)));
    const Rational error =
        abs(Rational(Exact::to_exact(surface.value(frame.point(world))) - value));
    ASSERT_LE(error, bound) << case_id;
    ASSERT_GT(bound, 0);
    largest_part = std::max(largest_part, Rational(error / bound));
  }
  // Not so wide that it says nothing.
  EXPECT_GT(largest_part, Rational(1, 50));
}

// Along an axis of the torus (2, 1): (t^2 - 1)(t^2 - 9) = t^4 - 10 t^2 + 9, whose coefficients
// are exact. Horner's rule is off by no more than 2 * 4 u times the sum of |c_i t^i|, which is
// 20 at 1 and 180 at 3, where the slopes are 16 and 48: 10 u and 30 u; as much again for what is
// of second order.
TYPED_TEST(RoundedSurfaceTest, TorusIsCrossedWhereItsCirclesAre) {
  const RoundedSurface<TypeParam> ring(torus(2, 1));
  const Case across{{Primitive::Kind::Torus, {2, 1}}, torus(2, 1), {0, 0, 0}, {1, 0, 0}};
  const auto found = ring.crossings(this->ray(across), {});
  EXPECT_FALSE(found.starts_inside);
  EXPECT_FALSE(found.in_carrier);
  ASSERT_EQ(found.roots.count, 4);
  const std::array<int, 4> roots{-3, -1, 1, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(this->within(found.roots.t[i], Surd(roots[i], 0, 0), 20)) << found.roots.t[i];
  }
  // Through the hole, and up through the tube: t^2 = 1 and t^2 + 15 = 0 (Monotone is exact to
  // the bound for (t^2 - 1)(t^2 + 15) = t^4 + 14 t^2 - 15: 8 u * 30 / 32 at 1).
  const Case hole{across.primitive, across.surface, {0, 0, -3}, {0, 0, 1}};
  EXPECT_EQ(ring.crossings(this->ray(hole), {}).roots.count, 0);
  const Case tube{across.primitive, across.surface, {2, 0, 0}, {0, 0, 1}};
  const auto up = ring.crossings(this->ray(tube), {});
  ASSERT_EQ(up.roots.count, 2);
  EXPECT_TRUE(this->within(up.roots.t[0], Surd(-1, 0, 0), 15));
  EXPECT_TRUE(this->within(up.roots.t[1], Surd(1, 0, 0), 15));
}

// At points of small whole numbers f and its gradient are exact.
TYPED_TEST(RoundedSurfaceTest, InsideAndGradientAreThoseOfTheEquation) {
  constexpr std::uint64_t kCases = 600;
  support::ClassTally reached{"inside", "on", "outside", "torus"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    base::SeededStream stream("surface/rounded_inside", 1, case_id);
    const Case in = random_case(stream, true);
    SCOPED_TRACE(case_id);
    const RoundedSurface<TypeParam> surface(in.surface);
    const std::array<Rational, 3> point = point_at(in, 0);
    const Rational value = value_at(in, point);
    EXPECT_EQ(surface.inside(this->vector(in.origin)), value <= 0);
    const auto gradient = surface.gradient(this->vector(in.origin));
    const std::array<Rational, 3> actual{TestFixture::Traits::to_exact(gradient.x),
                                         TestFixture::Traits::to_exact(gradient.y),
                                         TestFixture::Traits::to_exact(gradient.z)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // The derivative of a quartic from five of its values.
      const auto at = [&](int h) {
        std::array<Rational, 3> there = point;
        there[axis] += h;
        return value_at(in, there);
      };
      EXPECT_EQ(actual[axis], (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / 12) << axis;
    }
    reached.add(value < 0 ? "inside" : value == 0 ? "on" : "outside");
    reached.add("torus", in.surface.kind == Kind::Torus);
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 30)) << reached;
}

TYPED_TEST(RoundedSurfaceTest, ARayInTheSurfaceIsOutsideAndCrossesNothing) {
  const std::vector<Case> cases{
      {{}, plane({0, 0, 1}, 2), {1, 1, 2}, {1, 2, 0}},
      {{}, infinite_cylinder(2), {0, 2, 1}, {0, 0, 1}},
      {{}, infinite_cone(1, 0), {2, 0, 2}, {-1, 0, -1}},
      {{},
       quadric({{{0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, -1}, {0, 0, 0, 0}}}),  // x y = z
       {0, 2, 0},
       {1, 0, 2}}};
  for (const Case& in : cases) {
    const auto found = RoundedSurface<TypeParam>(in.surface).crossings(this->ray(in), {});
    EXPECT_TRUE(found.in_carrier);
    EXPECT_FALSE(found.starts_inside);
    EXPECT_EQ(found.roots.count, 0);
  }
  // Beside it, the ray is inside or outside all along.
  for (const int x : {0, 3}) {
    const Case in{{}, infinite_cylinder(2), {x, 0, 0}, {0, 0, 1}};
    const auto found = RoundedSurface<TypeParam>(in.surface).crossings(this->ray(in), {});
    EXPECT_FALSE(found.in_carrier);
    EXPECT_EQ(found.starts_inside, x == 0);
  }
}

TYPED_TEST(RoundedSurfaceTest, AConeIsEnteredFromInfinityWhereItOpens) {
  const RoundedSurface<TypeParam> cone(infinite_cone(1, 0));
  const Case down{{}, infinite_cone(1, 0), {1, 0, 0}, {0, 0, 1}};
  const auto found = cone.crossings(this->ray(down), {});
  EXPECT_TRUE(found.starts_inside);
  ASSERT_EQ(found.roots.count, 2);
  EXPECT_EQ(found.roots.t[0], -1);
  EXPECT_EQ(found.roots.t[1], 1);
}

// Entries are rounded once; then the operations are those of points, directions and gradients.
TYPED_TEST(RoundedSurfaceTest, MapsRoundTheirEntriesOnce) {
  using Number = TypeParam;
  geometry::AffineMap exact;
  exact.rows = {geometry::AffineMap::Row{Rational(1) / 3, 0, 0, 5}, {0, 2, 3, -1}, {1, 0, 4, 7}};
  const RoundedMap<Number> map(exact);
  const auto third = TestFixture::Traits::from_exact(Rational(1) / 3);
  const typename TestFixture::Vector v{Number(2), Number(-1), Number(3)};
  const auto direction = map.direction(v);
  EXPECT_EQ(direction.x, Number(third * 2));
  EXPECT_EQ(direction.y, 7);
  EXPECT_EQ(direction.z, 14);
  const auto point = map.point(v);
  EXPECT_EQ(point.x, Number(third * 2) + 5);
  EXPECT_EQ(point.y, 6);
  EXPECT_EQ(point.z, 21);
  const auto gradient = map.gradient_to_world(v);
  EXPECT_EQ(gradient.x, Number(third * 2) + 3);
  EXPECT_EQ(gradient.y, -2);
  EXPECT_EQ(gradient.z, 9);
}

}  // namespace
}  // namespace lamina::surface
