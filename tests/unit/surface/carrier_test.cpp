#include "surface/carrier.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"
#include "support/print.hpp"
#include "support/reference_faces.hpp"

namespace lamina::surface {
namespace {

using base::SeededStream;
using geometry::AffineMap;
using geometry::ExactPoint;
using geometry::ExactRay;
using number::Integer;
using number::IntegerPolynomial;
using number::Rational;

// The surface where `to_world` puts it.
OrientedCarrier placed(const LocalSurface& surface, const AffineMap& to_world = {}) {
  return carrier_of(surface, inverse(to_world).value());
}

LocalSurface times(const Rational& factor, LocalSurface surface) {
  for (Rational& coefficient : surface.coefficients) {
    coefficient *= factor;
  }
  return surface;
}

void expect_canonical(const Carrier& carrier) {
  Integer common = 0;
  int first = 0;
  for (const Integer& coefficient : carrier.coefficients) {
    common = gcd(common, coefficient);
    first = first == 0 ? coefficient.sign() : first;
  }
  EXPECT_EQ(common, 1);
  EXPECT_EQ(first, 1);
}

TEST(CarrierTest, OnePlaneHasOneCarrierWhateverItsEquationIsMultipliedBy) {
  const OrientedCarrier one = placed(plane({1, Rational(2) / 3, -3}, 7));
  expect_canonical(one.carrier);
  EXPECT_EQ(one.carrier.degree, 1);
  for (const Rational& factor : {Rational(5), Rational(1) / 7, Rational(-1), Rational(-4) / 9}) {
    const OrientedCarrier other = placed(plane({factor, 2 * factor / 3, -3 * factor}, 7 * factor));
    EXPECT_EQ(other.carrier, one.carrier) << factor;
    EXPECT_EQ(other.side, factor.sign() * one.side) << factor;
  }
  EXPECT_NE(placed(plane({1, Rational(2) / 3, -3}, 8)).carrier, one.carrier);
}

TEST(CarrierTest, OneQuadricHasOneCarrierWhateverItsEquationIsMultipliedBy) {
  for (const LocalSurface& surface :
       {sphere(Rational(2) / 3), infinite_cylinder(5), infinite_cone(Rational(1) / 2, 3)}) {
    const OrientedCarrier one = placed(surface);
    expect_canonical(one.carrier);
    EXPECT_EQ(one.carrier.degree, 2);
    for (const Rational& factor : {Rational(3), Rational(-2) / 5}) {
      const OrientedCarrier other = placed(times(factor, surface));
      EXPECT_EQ(other.carrier, one.carrier);
      EXPECT_EQ(other.side, factor.sign() * one.side);
    }
  }
}

TEST(CarrierTest, SidesTellInsideFromOutside) {
  for (const Rational& factor : {Rational(1), Rational(-1)}) {
    const auto [carrier, side] = placed(times(factor, sphere(2)), geometry::translation({5, 0, 0}));
    EXPECT_EQ(side * sign_at(carrier, {5, 1, 0}), -factor.sign());
    EXPECT_EQ(sign_at(carrier, {5, 0, 2}), 0);
    EXPECT_EQ(side * sign_at(carrier, {0, 0, 0}), factor.sign());
  }
}

TEST(CarrierTest, SurfacesThatMapsBringTogetherShareACarrier) {
  const AffineMap turn = geometry::rotation(2, {1, -3, 1});
  // A sphere is turned into itself, a cylinder about its axis, a mirror undoes a mirror.
  EXPECT_EQ(placed(sphere(2), turn).carrier, placed(sphere(2)).carrier);
  EXPECT_EQ(placed(infinite_cylinder(2), geometry::rotation(3, {0, 0, 1})).carrier,
            placed(infinite_cylinder(2)).carrier);
  EXPECT_EQ(placed(torus(3, 1), geometry::rotation(3, {0, 0, 2})).carrier,
            placed(torus(3, 1)).carrier);
  EXPECT_EQ(placed(torus(3, 1), geometry::reflection({0, 0, 5})).carrier,
            placed(torus(3, 1)).carrier);
  EXPECT_NE(placed(torus(3, 1), turn).carrier, placed(torus(3, 1)).carrier);
  // Top and bottom of neighbours: one plane, opposite sides.
  const AffineMap up = compose(turn, geometry::translation({0, 0, Rational(1) / 3}));
  const OrientedCarrier top = placed(plane({0, 0, 1}, Rational(1) / 3), turn);
  const OrientedCarrier bottom = placed(plane({0, 0, -5}, 0), up);
  EXPECT_EQ(top.carrier, bottom.carrier);
  EXPECT_EQ(top.side, -bottom.side);
  // A larger sphere made small, and a sphere as an ellipsoid unstretched.
  EXPECT_EQ(
      placed(sphere(6), geometry::scaling({Rational(-1) / 3, Rational(1) / 3, Rational(1) / 3}))
          .carrier,
      placed(sphere(2)).carrier);
  EXPECT_EQ(
      placed(torus(6, 2), geometry::scaling({Rational(1) / 2, Rational(1) / 2, Rational(1) / 2}))
          .carrier,
      placed(torus(3, 1)).carrier);
}

TEST(CarrierTest, AQuadricWithoutSquaresIsAPlane) {
  // 3 x - 6 y + 12 = 0, in an asymmetric matrix.
  std::array<std::array<Rational, 4>, 4> matrix{};
  matrix[0][3] = 1;
  matrix[3][0] = 2;
  matrix[3][1] = -6;
  matrix[3][3] = 12;
  const OrientedCarrier drop = placed(quadric(matrix), geometry::rotation(1, {2, 3, 4}));
  const OrientedCarrier flat = placed(plane({1, -2, 0}, -4), geometry::rotation(1, {2, 3, 4}));
  EXPECT_EQ(drop.carrier, flat.carrier);
  EXPECT_EQ(drop.carrier.degree, 1);
  EXPECT_EQ(drop.side, flat.side);
  // x - y = 0 twice is no plane.
  std::array<std::array<Rational, 4>, 4> twice{};
  twice[0][0] = twice[1][1] = 1;
  twice[0][1] = -2;
  EXPECT_EQ(placed(quadric(twice)).carrier.degree, 2);
}

TEST(CarrierTest, AConstantIsRefused) {
  std::array<std::array<Rational, 4>, 4> matrix{};
  EXPECT_THROW(placed(quadric(matrix)), base::InputError);
  matrix[3][3] = 5;
  EXPECT_THROW(placed(quadric(matrix)), base::InputError);
}

TEST(CarrierTest, ATorusHasItsLensOutside) {
  const auto [ring, ring_side] = placed(torus(3, 1));
  EXPECT_EQ(ring.degree, 4);
  expect_canonical(ring);
  EXPECT_EQ(ring_side * sign_at(ring, {3, 0, 0}), -1);
  EXPECT_EQ(ring_side * sign_at(ring, {0, 0, 0}), 1);
  EXPECT_EQ(sign_at(ring, {0, 4, 0}), 0);
  EXPECT_EQ(sign_at(ring, {0, 3, 1}), 0);
  const auto [spindle, side] = placed(torus(1, 2));
  EXPECT_EQ(side * sign_at(spindle, {0, 0, 0}), 1);
  EXPECT_EQ(side * sign_at(spindle, {2, 0, 0}), -1);
}

// A primitive of one half-space with coefficients that are small, but few of them whole.
reference::Primitive random_primitive(SeededStream& stream) {
  using reference::Primitive;
  const auto draw = [&stream](int low) {
    const Rational numerator = stream.integer(low, 9);
    return Rational(numerator / stream.integer(1, 9));
  };
  const auto several = [&draw](std::size_t count, int low) {
    std::vector<Rational> numbers;
    for (std::size_t i = 0; i < count; ++i) {
      numbers.push_back(draw(low));
    }
    return numbers;
  };
  switch (stream.below(4)) {
    case 0:
      return {Primitive::Kind::Sphere, several(1, 1)};
    case 1:
      return {Primitive::Kind::Torus, several(2, 1)};
    case 2: {
      std::vector<Rational> numbers = several(4, -9);
      numbers[0] += 20;
      return {Primitive::Kind::HalfSpace, numbers};
    }
    default: {
      std::vector<Rational> numbers = several(16, -9);
      numbers[0] += 20;
      return {Primitive::Kind::Quadric, numbers};
    }
  }
}

LocalSurface surface_of(const reference::Primitive& primitive) {
  using reference::Primitive;
  const auto& n = primitive.numbers;
  switch (primitive.kind) {
    case Primitive::Kind::Sphere:
      return sphere(n[0]);
    case Primitive::Kind::Torus:
      return torus(n[0], n[1]);
    case Primitive::Kind::HalfSpace:
      return plane({n[0], n[1], n[2]}, n[3]);
    default: {
      std::array<std::array<Rational, 4>, 4> matrix;
      for (std::size_t i = 0; i < 16; ++i) {
        matrix[i / 4][i % 4] = n[i];
      }
      return quadric(matrix);
    }
  }
}

ExactPoint point_of(const reference::Vector& v) { return {v[0], v[1], v[2]}; }

// Along a ray the carrier is the primitive's own equation times one positive number, and so is
// its gradient; in the whole of space that number has the side's sign.
TEST(CarrierTest, RestrictionEqualsTheEquationAtRationalPoints) {
  constexpr std::uint64_t kCases = 400;
  support::ClassTally reached{"inside",   "outside",  "on",      "turned",
                              "degree 1", "degree 2", "degree 4"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    SCOPED_TRACE(case_id);
    SeededStream stream("surface/carrier", 1, case_id);
    const auto draw = [&stream] {
      const Rational numerator = stream.integer(-9, 9);
      return Rational(numerator / stream.integer(1, 5));
    };
    const reference::Primitive primitive = random_primitive(stream);
    reference::Chain chain;
    AffineMap to_world;
    if (stream.chance(0.7)) {
      const std::vector<Rational> q{1, draw(), draw(), draw()};
      const std::vector<Rational> v{draw(), draw(), draw()};
      chain = {{reference::Step::Kind::Rotate, q}, {reference::Step::Kind::Translate, v}};
      to_world = compose(geometry::rotation(q[0], {q[1], q[2], q[3]}),
                         geometry::translation({v[0], v[1], v[2]}));
      reached.add("turned");
    }
    const OrientedCarrier oriented = placed(surface_of(primitive), to_world);
    const Carrier& carrier = oriented.carrier;
    const int side = oriented.side;
    expect_canonical(carrier);
    reached.add("degree " + std::to_string(carrier.degree));
    const auto equation = [&](const reference::Vector& world) {
      return reference::faces_at<Rational>(
          primitive, reference::to_local(chain, world, reference::Kind::Point))[0];
    };

    reference::Vector origin{draw(), draw(), draw()};
    if (primitive.kind == reference::Primitive::Kind::Sphere && stream.chance(0.3)) {
      origin = reference::to_world(chain, {primitive.numbers[0], 0, 0}, reference::Kind::Point);
    }
    const reference::Vector direction{draw(), draw(), Rational(1) / 3};
    const IntegerPolynomial along =
        RayMonomials(ExactRay{point_of(origin), point_of(direction)}).restrict(carrier);
    EXPECT_LE(along.degree(), carrier.degree);
    // Values at t, and the factor between the two from one that is not zero.
    const auto value = [&along](const Rational& t) {
      Rational sum = 0;
      for (std::size_t i = along.coefficients().size(); i-- > 0;) {
        sum = sum * t + Rational(along[i]);
      }
      return sum;
    };
    Rational factor = 0;
    for (const Rational& t : {Rational(0), Rational(1), Rational(-2), Rational(3) / 7,
                              Rational(-5) / 3, Rational(100)}) {
      reference::Vector point = origin;
      for (std::size_t i = 0; i < 3; ++i) {
        point[i] += t * direction[i];
      }
      const Rational expected = side * equation(point);
      EXPECT_EQ(along.sign_at(t), expected.sign()) << t;
      EXPECT_EQ(sign_at(carrier, point_of(point)), expected.sign()) << t;
      reached.add(expected * side < 0 ? "inside" : expected == 0 ? "on" : "outside");
      if (expected != 0) {
        factor = factor == 0 ? Rational(value(t) / expected) : factor;
        EXPECT_GT(factor, 0);
        EXPECT_EQ(value(t), factor * expected) << t;
      }
    }
    // The derivative of a quartic from five of its values, exact for all that are lower too.
    const auto slope = [&](std::size_t axis) {
      const auto at = [&](int h) {
        reference::Vector point = origin;
        point[axis] += h;
        return Rational(side * equation(point));
      };
      return Rational((8 * (at(1) - at(-1)) - (at(2) - at(-2))) / 12);
    };
    const ExactPoint gradient = gradient_at(carrier, point_of(origin));
    const ExactPoint expected{slope(0), slope(1), slope(2)};
    EXPECT_EQ(cross(gradient, expected), (ExactPoint{0, 0, 0}));
    EXPECT_EQ(dot(gradient, expected).sign(), expected == ExactPoint{} ? 0 : 1);
  }
  EXPECT_TRUE(reached.each_at_least(kCases / 20)) << reached;
}

TEST(CarrierTest, ARayInASurfaceHasTheZeroPolynomial) {
  const Carrier cylinder = placed(infinite_cylinder(2)).carrier;
  EXPECT_TRUE(RayMonomials({{2, 0, 5}, {0, 0, 1}}).restrict(cylinder).is_zero());
  EXPECT_FALSE(RayMonomials({{1, 0, 5}, {0, 0, 1}}).restrict(cylinder).is_zero());
  EXPECT_EQ(RayMonomials({{1, 0, 5}, {0, 0, 1}}).restrict(cylinder).degree(), 0);
  const Carrier cone = placed(infinite_cone(1, 0)).carrier;
  EXPECT_TRUE(RayMonomials({{3, 0, 3}, {-1, 0, -1}}).restrict(cone).is_zero());
}

TEST(CarrierTest, OrderIsTotal) {
  std::vector<Carrier> carriers;
  for (const LocalSurface& surface :
       {torus(3, 1), sphere(2), sphere(3), plane({1, 0, 0}, 1), plane({1, 0, 0}, 2),
        plane({0, 1, 0}, 1), infinite_cylinder(2)}) {
    carriers.push_back(placed(surface).carrier);
  }
  std::sort(carriers.begin(), carriers.end());
  for (std::size_t i = 0; i + 1 < carriers.size(); ++i) {
    EXPECT_TRUE(carriers[i] < carriers[i + 1]);
    EXPECT_FALSE(carriers[i + 1] < carriers[i]);
    EXPECT_TRUE(carriers[i] == carriers[i]);
  }
}

}  // namespace
}  // namespace lamina::surface
