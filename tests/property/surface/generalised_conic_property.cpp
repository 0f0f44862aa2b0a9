// Generalised conic sweeps against the plane of their contour: a point is inside where the contour,
// swept straight, has what it is scaled from.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "geometry/ray_text.hpp"
#include "geometry/rounding.hpp"
#include "support/class_tally.hpp"
#include "support/random_sweeps.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ExactPoint;
using geometry::ExactRay;
using number::Rational;
using surface::Sweep;
using surface::SweptSurface;

constexpr std::uint64_t kSeed = 1;

// The powers of z summed one by one: not how the surface does it.
Rational polynomial_at(const std::vector<Rational>& ascending, const Rational& z) {
  Rational sum = 0;
  Rational power = 1;
  for (const Rational& c : ascending) {
    sum += c * power;
    power *= z;
  }
  return sum;
}

// -1 inside, 1 outside, 0 where that is not told: at a height that is scaled to nothing, or on the
// surface.
int side_by_plane(const SweptSurface& surface, const SweptSurface& straight, const ExactPoint& p) {
  const Rational scale_x = polynomial_at(surface.scaling().x, p.z);
  const Rational scale_y = polynomial_at(surface.scaling().y, p.z);
  return scale_x == 0 || scale_y == 0 ? 0 : straight.side({p.x / scale_x, p.y / scale_y, 0});
}

ExactRay any_ray(SeededStream& stream) {
  const auto any = [&stream](double size) -> ExactPoint {
    return {support::any_dyadic(stream, -size, size), support::any_dyadic(stream, -size, size),
            support::any_dyadic(stream, -size, size)};
  };
  const ExactPoint origin = any(3);
  ExactRay ray{origin, any(1) - origin};
  if (stream.chance(0.15)) {
    ray.direction.z = 0;
  } else if (stream.chance(0.15)) {
    ray.direction = {0, 0, 1};
  }
  return ray;
}

TEST_CASE("Generalised conic sweeps are crossed where the place in the plane changes sides",
          "[swept]") {
  constexpr std::uint64_t kContours = 12;
  constexpr int kRays = 12;
  constexpr int kSamples = 48;  // from t = -4 to 4
  support::ClassTally tally(
      {"inside", "outside", "crossed", "crossed often", "level", "upright", "starts inside"});
  for (const geometry::ContourKind kind : support::kKinds) {
    for (std::uint64_t c = 0; c < kContours; ++c) {
      SeededStream stream("generalised conic", kSeed,
                          static_cast<std::uint64_t>(kind) * kContours + c);
      std::optional<SweptSurface> surface;
      while (!surface) {
        surface = support::any_swept_surface(stream, Sweep::GeneralisedConic, kind);
      }
      const SweptSurface straight(Sweep::Translational,
                                  std::make_shared<const geometry::Contour>(surface->contour()));
      for (int r = 0; r < kRays; ++r) {
        const ExactRay ray = any_ray(stream);
        const auto found = surface->crossings(ray);
        if (found.in_boundary) {
          continue;
        }
        const auto side_at = [&](const Rational& t) {
          return side_by_plane(*surface, straight, ray.origin + t * ray.direction);
        };
        // By the number of crossings before it.
        const auto expect_side = [&](const Rational& t) {
          bool inside = found.starts_inside;
          bool on_surface = false;
          for (const auto& crossing : found.crossings) {
            const auto order = compare(crossing.t, t);
            inside = order < 0 ? !inside : inside;
            on_surface = on_surface || order == 0;
          }
          const int side = side_at(t);
          INFO(surface->contour().points().size()
               << " points, ray " << to_text(ray) << ", t " << number::to_text(t));
          if (side != 0) {
            REQUIRE_FALSE(on_surface);
            REQUIRE(side == (inside ? -1 : 1));
            tally.add(inside ? "inside" : "outside");
          }
        };
        for (int i = 0; i <= kSamples; ++i) {
          expect_side(Rational(8 * i, kSamples) - 4 + Rational(1, 97));
        }
        // Next to each crossing too: none is made up.
        for (const auto& crossing : found.crossings) {
          const number::Enclosure t = enclosure(crossing.t, 80);
          const Rational aside(1, number::Integer(1) << 70);
          expect_side(t.lower - aside);
          expect_side(t.upper + aside);
        }
        tally.add("crossed", !found.crossings.empty());
        tally.add("crossed often", found.crossings.size() > 2);
        tally.add("level", ray.direction.z == 0);
        tally.add("upright", ray.direction.x == 0 && ray.direction.y == 0);
        tally.add("starts inside", found.starts_inside);
      }
    }
  }
  INFO(tally);
  CHECK(tally.each_at_least(20));
}

// Rounding moves a root, and can only change their number where two are next to each other or at
// an end of a piece: no more than a few of random rays.
TEST_CASE("Generalised conic sweeps in double have nearly always the exact crossings", "[swept]") {
  constexpr std::uint64_t kContours = 20;
  constexpr int kRays = 20;
  int rays = 0;
  int crossings = 0;
  int wrong = 0;
  int far = 0;
  for (const geometry::ContourKind kind : support::kKinds) {
    for (std::uint64_t c = 0; c < kContours; ++c) {
      SeededStream stream("generalised conic in double", kSeed,
                          static_cast<std::uint64_t>(kind) * kContours + c);
      const auto surface = support::any_swept_surface(stream, Sweep::GeneralisedConic, kind);
      if (!surface) {
        continue;
      }
      const surface::RoundedSweep<double> rounded(*surface);
      for (int r = 0; r < kRays; ++r) {
        const ExactRay ray = any_ray(stream);
        const auto truth = surface->crossings(ray);
        if (truth.in_boundary) {
          continue;
        }
        std::vector<surface::RoundedSweep<double>::Crossing> found;
        rounded.find_crossings(geometry::rounded<double>(ray), {}, found);
        ++rays;
        crossings += static_cast<int>(truth.crossings.size());
        if (found.size() != truth.crossings.size()) {
          ++wrong;
          continue;
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
          const double t = number::nearest_double(truth.crossings[i].t);
          // Two equations of some 30 roundings, of numbers up to 4, or 1e-14; times 1e4 for the
          // condition of all but a few crossings, which graze the surface.
          far += std::abs(found[i].t - t) > 1e-10 * std::max(1.0, std::abs(t)) ? 1 : 0;
        }
      }
    }
  }
  INFO("rays " << rays << ", crossings " << crossings << ", wrong numbers " << wrong << ", far "
               << far);
  CHECK(crossings > 500);
  CHECK(wrong * 100 <= rays);
  CHECK(far * 100 <= crossings);
}

}  // namespace
}  // namespace lamina
