// Sphere sweeps: exactly, against an oracle that solves for the trajectory's parameter; in rounded
// numbers, against the exact ones.
#include "surface/sphere_sweep.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "geometry/rounding.hpp"
#include "number/traits.hpp"
#include "support/class_tally.hpp"
#include "support/random_trajectories.hpp"
#include "support/reference_sphere_sweep.hpp"
#include "surface/rounded_sphere_sweep.hpp"
#include "surface/rounded_surface.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::point_at;
using geometry::Trajectory;
using number::Rational;
using reference::SweptBall;
using support::any_dyadic;
using support::kKinds;
using surface::SphereSweep;
using Vector = geometry::Vector3<double>;

constexpr std::uint64_t kSeed = 1;
constexpr int kBits = 80;  // of enclosures of the roots under test

// As the code under test takes it, and as the oracle does.
struct Solid {
  SphereSweep surface;
  SweptBall reference;
};

SweptBall::Point coordinates(const ExactPoint& p) { return {p.x, p.y, p.z}; }

Solid any_solid(SeededStream& stream, ContourKind kind) {
  using Kind = reference::PlaneCurve::Kind;
  const auto trajectory = support::any_trajectory(stream, kind);
  const Rational radius(stream.integer(1, 8), 8);
  reference::SpaceCurve curve{kind == ContourKind::Line      ? Kind::Line
                              : kind == ContourKind::BSpline ? Kind::BSpline
                                                             : Kind::CatmullRom,
                              trajectory->closed(),
                              {}};
  for (const ExactPoint& p : trajectory->points()) {
    curve.points.push_back(coordinates(p));
  }
  return {SphereSweep(radius, trajectory), SweptBall(curve, radius)};
}

ExactPoint exactly(const Vector& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

Vector any_unit(SeededStream& stream) {
  while (true) {
    const Vector v{stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    if (dot(v, v) <= 1 && dot(v, v) > 0.01) {
      return normalised(v);
    }
  }
}

ExactPoint any_direction(SeededStream& stream) {
  ExactPoint d;
  while (d == ExactPoint{}) {
    d = {Rational(stream.integer(-8, 8), 4), Rational(stream.integer(-8, 8), 4),
         Rational(stream.integer(-8, 8), 4)};
  }
  return d;
}

enum class RayClass : std::uint8_t { Any, ThroughCurve, Grazing, AlongPiece, OnAxis };

constexpr std::array<RayClass, 8> kRayClasses{
    RayClass::Any,     RayClass::ThroughCurve, RayClass::Any,        RayClass::Grazing,
    RayClass::Grazing, RayClass::Any,          RayClass::AlongPiece, RayClass::OnAxis};

ExactRay any_ray(SeededStream& stream, const Solid& solid, RayClass cls) {
  const auto& pieces = solid.reference.pieces();
  const SweptBall::Piece& piece = pieces[stream.below(pieces.size())];
  const Rational u(stream.integer(0, 8), 8);
  const auto at = [&](const SweptBall::Polynomial& c) { return geometry::value_at(c, u); };
  const auto slope = [&](const SweptBall::Polynomial& c) {
    Rational value = 0;
    for (std::size_t i = c.size() - 1; i > 0; --i) {
      value = value * u + static_cast<int>(i) * c[i];
    }
    return value;
  };
  const ExactPoint centre{at(piece[0]), at(piece[1]), at(piece[2])};
  const ExactPoint tangent{slope(piece[0]), slope(piece[1]), slope(piece[2])};
  const double radius = number::nearest_double(solid.surface.radius());
  const Rational t(stream.integer(-8, 8), 2);
  switch (cls) {
    case RayClass::ThroughCurve: {
      const ExactPoint d = any_direction(stream);
      return {centre - t * d, d};
    }
    case RayClass::Grazing: {
      // Past a point next to the surface, in its tangent plane.
      const Vector n = normalised(cross(nearest_double(tangent), any_unit(stream)));
      const double off = std::pow(10.0, stream.uniform(-9, -1)) * (stream.chance(0.5) ? 1 : -1);
      const Vector target = nearest_double(centre) + radius * (1 + off) * n;
      const Vector d = cross(n, any_unit(stream));
      return {exactly(target - 4.0 * d), exactly(d)};
    }
    case RayClass::AlongPiece: {
      // At a distance that may be the radius, if the tangent is parallel to the x axis.
      const ExactPoint d = tangent == ExactPoint{} ? any_direction(stream) : tangent;
      const Rational off = solid.surface.radius() * Rational(stream.integer(0, 5), 4);
      const ExactPoint aside = stream.chance(0.5) ? ExactPoint{0, off, 0} : ExactPoint{0, 0, off};
      return {centre + aside - t * d, d};
    }
    case RayClass::OnAxis: {
      // Through the ball at a piece's end as few others see it.
      const ExactPoint axis = stream.chance(0.5) ? ExactPoint{0, 0, 1} : ExactPoint{0, 1, 0};
      const Rational off = solid.surface.radius() * Rational(stream.integer(-4, 4), 4);
      return {ExactPoint{centre.x + off, centre.y, centre.z} - t * axis, axis};
    }
    case RayClass::Any:
      break;
  }
  const Vector target = nearest_double(centre) + 1.3 * radius * stream.unit() * any_unit(stream);
  const Vector origin = target + std::pow(10.0, stream.uniform(0, 3)) * any_unit(stream);
  return {exactly(origin), exactly(target - origin)};
}

std::string text_of(const Solid& solid, const ExactRay& ray) {
  std::ostringstream out;
  const Trajectory& trajectory = solid.surface.trajectory();
  out << "sphere_sweep(" << solid.surface.radius() << ") contour([";
  for (const ExactPoint& p : trajectory.points()) {
    out << '[' << p.x << ", " << p.y << ", " << p.z << "], ";
  }
  const auto& [o, d] = ray;
  out << "], kind=\"" << name_of(trajectory.kind())
      << "\", closed=" << (trajectory.closed() ? "true" : "false") << "); the ray from " << o.x
      << ' ' << o.y << ' ' << o.z << " towards " << d.x << ' ' << d.y << ' ' << d.z;
  return out.str();
}

// Rationals between the crossings, and one before and one after them.
std::vector<Rational> between(const std::vector<number::Root>& crossings) {
  if (crossings.empty()) {
    return {-3, 0, 3};
  }
  std::vector<Rational> result{enclosure(crossings.front(), kBits).lower - 1};
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    result.push_back(
        (enclosure(crossings[i - 1], kBits).upper + enclosure(crossings[i], kBits).lower) / 2);
  }
  result.push_back(enclosure(crossings.back(), kBits).upper + 1);
  return result;
}

// Whether the points between the crossings are on their sides, for the oracle and the code.
std::string fault_between(const Solid& solid, const ExactRay& ray,
                          const std::vector<number::Root>& crossings, support::ClassTally& tally) {
  int expected = 1;
  for (const Rational& t : between(crossings)) {
    const ExactPoint p = ray.origin + t * ray.direction;
    const std::optional<int> truth = solid.reference.side(coordinates(p));
    tally.add("points");
    tally.add("undecided points", !truth);
    if (truth && *truth != 0 && *truth != expected) {
      return "the point at t = " + number::to_text(t) + " is on the other side";
    }
    if (solid.surface.side(p) != truth.value_or(solid.surface.side(p))) {
      return "the side of the point at t = " + number::to_text(t) + " is another";
    }
    expected = crossings.empty() ? 1 : -expected;
  }
  return "";
}

std::string fault(const Solid& solid, const ExactRay& ray, support::ClassTally& tally) {
  const SphereSweep::Crossings found = solid.surface.crossings(ray);
  const SweptBall::Crossings truth =
      solid.reference.crossings(coordinates(ray.origin), coordinates(ray.direction));
  tally.add("in the boundary", found.in_boundary);
  const auto pieces = solid.surface.trajectory().pieces();
  tally.add("on a parabola", std::any_of(pieces.begin(), pieces.end(),
                                         [](const auto& piece) { return piece[0].size() == 3; }));
  if (truth.has_piece_along) {
    tally.add("piece along");
    return found.in_boundary ? "" : fault_between(solid, ray, found.t, tally);
  }
  if (found.in_boundary) {
    return "the ray does not run along the surface";
  }
  if (truth.is_inseparable) {
    tally.add("inseparable");
    return fault_between(solid, ray, found.t, tally);
  }
  tally.add("certain");
  tally.add("crossed", !truth.crossings.empty());
  tally.add("crossed often", truth.crossings.size() > 2);
  tally.add("overlaps", truth.overlaps > 0);
  if (found.t.size() != truth.crossings.size()) {
    return std::to_string(found.t.size()) + " crossings, not " +
           std::to_string(truth.crossings.size());
  }
  for (std::size_t i = 0; i < truth.crossings.size(); ++i) {
    const number::Enclosure bounds = enclosure(found.t[i], kBits);
    const auto& [lower, upper] = truth.crossings[i];
    if (bounds.upper < lower || bounds.lower > upper) {
      return "crossing " + std::to_string(i) + " is elsewhere";
    }
  }
  return "";
}

support::ClassTally new_tally() {
  return {"on a parabola", "certain",     "crossed",         "crossed often", "overlaps",
          "inseparable",   "piece along", "in the boundary", "points",        "undecided points"};
}

TEST_CASE("A ray crosses a sphere sweep where the oracle has it", "[swept]") {
  // Straight pieces take a tenth of the time of the others.
  constexpr std::array<std::uint64_t, 3> kSolids{150, 14, 14};
  constexpr std::uint64_t kRays = 32;
  support::ClassTally tally = new_tally();
  for (const ContourKind kind : kKinds) {
    for (std::uint64_t s = 0; s < kSolids.at(static_cast<std::size_t>(kind)); ++s) {
      SeededStream stream("sphere sweeps", kSeed, static_cast<std::uint64_t>(kind) * 1000 + s);
      const Solid solid = any_solid(stream, kind);
      for (std::uint64_t r = 0; r < kRays; ++r) {
        const ExactRay ray = any_ray(stream, solid, kRayClasses.at(r % kRayClasses.size()));
        std::string why = fault(solid, ray, tally);
        if (why.empty() && r % 8 == 0) {
          why = fault_between(solid, ray, solid.surface.crossings(ray).t, tally);
        }
        if (!why.empty()) {
          FAIL(why << ": " << text_of(solid, ray));
        }
      }
    }
  }
  INFO(tally);
  CHECK(tally.count("certain") >= 5000);
  CHECK(tally.count("crossed") >= 4000);
  CHECK(tally.count("crossed often") >= 300);
  CHECK(tally.count("overlaps") >= 500);
  CHECK(tally.count("piece along") >= 10);
  CHECK(tally.count("in the boundary") >= 5);
  CHECK(tally.count("on a parabola") >= 50);
  CHECK(tally.count("inseparable") <= 10);
  CHECK(tally.count("points") >= 1000);
  CHECK(tally.count("undecided points") <= 10);
}

TEST_CASE("A point is on the side of a sphere sweep that the oracle says", "[swept]") {
  constexpr std::uint64_t kSolids = 80;
  constexpr int kPoints = 24;
  support::ClassTally tally{"inside", "outside", "on the end", "undecided"};
  for (const ContourKind kind : kKinds) {
    for (std::uint64_t s = 0; s < kSolids; ++s) {
      SeededStream stream("sides of sphere sweeps", kSeed,
                          static_cast<std::uint64_t>(kind) * 1000 + s);
      const Solid solid = any_solid(stream, kind);
      const Rational& radius = solid.surface.radius();
      for (int i = 0; i < kPoints; ++i) {
        const auto& piece = solid.reference.pieces()[stream.below(solid.reference.pieces().size())];
        const Rational u = i % 4 == 0 ? Rational(0) : any_dyadic(stream, 0, 1);
        const ExactPoint centre{geometry::value_at(piece[0], u), geometry::value_at(piece[1], u),
                                geometry::value_at(piece[2], u)};
        // Exactly a radius away from there, or about as much.
        const Vector aside =
            (number::nearest_double(radius) * stream.uniform(0.75, 2)) * any_unit(stream);
        const ExactPoint p = centre + (i % 4 == 0 ? ExactPoint{-radius, 0, 0} : exactly(aside));
        const std::optional<int> truth = solid.reference.side(coordinates(p));
        tally.add(!truth       ? "undecided"
                  : *truth < 0 ? "inside"
                  : *truth > 0 ? "outside"
                               : "on the end");
        if (truth && solid.surface.side(p) != *truth) {
          FAIL("not " << *truth << ": " << text_of(solid, {p, {0, 0, 0}}));
        }
      }
    }
  }
  INFO(tally);
  CHECK(tally.count("inside") >= 1000);
  CHECK(tally.count("outside") >= 1000);
  CHECK(tally.count("on the end") >= 20);
  CHECK(tally.count("undecided") <= 10);
}

// What rounding may move a crossing by, as a length, to first order. At the crossing's parameter
// the roundings of |(c - o) x d|^2 are 12 of each term of c - o, which |(c - o) x d| <= r |d| is a
// sum of, and those of r^2 |d|^2 and the difference are 4: the square of the half chord h of the
// ball there is off by 2 e = (24 r C + 8 r^2) u, and h by e / h. The chord's middle is by 12 C u,
// and the sums with it by 2 u |t| |d|. C bounds the terms of c - o: those of c, and the ray's point
// that it is set up at, no farther from the origin than these and the radius. Nothing where h^2 <
// 64 e: the ray is so nearly a tangent that the parameter itself, of which h is a function, is not
// known.
std::optional<double> bound_on_error(const Solid& solid, const ExactRay& ray, const Rational& t,
                                     const geometry::TrajectoryPiece& piece, const Rational& u,
                                     double roundoff) {
  double terms = 0;
  for (const std::vector<Rational>& coordinate : piece) {
    double power = 1;
    for (const Rational& c : coordinate) {
      terms += power * std::abs(number::nearest_double(c));
      power *= number::nearest_double(u);
    }
  }
  const double radius = number::nearest_double(solid.surface.radius());
  const double all_terms = 2 * terms + 2 * radius;
  const Vector d = nearest_double(ray.direction);
  const double length = std::sqrt(dot(d, d));
  // Exactly, as it may be far shorter than what it is the difference of.
  const ExactPoint arm = ray.origin + t * ray.direction - point_at(piece, u);
  const double half = std::abs(number::nearest_double(dot(arm, ray.direction))) / length;
  const double of_square = roundoff * (12 * radius * all_terms + 4 * radius * radius);
  if (half * half < 64 * of_square) {
    return std::nullopt;
  }
  return of_square / half +
         roundoff * (12 * all_terms + 2 * std::abs(number::nearest_double(t)) * length);
}

// Grazing rays are no nearer to being tangents than 10^-9, so that their chords are 10^-5 long or
// more: in double none is lost to rounding, of which the square root of 10^-16 is left. What is of
// second order, the square of the error of u, is below the bound where the condition of u is below
// u^-1/2: that is 10^8 in double, and 10^4 in float, where it is not; so of float, counts alone are
// checked.
TEMPLATE_TEST_CASE("Rounded numbers have the crossings of sphere sweeps", "[swept]", float, double,
                   number::bin<237>) {
  using Number = TestType;
  using Traits = number::number_traits<Number>;
  using Crossing = typename surface::RoundedSphereSweep<Number>::Crossing;
  constexpr bool kIsFloat = std::is_same_v<Number, float>;
  constexpr bool kIsWide = std::is_same_v<Number, number::bin<237>>;
  constexpr std::uint64_t kSolids = 12;
  constexpr std::uint64_t kRays = 16;
  const auto as_rationals = [](const geometry::Vector3<Number>& v) {
    return ExactPoint{Traits::to_exact(v.x), Traits::to_exact(v.y), Traits::to_exact(v.z)};
  };
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;
  std::uint64_t miscounted = 0;
  std::uint64_t tangent = 0;
  double greatest_part = 0;
  for (const ContourKind kind : kKinds) {
    for (std::uint64_t s = 0; s < kSolids; ++s) {
      SeededStream stream("rounded sphere sweeps", kSeed,
                          static_cast<std::uint64_t>(kind) * 1000 + s);
      const Solid solid = any_solid(stream, kind);
      const surface::RoundedSphereSweep<Number> rounded(solid.surface);
      for (std::uint64_t r = 0; r < kRays; ++r) {
        const auto local = geometry::rounded<Number>(
            any_ray(stream, solid, kRayClasses.at(r % kRayClasses.size())));
        const ExactRay ray{as_rationals(local.origin), as_rationals(local.direction)};
        const SphereSweep::Crossings truth = solid.surface.crossings(ray);
        std::vector<Crossing> found;
        const bool is_along = !rounded.find_crossings(local, {}, found);
        ++rays;
        if (is_along || truth.in_boundary || found.size() != truth.t.size()) {
          miscounted += found.size() == truth.t.size() ? 0 : 1;
          continue;
        }
        for (std::size_t i = 0; i < found.size(); ++i) {
          ++hits;
          const Rational t = enclosure(truth.t[i], 300).lower;
          const Vector d = nearest_double(ray.direction);
          const double error =
              number::nearest_double(Rational(abs(Rational(Traits::to_exact(found[i].t) - t)))) *
              std::sqrt(dot(d, d));
          const std::optional<double> bound = bound_on_error(
              solid, ray, t, solid.surface.trajectory().pieces()[found[i].piece],
              Traits::to_exact(found[i].s), static_cast<double>(number::unit_roundoff<Number>()));
          if (!bound) {
            ++tangent;
            continue;
          }
          greatest_part = std::max(greatest_part, error / *bound);
          if (!kIsFloat && error > *bound) {
            FAIL("off by " << error << ", not " << *bound << ": " << text_of(solid, ray));
          }
          // A condition of 2^137 is left to the parameter that either normal is from.
          if (kIsWide && r == 0) {
            const geometry::Vector3<Number> at = local.origin + found[i].t * local.direction;
            const ExactPoint off = solid.surface.normal_near(as_rationals(at)) -
                                   as_rationals(rounded.normal(at, found[i]));
            CHECK(dot(off, off) < Rational(1, number::Integer(1) << 200));
          }
        }
      }
    }
  }
  INFO("rays " << rays << ", crossings " << hits << ", tangent " << tangent << ", miscounted "
               << miscounted << ", part of the bound " << greatest_part);
  CHECK(hits >= 900);
  CHECK(tangent <= (kIsFloat ? hits / 10 : hits / 200));
  CHECK(miscounted <= (kIsFloat ? rays / 20 : 0));
  CHECK(greatest_part > 0.05);  // not so wide that it says nothing
}

TEMPLATE_TEST_CASE("The bound on the rounding of a ball's equation holds", "[swept]", float,
                   double) {
  using Number = TestType;
  using Traits = number::number_traits<Number>;
  constexpr std::uint64_t kCases = 2000;
  double greatest_part = 0;
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    SeededStream stream("equations of balls", kSeed, case_id);
    const auto any = [&stream](double size) {
      return static_cast<Number>(stream.uniform(-size, size));
    };
    const Solid solid = any_solid(stream, kKinds.at(case_id % kKinds.size()));
    const surface::RoundedSphereSweep<Number> rounded(solid.surface);
    geometry::AffineMap map;
    for (auto& row : map.rows) {
      for (Rational& entry : row) {
        entry = Rational(stream.integer(-100, 100), 37);
      }
    }
    const surface::RoundedMap<Number> frame(map);
    const geometry::Vector3<Number> world{any(4), any(4), any(4)};
    const auto count = solid.surface.trajectory().pieces().size();
    const typename surface::RoundedSphereSweep<Number>::Crossing crossing{
        Number(0), static_cast<Number>(stream.unit()),
        static_cast<std::uint32_t>(stream.below(count))};
    const ExactPoint p = apply(
        map, {Traits::to_exact(world.x), Traits::to_exact(world.y), Traits::to_exact(world.z)});
    const ExactPoint n = p - point_at(solid.surface.trajectory().pieces()[crossing.piece],
                                      Traits::to_exact(crossing.s));
    const Rational exact =
        (dot(n, n) - solid.surface.radius() * solid.surface.radius()) / Rational(2);
    const Rational error =
        abs(Rational(Traits::to_exact(rounded.value(frame.point(world), crossing)) - exact));
    const Rational bound =
        Traits::to_exact(rounded.rounding_error(frame.magnitude(world), crossing));
    REQUIRE(error <= bound);
    greatest_part = std::max(greatest_part, number::nearest_double(Rational(error / bound)));
  }
  CHECK(greatest_part > 0.02);  // not so wide that it says nothing
}

}  // namespace
}  // namespace lamina
