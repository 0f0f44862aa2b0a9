// Swept contours in rounded numbers: what a rectangle rules out, and, where rounding is far below
// anything that a random ray could need, the same crossings as exactly, with right normals.
#include "geometry/rounding.hpp"
#include "surface/rounded_sweep.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "number/traits.hpp"
#include "support/class_tally.hpp"
#include "support/random_sweeps.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using geometry::Ray;
using geometry::Vector3;
using number::Rational;
using surface::RoundedSweep;
using surface::Sweep;
using surface::SweptSurface;

constexpr std::uint64_t kSeed = 1;

template <typename Number>
ExactPoint exactly(const Vector3<Number>& p) {
  using Traits = number::number_traits<Number>;
  return {Traits::to_exact(p.x), Traits::to_exact(p.y), Traits::to_exact(p.z)};
}

// A multiple of 6/64: then the pieces of a B-spline have coefficients on a grid of 1/64 too.
std::vector<PlanePoint> times_six(std::vector<PlanePoint> points) {
  for (PlanePoint& p : points) {
    p = {6 * p.u, 6 * p.v};
  }
  return points;
}

// u or v of a piece, and its slope, in double.
struct Curve {
  std::array<double, 4> c{};

  explicit Curve(const std::vector<Rational>& exact) {
    std::transform(exact.begin(), exact.end(), c.begin(),
                   [](const Rational& x) { return number::nearest_double(x); });
  }
  [[nodiscard]] double at(double s) const { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; }
  [[nodiscard]] double slope_at(double s) const { return (3 * c[3] * s + 2 * c[2]) * s + c[1]; }
};

// A ray through a point of a piece: at a joint, tangent to the contour, where a rectangle is only
// just hit, or any, by `place`. All numbers are on grids that are coarse enough for double to have
// them exactly, as passes_through() finds.
struct Passage {
  Ray<double> ray;
  double t;
  double s;
};

Passage ray_through(SeededStream& stream, Sweep sweep, const Curve& u_of, const Curve& v_of,
                    std::uint64_t place) {
  const auto multiple_of_64th = [](double x) { return std::nearbyint(64 * x) / 64; };
  const auto any = [&] { return multiple_of_64th(stream.uniform(-1, 1)); };
  const double s = place == 0 ? 0 : static_cast<double>(stream.integer(0, 7)) / 8;
  const double u = u_of.at(s);
  const double v = v_of.at(s);
  const double du = u_of.slope_at(s);
  const double dv = v_of.slope_at(s);
  Vector3<double> p;
  Vector3<double> along;
  switch (sweep) {
    case Sweep::Translational:
      p = {u, v, 2 * any()};
      along = {du, dv, static_cast<double>(stream.integer(-2, 2))};
      break;
    case Sweep::Conic: {
      const double z = stream.chance(0.5) ? 2 : -0.5;
      p = {u * z, v * z, z};
      along = {du, dv, 0};
      break;
    }
    case Sweep::Rotational:
      p = stream.chance(0.5) ? Vector3<double>{u, 0, v} : Vector3<double>{0, -u, v};
      along = p.y == 0 ? Vector3<double>{du, 0, dv} : Vector3<double>{0, -du, dv};
      break;
    case Sweep::GeneralisedConic:
      break;
  }
  const Vector3<double> d = place == 1 ? along : Vector3<double>{any(), any(), any() + 2};
  const auto t = static_cast<double>(stream.integer(-64, 64));
  return {{p - t * d, d}, t, s};
}

// Is the ray's point at t exactly that of the piece at s? In rationals.
bool passes_through(const Passage& passage, Sweep sweep, const geometry::ContourPiece& piece) {
  const ExactPoint p =
      exactly(passage.ray.origin) + Rational(passage.t) * exactly(passage.ray.direction);
  const Rational u = geometry::value_at(piece.u, Rational(passage.s));
  const Rational v = geometry::value_at(piece.v, Rational(passage.s));
  switch (sweep) {
    case Sweep::Translational:
      return p.x == u && p.y == v;
    case Sweep::Conic:
      return p.x == u * p.z && p.y == v * p.z;
    case Sweep::Rotational:
      return p.x * p.x + p.y * p.y == u * u && p.z == v;
    case Sweep::GeneralisedConic:
      break;
  }
  return false;
}

template <typename Number>
bool holds(const Vector3<double>& v) {
  const auto same = [](double x) { return static_cast<double>(static_cast<Number>(x)) == x; };
  return same(v.x) && same(v.y) && same(v.z);
}

Vector3<float> in_float(const Vector3<double>& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

TEST_CASE("No rectangle rules out a piece that a ray meets exactly", "[swept]") {
  constexpr int kContours = 400;
  constexpr int kRays = 850;  // of each contour and sweep: 10^6 in all
  std::uint64_t met = 0;
  std::uint64_t pairs = 0;
  std::uint64_t accepted = 0;
  support::ClassTally tally{"joint", "tangent", "any", "exact in float"};
  for (std::uint64_t c = 0; c < kContours; ++c) {
    for (const Sweep sweep : support::kSweeps) {
      SeededStream stream("rectangles", kSeed,
                          c * support::kSweeps.size() + static_cast<std::uint64_t>(sweep));
      const geometry::ContourKind kind = support::kKinds.at(c % support::kKinds.size());
      const std::optional<SweptSurface> surface =
          support::swept_surface(sweep, times_six(support::any_star(stream, {2, 0})), kind, true);
      if (!surface) {
        continue;
      }
      const RoundedSweep<double> doubles(*surface);
      const RoundedSweep<float> floats(*surface);
      std::vector<Curve> u;
      std::vector<Curve> v;
      for (const geometry::ContourPiece& piece : surface->contour().pieces()) {
        u.emplace_back(piece.u);
        v.emplace_back(piece.v);
        REQUIRE(std::equal(piece.u.begin(), piece.u.end(), u.back().c.begin()));
        REQUIRE(std::equal(piece.v.begin(), piece.v.end(), v.back().c.begin()));
      }
      for (int r = 0; r < kRays; ++r) {
        const auto piece = static_cast<std::uint32_t>(stream.below(u.size()));
        const std::uint64_t place = stream.below(3);
        tally.add(place == 0 ? "joint" : place == 1 ? "tangent" : "any");
        const Passage passage = ray_through(stream, sweep, u[piece], v[piece], place);
        const Ray<double>& ray = passage.ray;
        // Rationals take a hundred times as long: one ray of 50.
        if (r % 50 == 0) {
          REQUIRE(passes_through(passage, sweep, surface->contour().pieces()[piece]));
        }
        // Assertions alone take longer than what they are about.
        ++met;
        if (doubles.rules_out(ray, piece)) {
          FAIL("double: piece " << piece << " of contour " << c << ", ray " << r);
        }
        if (holds<float>(ray.origin) && holds<float>(ray.direction)) {
          tally.add("exact in float");
          if (floats.rules_out({in_float(ray.origin), in_float(ray.direction)}, piece)) {
            FAIL("float: piece " << piece << " of contour " << c << ", ray " << r);
          }
        }
        for (std::uint32_t i = 0; i < u.size(); ++i) {
          ++pairs;
          accepted += doubles.rules_out(ray, i) ? 0 : 1;
        }
      }
    }
  }
  INFO(tally << ", met " << met << ", accepted " << accepted << " of " << pairs);
  CHECK(met >= 900'000);
  CHECK(tally.each_at_least(100'000));
  CHECK(accepted < pairs / 2);  // it does rule out: with these contours 65 % of the pieces
}

// Rounding by 2^-237 moves a t by 2^-100 only where its condition is 2^137: no random ray's is.
using Wide = number::bin<237>;

TEST_CASE("Crossings and normals of swept contours in 237 bits", "[swept]") {
  constexpr int kContours = 24;
  constexpr int kRays = 12;
  const Rational close(1, number::Integer(1) << 100);
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  for (const Sweep sweep : support::kSweepsOfAllKinds) {
    for (const geometry::ContourKind kind : support::kKinds) {
      // A ray at a generalised conic sweep takes ten times as long.
      const std::uint64_t contours = sweep == Sweep::GeneralisedConic ? kContours / 4 : kContours;
      for (std::uint64_t c = 0; c < contours; ++c) {
        SeededStream stream(
            "swept in 237 bits", kSeed,
            (static_cast<std::uint64_t>(sweep) * 3 + static_cast<std::uint64_t>(kind)) * kContours +
                c);
        const std::optional<SweptSurface> surface = support::any_swept_surface(stream, sweep, kind);
        if (!surface) {
          continue;
        }
        const RoundedSweep<Wide> rounded(*surface);
        for (int r = 0; r < kRays; ++r) {
          const auto any = [&stream](double size) -> ExactPoint {
            return {Rational(stream.uniform(-size, size)), Rational(stream.uniform(-size, size)),
                    Rational(stream.uniform(-size, size))};
          };
          const ExactPoint origin = any(20);
          ExactPoint target = any(1);
          target.x += sweep == Sweep::Rotational ? 2 : 0;
          ExactRay ray{origin, target - origin};
          if (r == 0) {
            ray.direction.z = 0;  // a level ray of a rotational sweep has an equation of its own
          }
          const Ray<Wide> local{geometry::rounded<Wide>(ray.origin),
                                geometry::rounded<Wide>(ray.direction)};
          const auto truth = surface->crossings(ray);
          REQUIRE_FALSE(truth.in_boundary);
          std::vector<RoundedSweep<Wide>::Crossing> found;
          rounded.find_crossings(local, {}, found);
          ++rays;
          REQUIRE(found.size() == truth.crossings.size());
          for (std::size_t i = 0; i < found.size(); ++i) {
            const number::Enclosure t = enclosure(truth.crossings[i].t, 120);
            const Rational at = number::number_traits<Wide>::to_exact(found[i].t);
            REQUIRE(at > t.lower - close);
            REQUIRE(at < t.upper + close);
            REQUIRE(found[i].piece == truth.crossings[i].piece);
            ++hits;

            // Two rays beside this one, which meet the surface next to the crossing: the chords
            // are at right angles to the normal, but for the bend of the surface. A chord is 2^-70
            // long, or 2^-70 / c where c is the cosine between ray and normal, and the angle it is
            // off by half of that times the curvature k: below 2^-40 if k / c < 2^30. Of rounding
            // 2^-237 times a condition is left in 2^-70.
            const Vector3<Wide> p = local.origin + found[i].t * local.direction;
            const Vector3<Wide> n = rounded.normal(p, found[i]);
            const Wide h = ldexp(Wide(1), -70);
            for (const Vector3<Wide>& aside :
                 {Vector3<Wide>{h, h / 3, h / 7}, Vector3<Wide>{-h / 5, h, -h / 2}}) {
              const Ray<Wide> beside{local.origin + aside, local.direction};
              std::vector<RoundedSweep<Wide>::Crossing> near;
              rounded.find_crossings(beside, {}, near);
              REQUIRE(near.size() == found.size());
              const Vector3<Wide> chord = beside.origin + near[i].t * beside.direction - p;
              const Wide cosine = dot(chord, n) / sqrt(dot(chord, chord) * dot(n, n));
              REQUIRE(abs(cosine) < ldexp(Wide(1), -40));
            }
            // Outward: no solid here is as thin as 2^-40, nor bent like that, where a ray hits it.
            const Wide length = sqrt(dot(n, n));
            const Vector3<Wide> step = Wide(ldexp(Wide(1), -40) / length) * n;
            REQUIRE(surface->side(exactly(p + step)) == 1);
            REQUIRE(surface->side(exactly(p - step)) == -1);
          }
        }
      }
    }
  }
  INFO("rays " << rays << ", crossings " << hits);
  CHECK(rays > 2000);
  CHECK(hits > 1500);
}

}  // namespace
}  // namespace lamina
