// The ways to find where a ray crosses a swept contour: the three searches against exact crossings,
// the tree of rectangles against none, van Wijk's counting of caps against a clipping of the exact
// solid, and what his printed variants change.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/rounding.hpp"
#include "number/traits.hpp"
#include "poly/solver.hpp"
#include "support/class_tally.hpp"
#include "support/random_sweeps.hpp"
#include "surface/box_tree.hpp"
#include "surface/parity_trimming.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::Ray;
using geometry::Vector3;
using number::Rational;
using poly::SweepSearch;
using surface::RoundedSweep;
using surface::Sweep;
using surface::SweptSurface;

constexpr std::uint64_t kSeed = 1;
constexpr std::array kSearches{SweepSearch::Polynomial, SweepSearch::Subdivision,
                               SweepSearch::StripTree};

ExactPoint any_point(SeededStream& stream, double size) {
  return {support::any_dyadic(stream, -size, size), support::any_dyadic(stream, -size, size),
          support::any_dyadic(stream, -size, size)};
}

// Through the point of the contour where a piece begins, and for some along the contour there.
ExactRay ray_at_joint(SeededStream& stream, const SweptSurface& surface) {
  const auto& pieces = surface.contour().pieces();
  const geometry::ContourPiece& piece = pieces[stream.below(pieces.size())];
  const Rational& u = piece.u[0];
  const Rational& v = piece.v[0];
  const Rational z = stream.chance(0.5) ? 1 : 2;
  const bool tangent = stream.chance(0.5);
  ExactPoint d = any_point(stream, 1);
  ExactPoint p;
  switch (surface.sweep()) {
    case Sweep::Translational:
      p = {u, v, z};
      d = tangent ? ExactPoint{piece.u[1], piece.v[1], d.z} : d;
      break;
    case Sweep::Conic:
      p = {u * z, v * z, z};
      d = tangent ? ExactPoint{piece.u[1], piece.v[1], 0} : d;
      break;
    case Sweep::Rotational:
      p = {u, 0, v};
      d = tangent ? ExactPoint{piece.u[1], d.y, piece.v[1]} : d;
      break;
    case Sweep::GeneralisedConic:
      break;
  }
  return {p - Rational(stream.integer(-8, 8)) * d, d};
}

// A ray of every kind that the searches and van Wijk's equations tell apart.
ExactRay any_ray(SeededStream& stream, const SweptSurface& surface, support::ClassTally& tally) {
  ExactPoint target = any_point(stream, 1);
  target.x += surface.sweep() == Sweep::Rotational ? 2 : 0;
  ExactRay ray{any_point(stream, 20), {}};
  ray.direction = target - ray.origin;
  switch (stream.below(7)) {
    case 0:
      tally.add("level");
      ray.direction.z = 0;
      ray.origin.z = target.z;
      break;
    case 1:
      tally.add("upright");
      ray.direction = {0, 0, stream.chance(0.5) ? 1 : -2};
      ray.origin = target;
      break;
    case 2:
    case 3:
      tally.add("joint");
      ray = ray_at_joint(stream, surface);
      break;
    case 4:
      tally.add("far");
      ray.origin = target - Rational(1 << stream.integer(8, 24)) * ray.direction;
      break;
    default:
      tally.add("any");
  }
  if (ray.direction == ExactPoint{}) {
    ray.direction.x = 1;
  }
  return ray;
}

// A closed contour of as many pieces about (2, 0).
SweptSurface flower(Sweep sweep, ContourKind kind, int pieces) {
  std::vector<geometry::PlanePoint> points;
  for (int i = 0; i < pieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    const double radius = i % 2 == 0 ? 1.5 : 1.25;
    points.push_back({2 + support::dyadic(radius * std::cos(angle), 1024),
                      support::dyadic(radius * std::sin(angle), 1024)});
  }
  return *support::swept_surface(sweep, points, kind, true);
}

template <typename Number>
void check_tree(const SweptSurface& exact, SeededStream& stream, int rays,
                support::ClassTally& tally, std::uint64_t& crossings) {
  const RoundedSweep<Number> by_tree(exact);
  const RoundedSweep<Number> one_by_one(exact, {.each_piece = true});
  std::vector<typename RoundedSweep<Number>::Crossing> found;
  std::vector<typename RoundedSweep<Number>::Crossing> expected;
  for (int r = 0; r < rays; ++r) {
    const Ray<Number> ray = geometry::rounded<Number>(any_ray(stream, exact, tally));
    const poly::Solvers solvers{.search = kSearches.at(stream.below(3))};
    by_tree.find_crossings(ray, solvers, found);
    one_by_one.find_crossings(ray, solvers, expected);
    REQUIRE(std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                       [](const auto& x, const auto& y) {
                         return x.t == y.t && x.s == y.s && x.piece == y.piece;
                       }));
    crossings += found.size();
  }
}

TEST_CASE("A tree over a contour's pieces changes no crossing", "[swept]") {
  constexpr int kContours = 20;
  support::ClassTally tally{"level", "upright", "joint", "far", "any"};
  std::uint64_t crossings = 0;
  for (const Sweep sweep : support::kSweeps) {
    for (const ContourKind kind : support::kKinds) {
      for (std::uint64_t c = 0; c < kContours; ++c) {
        SeededStream stream(
            "box tree", kSeed,
            (static_cast<std::uint64_t>(sweep) * 3 + static_cast<std::uint64_t>(kind)) * kContours +
                c);
        const auto surface =
            c == 0 ? flower(sweep, kind, 64) : support::any_swept_surface(stream, sweep, kind);
        if (!surface) {
          continue;
        }
        check_tree<double>(*surface, stream, 400, tally, crossings);
        check_tree<float>(*surface, stream, 400, tally, crossings);
        check_tree<number::bin<11>>(*surface, stream, 20, tally, crossings);
      }
    }
  }
  INFO(tally << ", crossings " << crossings);
  CHECK(tally.each_at_least(5000));
  CHECK(crossings > 50'000);
}

TEST_CASE("A tree over a contour's pieces leads to few of them", "[swept]") {
  // Twice the pieces: one level more, and no more than that many rectangles.
  constexpr int kRays = 2000;
  std::array<double, 2> visited{};
  for (std::size_t i = 0; i < 2; ++i) {
    const SweptSurface exact =
        flower(Sweep::Translational, ContourKind::BSpline, i == 0 ? 64 : 512);
    const RoundedSweep<double> sweep(exact);
    std::vector<surface::PlaneBox<double>> boxes;
    for (const geometry::Rectangle& box : exact.contour().boxes()) {
      boxes.push_back({number::nearest_double(box.u_min), number::nearest_double(box.u_max),
                       number::nearest_double(box.v_min), number::nearest_double(box.v_max)});
    }
    const surface::BoxTree<double> tree(boxes);
    SeededStream stream("few pieces", kSeed, i);
    for (int r = 0; r < kRays; ++r) {
      const double angle = stream.uniform(0, 7);
      const double offset = stream.uniform(-1, 1);
      const double a = std::cos(angle);
      const double b = std::sin(angle);
      // a (u - 2) + b v = offset
      surface::RayImage<double> image;
      image.u = a;
      image.v = b;
      image.constant = -2 * a - offset;
      tree.visit_pieces(
          [&](const surface::PlaneBox<double>& box) {
            ++visited[i];
            return image.over(box).exclude_zero();
          },
          [&](std::uint32_t) {
            ++visited[i];
            return true;
          });
    }
  }
  INFO(visited[0] / kRays << " and " << visited[1] / kRays);
  CHECK(visited[1] < 2 * visited[0]);  // of 8 times the pieces
}

TEMPLATE_TEST_CASE("Halving a contour finds an even number of crossings", "[swept]", float, double,
                   number::bin<11>) {
  // However a ray touches, and whatever is rounded: not so the polynomials.
  constexpr int kContours = 8;
  constexpr int kRays = 100;
  support::ClassTally tally{"level", "upright", "joint", "far", "any"};
  std::uint64_t crossings = 0;
  for (const Sweep sweep : {Sweep::Translational, Sweep::Rotational}) {
    for (const ContourKind kind : support::kKinds) {
      for (std::uint64_t c = 0; c < kContours; ++c) {
        SeededStream stream(
            "even", kSeed,
            (static_cast<std::uint64_t>(sweep) * 3 + static_cast<std::uint64_t>(kind)) * kContours +
                c);
        const auto surface = support::any_swept_surface(stream, sweep, kind);
        if (!surface) {
          continue;
        }
        const RoundedSweep<TestType> rounded(*surface);
        std::vector<typename RoundedSweep<TestType>::Crossing> found;
        for (int r = 0; r < kRays; ++r) {
          const Ray<TestType> ray = geometry::rounded<TestType>(any_ray(stream, *surface, tally));
          for (const SweepSearch search : {SweepSearch::Subdivision, SweepSearch::StripTree}) {
            rounded.find_crossings(ray, {.search = search}, found);
            INFO("sweep " << static_cast<int>(sweep) << ", kind " << static_cast<int>(kind)
                          << ", contour " << c << ", ray " << r << ", " << poly::name_of(search));
            REQUIRE(found.size() % 2 == 0);
            crossings += found.size();
          }
        }
      }
    }
  }
  INFO(tally << ", crossings " << crossings);
  CHECK(tally.each_at_least(500));
  CHECK(crossings > 4000);
}

// Rounding by 2^-237 moves a t by 2^-100 only where its condition is 2^137, and rounding by 2^-53
// by 2^-20 where it is 2^33: no such ray is among these.
using Wide = number::bin<237>;

template <typename Number>
void check_searches(int bits, std::uint64_t contours, int rays, std::uint64_t least_hits) {
  using Traits = number::number_traits<Number>;
  const Rational close(1, number::Integer(1) << bits);
  std::uint64_t hits = 0;
  support::ClassTally tally{"level", "upright", "four", "pole"};
  for (const Sweep sweep : support::kSweeps) {
    for (const ContourKind kind : support::kKinds) {
      for (std::uint64_t c = 0; c < contours; ++c) {
        SeededStream stream(
            "sweep searches", kSeed,
            (static_cast<std::uint64_t>(sweep) * 3 + static_cast<std::uint64_t>(kind)) * contours +
                c);
        const auto surface = support::any_swept_surface(stream, sweep, kind);
        if (!surface) {
          continue;
        }
        const RoundedSweep<Number> rounded(*surface);
        for (int r = 0; r < rays; ++r) {
          const auto any = [&stream](double size) -> ExactPoint {
            return {Rational(stream.uniform(-size, size)), Rational(stream.uniform(-size, size)),
                    Rational(stream.uniform(-size, size))};
          };
          ExactPoint target = any(1);
          target.x += sweep == Sweep::Rotational ? 2 : 0;
          const ExactPoint origin = any(20);
          ExactRay ray{origin, target - origin};
          if (r == 0) {
            ray.direction.z = 0;
            ray.origin.z = target.z;
          } else if (r == 1 && sweep == Sweep::Rotational) {
            ray = {target, {0, 0, 3}};
          }
          const bool at_pole = r == 2 && !surface->contour().closed();
          if (at_pole) {
            ray.direction = ExactPoint{0, 0, 1} - ray.origin;  // where the profile ends
          }
          const auto truth = surface->crossings(ray);
          REQUIRE_FALSE(truth.in_boundary);
          tally.add("level", r == 0 && !truth.crossings.empty());
          tally.add("upright", r == 1 && sweep == Sweep::Rotational && !truth.crossings.empty());
          tally.add("pole", at_pole);
          tally.add("four", truth.crossings.size() >= 4);
          for (const SweepSearch search : kSearches) {
            // A rounded polynomial has its root beside s = 0 there, in the piece or not.
            if (at_pole && search == SweepSearch::Polynomial) {
              continue;
            }
            std::vector<typename RoundedSweep<Number>::Crossing> found;
            rounded.find_crossings(geometry::rounded<Number>(ray), {.search = search}, found);
            INFO("sweep " << static_cast<int>(sweep) << ", kind " << static_cast<int>(kind)
                          << ", contour " << c << ", ray " << r << ", " << poly::name_of(search));
            REQUIRE(found.size() == truth.crossings.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
              const number::Enclosure t = enclosure(truth.crossings[i].t, bits + 20);
              const Rational at = Traits::to_exact(found[i].t);
              REQUIRE(at > t.lower - close);
              REQUIRE(at < t.upper + close);
              REQUIRE(found[i].piece == truth.crossings[i].piece);
              REQUIRE(found[i].s >= 0);
              REQUIRE(found[i].s <= 1);
              ++hits;
            }
          }
        }
      }
    }
  }
  INFO(tally << ", crossings " << hits);
  CHECK(tally.each_at_least(contours));
  CHECK(hits > least_hits);
}

TEST_CASE("Each search finds the exact crossings in 237 bits", "[swept]") {
  check_searches<Wide>(100, 8, 6, 1000);
}

TEST_CASE("Each search finds the exact crossings of random rays in double", "[swept]") {
  check_searches<double>(20, 24, 12, 5000);
}

TEST_CASE("The halving searches find s to the rounding of the ray's equation", "[swept]") {
  // The bounds of contour_search.hpp, for equation 2: s off by some u, and the left side by its
  // rounding, for strips with that of the points too.
  constexpr std::uint64_t kContours = 40;
  const Rational u_double(1, number::Integer(1) << 53);
  std::uint64_t crossings = 0;
  for (std::uint64_t c = 0; c < kContours; ++c) {
    SeededStream stream("residuals", kSeed, c);
    const auto surface =
        support::any_swept_surface(stream, Sweep::Translational, support::kKinds.at(c % 3));
    if (!surface) {
      continue;
    }
    const RoundedSweep<double> rounded(*surface);
    for (int r = 0; r < 50; ++r) {
      const Ray<double> ray{{stream.uniform(-4, 4), stream.uniform(-4, 4), 0},
                            {stream.uniform(-1, 1), stream.uniform(-1, 1), 1}};
      const Rational a(ray.direction.y);
      const Rational b(-ray.direction.x);
      const Rational constant[] = {-a * Rational(ray.origin.x), -b * Rational(ray.origin.y)};
      for (const SweepSearch search : {SweepSearch::Subdivision, SweepSearch::StripTree}) {
        const bool strips = search == SweepSearch::StripTree;
        std::vector<RoundedSweep<double>::Crossing> found;
        rounded.find_crossings(ray, {.search = search}, found);
        for (const auto& crossing : found) {
          const geometry::ContourPiece& piece = surface->contour().pieces()[crossing.piece];
          const Rational s(crossing.s);
          const auto slope_at = [&s](const std::vector<Rational>& p) {
            Rational slope = p[1];
            for (std::size_t k = 2; k < p.size(); ++k) {
              slope += static_cast<int>(k) * p[k] * (k == 2 ? s : Rational(s * s));
            }
            return slope;
          };
          const Rational u = geometry::value_at(piece.u, s);
          const Rational v = geometry::value_at(piece.v, s);
          const Rational slope = a * slope_at(piece.u) + b * slope_at(piece.v);
          const Rational terms = abs(a * u) + abs(b * v) + abs(constant[0]) + abs(constant[1]);
          const Rational residual = a * u + b * v + constant[0] + constant[1];
          INFO("contour " << c << ", ray " << r << ", " << poly::name_of(search));
          REQUIRE(abs(residual) <=
                  u_double * ((strips ? 24 : 16) * terms + (strips ? 12 : 1) * abs(slope)));
          ++crossings;
        }
      }
    }
  }
  CHECK(crossings > 1000);
}

// Where a ray enters or leaves a solid between z = 0 and z = 1, not by counting: a side crossing
// is one if its z is between, a plane is crossed where its point is in the swept solid.
std::vector<number::Enclosure> clipped(const SweptSurface& surface, const ExactRay& ray, int bits) {
  std::vector<number::Enclosure> t;
  for (const auto& crossing : surface.crossings(ray).crossings) {
    const number::Enclosure at = enclosure(crossing.t, bits);
    const Rational z = ray.origin.z + at.lower * ray.direction.z;
    if (surface.sweep() == Sweep::Rotational || (z > 0 && z < 1)) {
      t.push_back(at);
    }
  }
  if (surface.sweep() != Sweep::Rotational && ray.direction.z != 0) {
    for (const int plane : {0, 1}) {
      const Rational at = (plane - ray.origin.z) / ray.direction.z;
      if (surface.side(ray.origin + at * ray.direction) < 0) {
        t.push_back({at, at});
      }
    }
  }
  std::sort(t.begin(), t.end(), [](const auto& x, const auto& y) { return x.lower < y.lower; });
  return t;
}

TEST_CASE("Counting crossings decides caps as clipping does", "[swept]") {
  constexpr std::uint64_t kContours = 10;
  constexpr int kRays = 36;
  const Rational close(1, 1 << 20);
  support::ClassTally tally{"no cap", "one cap", "two caps", "level", "downwards"};
  for (const Sweep sweep : support::kSweeps) {
    for (const ContourKind kind : support::kKinds) {
      for (std::uint64_t c = 0; c < kContours; ++c) {
        SeededStream stream(
            "caps", kSeed,
            (static_cast<std::uint64_t>(sweep) * 3 + static_cast<std::uint64_t>(kind)) * kContours +
                c);
        const auto surface = support::any_swept_surface(stream, sweep, kind);
        if (!surface) {
          continue;
        }
        const RoundedSweep<double> rounded(*surface);
        const SweepSearch search = kSearches.at(c % 3);
        for (int r = 0; r < kRays; ++r) {
          const auto any = [&stream](double low, double high) {
            return Rational(stream.uniform(low, high));
          };
          const ExactPoint origin{any(-4, 4), any(-4, 4), any(-4, 4)};
          const ExactPoint target{any(-1, 1), any(-1, 1), any(0, 1)};
          ExactRay ray{origin, target - origin};
          if (r == 0) {
            ray = {target, {ray.direction.x, ray.direction.y, 0}};
          }
          const auto truth = clipped(*surface, ray, 60);
          std::vector<RoundedSweep<double>::Crossing> found;
          rounded.find_crossings(geometry::rounded<double>(ray), {.search = search}, found);
          surface::trim_by_parity(rounded, geometry::rounded<double>(ray), found);
          INFO("sweep " << static_cast<int>(sweep) << ", kind " << static_cast<int>(kind)
                        << ", contour " << c << ", ray " << r);
          REQUIRE(found.size() == truth.size());
          int caps = 0;
          for (std::size_t i = 0; i < found.size(); ++i) {
            REQUIRE(Rational(found[i].t) > truth[i].lower - close);
            REQUIRE(Rational(found[i].t) < truth[i].upper + close);
            const bool is_cap = found[i].piece >= surface::kBasePlane;
            caps += is_cap ? 1 : 0;
            if (is_cap) {
              const Rational z = ray.origin.z + Rational(found[i].t) * ray.direction.z;
              REQUIRE(abs(Rational(z - (found[i].piece == surface::kCapPlane ? 1 : 0))) < close);
            }
          }
          if (sweep != Sweep::Rotational && !found.empty()) {
            tally.add(caps == 0 ? "no cap" : caps == 1 ? "one cap" : "two caps");
            tally.add("level", r == 0);
            tally.add("downwards", ray.direction.z < 0);
          }
        }
      }
    }
  }
  INFO(tally);
  CHECK(tally.each_at_least(30));
}

TEST_CASE("The searches of sweeps have names", "[swept]") {
  for (const SweepSearch search : kSearches) {
    CHECK(poly::parse_sweep_search(poly::name_of(search)) == search);
  }
  CHECK_THROWS_AS(poly::parse_sweep_search("strip"), base::InputError);
}

TEST_CASE("A small value does for the rays that van Wijk gives no equation", "[swept]") {
  constexpr std::uint64_t kContours = 30;
  // Of t = (u - o_x) / small and of its product with it the first is as large as 2^20 times 8, and
  // rounding is 2^-53 of that; the ray gets off by less than 2^-20 times 8 in the solid.
  constexpr double kSmall = 0x1p-20;
  support::ClassTally tally{"in", "out", "level"};
  for (std::uint64_t c = 0; c < kContours; ++c) {
    SeededStream stream("small values", kSeed, c);
    const ContourKind kind = support::kKinds.at(c % 3);
    const auto prism = support::any_swept_surface(stream, Sweep::Translational, kind);
    const auto turned = support::any_swept_surface(stream, Sweep::Rotational, kind);
    if (!prism || !turned) {
      continue;
    }
    const RoundedSweep<double> upright(*prism, {.small_value = kSmall});
    const RoundedSweep<double> level(*turned, {.small_value = kSmall});
    const RoundedSweep<double> without(*turned);
    std::vector<RoundedSweep<double>::Crossing> found;
    std::vector<RoundedSweep<double>::Crossing> expected;
    for (int r = 0; r < 20; ++r) {
      const Ray<double> up{{stream.uniform(-2, 2), stream.uniform(-2, 2), -3}, {0, 0, 1}};
      const bool is_in = prism->side({Rational(up.origin.x), Rational(up.origin.y), 0}) < 0;
      tally.add(is_in ? "in" : "out");
      upright.find_crossings(up, {}, found);
      surface::trim_by_parity(upright, up, found);
      REQUIRE(found.size() == (is_in ? 2 : 0));
      if (is_in) {
        CHECK(found[0].t == 3);
        CHECK(found[1].t == 4);
      }
      const Ray<double> across{{-5, stream.uniform(-2, 2), stream.uniform(-1, 1)}, {1, 0, 0}};
      level.find_crossings(across, {}, found);
      without.find_crossings(across, {}, expected);
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        tally.add("level");
        CHECK(std::abs(found[i].t - expected[i].t) < 0x1p-6);
      }
    }
  }
  INFO(tally);
  CHECK(tally.each_at_least(50));
}

TEST_CASE("The printed normal of a conic sweep is right where it is radial only", "[swept]") {
  // The square of side 2 about the axis: at u = 1 the normal is (1, 0, -1), in print
  // (1, 0, -(1 + v^2)^1/2).
  const auto surface = support::swept_surface(Sweep::Conic, {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}},
                                              ContourKind::Line, true);
  const RoundedSweep<double> right(*surface);
  const RoundedSweep<double> printed(*surface, {.conic_normal = true});
  for (const double v : {-0.75, 0.0, 0.75}) {
    for (const double z : {1.0, -2.0}) {
      const Ray<double> ray{{z - 1, v * z, z}, {1, 0, 0}};
      std::vector<RoundedSweep<double>::Crossing> found;
      right.find_crossings(ray, {}, found);
      const auto at = std::find_if(found.begin(), found.end(),
                                   [](const auto& crossing) { return crossing.t == 1; });
      REQUIRE(at != found.end());
      const double side = z < 0 ? -1 : 1;  // below the apex the solid is on the other side
      CHECK(right.normal(ray.origin + at->t * ray.direction, *at) ==
            Vector3<double>{2 * side, 0, -2 * side});
      CHECK(printed.normal(ray.origin + at->t * ray.direction, *at) ==
            Vector3<double>{2 * side, 0, -2 * side * std::sqrt(1 + v * v)});
    }
  }
}

}  // namespace
}  // namespace lamina
