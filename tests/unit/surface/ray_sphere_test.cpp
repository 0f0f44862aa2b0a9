#include "surface/ray_sphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/seeded_stream.hpp"
#include "poly/quadratic.hpp"
#include "support/class_tally.hpp"
#include "support/number_types.hpp"
#include "support/reference_surd.hpp"

namespace lamina::surface {
namespace {

using number::Rational;
using reference::Surd;

constexpr std::array<SphereFormula, 2> kFormulas{SphereFormula::Haines, SphereFormula::Pbrt};

template <typename Number>
class RaySphereTest : public ::testing::Test {
 protected:
  using Traits = number::number_traits<Number>;
  using Vector = geometry::Vector3<Number>;

  static Vector vector(const geometry::Vector3<double>& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
  }
  static geometry::ExactPoint exactly(const Vector& v) {
    return {Traits::to_exact(v.x), Traits::to_exact(v.y), Traits::to_exact(v.z)};
  }
};
TYPED_TEST_SUITE(RaySphereTest, support::RoundedNumberTypes, support::NumberNames);

struct Whole {
  geometry::Vector3<double> origin;
  geometry::Vector3<double> direction;
  int radius;
  std::vector<double> roots;
  int multiplicity = 1;
};

// Every step is exact in eleven bits. In the first ones (8, 4, -8) of length 12 is the point
// nearest to the centre, and (1, 2, 2) of length 3 the direction: with radius 15 half of the chord
// is 9.
TYPED_TEST(RaySphereTest, WholeNumbersGiveExactRoots) {
  const std::vector<Whole> cases{{{3, -6, -18}, {1, 2, 2}, 15, {2, 8}},
                                 {{13, 14, 2}, {1, 2, 2}, 15, {-8, -2}},
                                 {{3, -6, -18}, {-1, -2, -2}, 15, {-8, -2}},
                                 {{3, -6, -18}, {2, 4, 4}, 15, {1, 4}},
                                 {{3, -6, -18}, {0.25, 0.5, 0.5}, 15, {8, 32}},
                                 {{7, 2, -10}, {1, 2, 2}, 15, {-2, 4}},   // from inside
                                 {{9, 6, -6}, {1, 2, 2}, 15, {-4, 2}},    // from inside, going away
                                 {{8, 4, -8}, {1, 2, 2}, 15, {-3, 3}},    // from the nearest point
                                 {{5, -2, -14}, {1, 2, 2}, 15, {0, 6}},   // from the sphere
                                 {{11, 10, -2}, {1, 2, 2}, 15, {-6, 0}},  // to the sphere
                                 {{0, 0, 0}, {0, 0, 4}, 2, {-0.5, 0.5}},  // from the centre
                                 {{3, -6, -18}, {1, 2, 2}, 12, {5}, 2},   // tangents
                                 {{8, 4, -8}, {1, 2, 2}, 12, {0}, 2},
                                 {{-3, 1, 0}, {2, 0, 0}, 1, {1.5}, 2},
                                 {{3, -6, -18}, {1, 2, 2}, 11, {}},  // misses
                                 {{8, 4, -8}, {1, 2, 2}, 3, {}}};
  for (const Whole& in : cases) {
    for (const SphereFormula formula : kFormulas) {
      const auto roots = ray_sphere<TypeParam>(
          {this->vector(in.origin), this->vector(in.direction)}, TypeParam(in.radius), formula);
      SCOPED_TRACE(&in - cases.data());
      ASSERT_EQ(roots.count, in.roots.size());
      EXPECT_EQ(roots.outcome, poly::Outcome::Found);
      for (std::size_t i = 0; i < in.roots.size(); ++i) {
        EXPECT_EQ(roots.t[i], TypeParam(in.roots[i]));
        EXPECT_EQ(roots.multiplicity[i], in.multiplicity);
      }
    }
  }
}

// A ray whose chord of the unit sphere has half the length h, from the distance s to the centre. In
// units of u, and of lengths along the ray, with v its point nearest to the centre:
//   v        off by s of (b/a) d and |v| of the difference; along the ray by 7 s, of second order
//   1 - v.v  2 |v| (s + |v|), 5 of its own, and 50 u (s + 1)^2 of second order: less than 3 s + 8,
//            where u (s + 1) is at most 1/50
//   h        less than (1.8 s + 5) / h, where u (3 s + 8) is at most h^2 / 2; and 3 h of its own
//   q / a    3 s of b, what h has, and 5 (s + h) of the sum, of a and of the quotient
//   c / q    3 s of b, what h has, and 2 (s + 1) of the sum and of the quotient; of c at most
//            4 s^2 + 2 by q >= (s^2 - 1 + 2 h^2)^(1/2), less than 5 s + 1 for s >= 1.5, or 9 / h
double root_bound(double s, double h) { return 10 * s + (2 * s + 26) / h; }
bool is_bounded(double u, double s, double h) {
  return u * (s + 1) <= 1. / 50 && u * (3 * s + 8) <= h * h / 2;
}

// A ray from about this distance, with random bits to the last.
template <typename Number>
geometry::Ray<Number> random_ray(base::SeededStream& stream, double distance, double h) {
  const auto any = [&stream] {
    return geometry::Vector3<double>{stream.uniform(-1, 1), stream.uniform(-1, 1),
                                     stream.uniform(0.1, 1)};
  };
  const geometry::Vector3<double> along = normalised(any());
  const geometry::Vector3<double> across = normalised(cross(along, any()));
  const double length = stream.uniform(0.3, 3);
  const double v = std::sqrt(1 - h * h);
  const Number steps = Number(stream.chance(0.5) ? distance : -distance) / Number(length);
  geometry::Ray<Number> ray;
  const auto set = [&](Number& o, Number& d, double d_hat, double v_hat) {
    d = Number(3 * length * d_hat) / 3;
    o = Number(v * v_hat) - steps * d;
  };
  set(ray.origin.x, ray.direction.x, along.x, across.x);
  set(ray.origin.y, ray.direction.y, along.y, across.y);
  set(ray.origin.z, ray.direction.z, along.z, across.z);
  return ray;
}

// From far that is some u s for each root, unless the chord is short. The textbook's discriminant
// is off by some u s^2, and so its roots by about s times the bound.
TYPED_TEST(RaySphereTest, RootsKeepTheirBoundFromFarAndNear) {
  using Exact = typename TestFixture::Traits;
  constexpr std::uint64_t kCases = 300;
  constexpr int kBits = Exact::kSignificandBits;
  const double u = std::ldexp(1, -kBits);
  // 11 bits are enough for the bound from 16, 24 from 1000, and 53 or more from all.
  std::vector<double> distances{0.5, 16, 1e3, 1e6};
  distances.resize(kBits == 11 ? 2 : kBits == 24 ? 3 : 4);
  for (const double distance : distances) {
    const double shortest = std::max(1e-6, std::sqrt(2 * u * (3 * distance + 12)));
    support::ClassTally reached{"wide", "short", "wide, textbook far off", "more than 16 u s"};
    for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
      base::SeededStream stream("surface/ray_sphere", 1, case_id);
      const double aimed_at =
          case_id % 2 == 0 ? stream.uniform(0.6, 1) : std::pow(shortest, stream.unit());
      const auto ray = random_ray<TypeParam>(stream, distance, aimed_at);
      const geometry::ExactPoint o = this->exactly(ray.origin);
      const geometry::ExactPoint d = this->exactly(ray.direction);
      const Rational a = dot(d, d);
      const Rational b = dot(o, d);
      const Rational discriminant = b * b - a * (dot(o, o) - 1);
      const double s = std::sqrt(number::nearest_double(dot(o, o)));
      const double h = std::sqrt(std::max(0., number::nearest_double(discriminant / a)));
      if (!is_bounded(u, s, h)) {
        continue;  // rounded, the ray has another chord
      }
      const double unit = u / std::sqrt(number::nearest_double(a));
      const Rational inverse = 1 / a;
      const std::array<Surd, 2> truth{Surd(-b / a, -inverse, discriminant),
                                      Surd(-b / a, inverse, discriminant)};
      const auto within = [&](const auto& roots, double bound) {
        const Rational most(unit * bound);
        bool all = roots.count == 2;
        for (int i = 0; all && i < 2; ++i) {
          const Rational t = Exact::to_exact(roots.t[i]);
          all = compare(Surd(t - most, 0, 0), truth[i]) <= 0 &&
                compare(truth[i], Surd(t + most, 0, 0)) <= 0;
        }
        return all;
      };
      const double bound = root_bound(s, h);
      for (const SphereFormula formula : kFormulas) {
        const auto roots = ray_sphere<TypeParam>(ray, TypeParam(1), formula);
        EXPECT_TRUE(within(roots, bound)) << distance << ", case " << case_id << ", h " << h;
        reached.add("more than 16 u s", !within(roots, 16 * s));
      }
      const auto textbook = poly::quadratic_crossings<TypeParam>(
          dot(ray.direction, ray.direction), dot(ray.origin, ray.direction),
          dot(ray.origin, ray.origin) - TypeParam(1), poly::Solver::Textbook);
      reached.add("wide", h >= 0.5);
      reached.add("wide, textbook far off", h >= 0.5 && !within(textbook, distance / 100 * bound));
      reached.add("short", h < 0.1);
    }
    SCOPED_TRACE(distance);
    EXPECT_GE(reached.count("wide"), kCases / 3) << reached;
    if (distance >= 1e3) {
      EXPECT_GE(reached.count("wide, textbook far off"), kCases / 4) << reached;
    }
    // What the length of the chord has in the bound is needed.
    if (shortest < 0.01) {
      EXPECT_GE(reached.count("short"), kCases / 10) << reached;
      EXPECT_GE(reached.count("more than 16 u s"), kCases / 10) << reached;
    }
  }
}

}  // namespace
}  // namespace lamina::surface
