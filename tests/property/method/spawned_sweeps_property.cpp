// Rays spawned in scenes with swept contours. Spawned straight on or straight back where another
// ray is, a ray meets what that one does, which is known exactly without any interval.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "geometry/affine.hpp"
#include "geometry/ray_text.hpp"
#include "method/spawned_events.hpp"
#include "support/class_tally.hpp"
#include "support/sweep_models.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using method::ExactStart;
using method::SpawnedEvents;
using number::Enclosure;
using number::Interval;
using number::Rational;
using surface::Sweep;

constexpr std::uint64_t kSeed = 3;

// A crossing of a line, t being anywhere.
struct Hit {
  surface::CarrierIndex carrier = 0;
  std::size_t index = 0;  // among the carrier's
  number::Root t;
};

// All that a line crosses, exactly.
struct Line {
  ExactRay ray;
  bool in_carrier = false;
  std::vector<int> first_signs;  // by the carrier: at -infinity
  std::vector<Hit> hits;         // ascending

  Line(const scene::Scene& scene, ExactRay line) : ray(std::move(line)) {
    surface::RayMonomials monomials(ray);
    for (surface::CarrierIndex c = 0; c < scene.carriers.size(); ++c) {
      const surface::CarrierOnRay carrier(scene.carriers[c], ray, monomials);
      in_carrier = in_carrier || carrier.contains_ray();
      if (in_carrier) {
        return;
      }
      first_signs.push_back(carrier.sign_at_minus_infinity());
      const auto roots = carrier.crossings();
      for (std::size_t i = 0; i < roots.size(); ++i) {
        hits.push_back({c, i, roots[i]});
      }
    }
    std::sort(hits.begin(), hits.end(),
              [](const Hit& a, const Hit& b) { return compare(a.t, b.t) < 0; });
  }
};

// From a place on a line straight on, or straight back: pace * the line's direction.
struct Continuation {
  const Line& line;
  number::Root from;
  Rational pace;

  [[nodiscard]] std::vector<Hit> hits() const {
    std::vector<Hit> ahead;
    for (const Hit& hit : line.hits) {
      const auto order = compare(hit.t, from);
      if (pace > 0 ? order > 0 : order < 0) {
        ahead.push_back(hit);
      }
    }
    if (pace < 0) {
      std::reverse(ahead.begin(), ahead.end());
    }
    return ahead;
  }

  // Of a carrier just behind the start.
  [[nodiscard]] int sign(surface::CarrierIndex carrier) const {
    int result = line.first_signs[carrier];
    for (const Hit& hit : line.hits) {
      const auto order = compare(hit.t, from);
      if (hit.carrier == carrier && (order < 0 || (order == 0 && pace > 0))) {
        result = -result;
      }
    }
    return result;
  }

  // Bounds of a hit's s.
  [[nodiscard]] Enclosure s(const Hit& hit) const {
    constexpr int kBits = 200;  // so that what a double has is far above
    const Enclosure to = enclosure(hit.t, kBits);
    const Enclosure start = enclosure(from, kBits);
    const Rational a = (to.lower - start.upper) / pace;
    const Rational b = (to.upper - start.lower) / pace;
    return {std::min(a, b), std::max(a, b)};
  }
};

bool has_tie(const std::vector<Hit>& hits) {
  return std::adjacent_find(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
           return compare(a.t, b.t) == 0;
         }) != hits.end();
}

// What is wrong with the events, or nothing.
std::string fault(const SpawnedEvents& events, const scene::Scene& scene,
                  const Continuation& truth) {
  const std::vector<Hit> right = truth.hits();
  const auto found = events.classes();
  if (has_tie(right)) {
    return "equal roots of different carriers are decided";
  }
  if (found.size() != right.size()) {
    return fmt::format("{} crossings, not {}", found.size(), right.size());
  }
  std::vector<std::size_t> seen(scene.carriers.size());
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (found[i].carrier != right[i].carrier) {
      return fmt::format("crossing {} is of another carrier", i);
    }
    if (found[i].root != seen[right[i].carrier]++) {
      return fmt::format("crossing {} is not in its carrier's order", i);
    }
    // A root is known to 2^-60 max(1, s), and s is rounded to 53 bits.
    const Enclosure s = truth.s(right[i]);
    const Rational off = Rational(1, std::int64_t{1} << 52) * std::max(Rational(1), s.upper);
    if (found[i].s < s.lower - off || found[i].s > s.upper + off) {
      return fmt::format("crossing {} is elsewhere", i);
    }
  }
  for (csg::LeafIndex leaf = 0; leaf < scene.leaves.size(); ++leaf) {
    const auto& [carrier, side] = std::pair(scene.leaves[leaf].carrier, scene.leaves[leaf].side);
    if (events.starts_inside(leaf) != (side * truth.sign(carrier) < 0)) {
      return fmt::format("leaf {} starts on the wrong side", leaf);
    }
  }
  return "";
}

// A rational point of the line, on no carrier.
ExactStart start_between(const Line& line, const Rational& t) {
  ExactStart start;
  start.point = [point = line.ray.origin + t * line.ray.direction](int bits) {
    return std::optional(
        geometry::Vector3<Interval>{{point.x, 2 * bits}, {point.y, 2 * bits}, {point.z, 2 * bits}});
  };
  return start;
}

// A sweep, turned and moved or not, a sphere that no ray along an axis touches, and a plane.
std::string scene_text(SeededStream& stream, const surface::SweptSurface& sweep, bool is_placed) {
  const std::string swept = support::sweep_text(sweep);
  const auto any = [&stream] { return stream.integer(-3, 3); };
  return fmt::format("{}{}sphere({}/7);\nhalfspace([{}, {}, 5], {}/8);\n",
                     is_placed ? fmt::format("translate([{}/3, 1/5, {}]) rotate([{}, 20, 50]) ",
                                             any(), any(), 10 * any())
                               : "",
                     swept, stream.integer(8, 13), any(), any(), stream.integer(1, 7));
}

// Of a line in the sweep's own coordinates.
ExactRay in_world(const scene::Scene& scene, const ExactRay& local) {
  for (const surface::Carrier& carrier : scene.carriers) {
    if (carrier.sweep) {
      const geometry::AffineMap to_world = *geometry::inverse(carrier.sweep->to_local);
      return {apply(to_world, local.origin), apply_to_direction(to_world, local.direction)};
    }
  }
  return local;
}

ExactRay any_free_ray(SeededStream& stream) {
  const auto any = [&stream] { return Rational(stream.uniform(-1.5, 1.5)); };
  return {{any(), any(), any()}, {any(), any(), any()}};
}

// Parallel to an asymptote of the curve of some piece, and so with roots at infinity.
ExactRay any_parallel_ray(SeededStream& stream, const surface::SweptSurface& sweep) {
  const auto pieces = sweep.contour().pieces();
  const geometry::ContourPiece& piece = pieces[stream.below(pieces.size())];
  const Rational& u = piece.u.back();
  const Rational& v = piece.v.back();
  ExactRay ray = any_free_ray(stream);
  switch (sweep.sweep()) {
    case Sweep::Translational:
      ray.direction = {u, v, ray.direction.z};
      break;
    case Sweep::Conic:
      ray.direction =
          stream.chance(0.5) ? ExactPoint{u, v, 0} : ExactPoint{piece.u[0], piece.v[0], 1};
      break;
    case Sweep::Rotational:
      ray.direction = {u * Rational(3, 5), u * Rational(4, 5), v};
      break;
    case Sweep::GeneralisedConic:
      break;
  }
  if (ray.direction == ExactPoint{}) {
    ray.direction = {1, 0, 0};
  }
  return ray;
}

Rational any_pace(SeededStream& stream) {
  return Rational(stream.integer(1, 9), 7) * (stream.chance(0.5) ? 1 : -1);
}

// Does a line in local coordinates meet what is swept of this point of the contour?
bool is_through(Sweep sweep, const ExactRay& line, const geometry::PlanePoint& p) {
  const auto& [o, d] = line;
  switch (sweep) {
    case Sweep::Translational:
      return (p.u - o.x) * d.y == (p.v - o.y) * d.x;
    case Sweep::Conic:
      return dot(cross(o, d), ExactPoint{p.u, p.v, 1}).is_zero();
    case Sweep::GeneralisedConic:
      return true;  // not told
    case Sweep::Rotational:
      break;
  }
  if (d.z.is_zero()) {
    return o.z == p.v;  // if it is near enough to the axis
  }
  const ExactPoint at = o + Rational((p.v - o.z) / d.z) * d;
  return at.x * at.x + at.y * at.y == p.u * p.u;
}

std::vector<geometry::PlanePoint> joints_of(const surface::SweptSurface& sweep) {
  std::vector<geometry::PlanePoint> joints;
  for (const geometry::ContourPiece& piece : sweep.contour().pieces()) {
    joints.push_back({piece.u[0], piece.v[0]});
  }
  if (!sweep.contour().closed()) {
    const geometry::ContourPiece& last = sweep.contour().pieces().back();
    joints.push_back({geometry::value_at(last.u, 1), geometry::value_at(last.v, 1)});
  }
  return joints;
}

// Can intervals perhaps not tell all of the line's crossings? Where carriers cross at one point,
// where two curves of the sweep do, at a joint of its pieces or at the apex, and on the axis, where
// a turned side, if it is long enough, comes to a point.
bool is_singular(const scene::Scene& scene, const Line& line) {
  const auto& carrier = *std::find_if(scene.carriers.begin(), scene.carriers.end(),
                                      [](const surface::Carrier& c) { return c.sweep != nullptr; });
  const auto& sweep = std::get<surface::SweptSurface>(carrier.sweep->surface);
  const geometry::AffineMap& map = carrier.sweep->to_local;
  const ExactRay local{apply(map, line.ray.origin), apply_to_direction(map, line.ray.direction)};
  const auto joints = joints_of(sweep);
  const ExactPoint around = cross(local.origin, local.direction);
  const bool meets_axis = sweep.sweep() == Sweep::Conic
                              ? around == ExactPoint{}
                              : sweep.sweep() == Sweep::Rotational && around.z.is_zero();
  return has_tie(line.hits) || meets_axis ||
         std::any_of(joints.begin(), joints.end(), [&](const geometry::PlanePoint& joint) {
           return is_through(sweep.sweep(), local, joint);
         });
}

support::ClassTally new_tally() {
  return {"free", "parallel", "special",  "singular",   "undecided",
          "tie",  "between",  "on sweep", "on another", "twice",
          "back", "level",    "upright",  "along",      "from joint"};
}

// Spawns along a line, up to three times one from the other.
void spawn_along(SeededStream& stream, const scene::Scene& scene, const Line& line,
                 support::ClassTally& tally) {
  SpawnedEvents events(scene);
  const Rational t(stream.integer(-64, 64), 32);
  const bool is_on_hit = std::any_of(line.hits.begin(), line.hits.end(),
                                     [&t](const Hit& hit) { return compare(hit.t, t) == 0; });
  const bool is_between = line.hits.empty() || (!is_on_hit && stream.chance(0.25));
  const Hit* at = is_between ? nullptr : &line.hits[stream.below(line.hits.size())];
  ExactStart start = is_between ? start_between(line, t) : events.start_on(line.ray, at->t);
  Continuation truth{line, is_between ? number::Root(t) : at->t, 1};
  const bool is_singular_line = is_singular(scene, line);
  tally.add("singular", is_singular_line);
  for (int depth = 0; depth < 3; ++depth) {
    truth.pace = any_pace(stream);
    const std::vector<Hit> right = truth.hits();
    const auto replay = [&] {
      return fmt::format("from t = {} at pace {}, depth {}, ray \"{}\"", truth.from.lower(),
                         number::to_text(truth.pace), depth, geometry::to_text(line.ray));
    };
    if (!events.find(start, truth.pace * line.ray.direction)) {
      if (!is_singular_line) {
        FAIL("undecided " << replay());
      }
      tally.add("tie", has_tie(right));
      tally.add("undecided");
      return;
    }
    if (const std::string why = fault(events, scene, truth); !why.empty()) {
      FAIL(why << ' ' << replay());
    }
    const auto is_sweep = [&scene](const Hit& hit) {
      return scene.carriers[hit.carrier].sweep != nullptr;
    };
    tally.add(at == nullptr ? "between" : is_sweep(*at) ? "on sweep" : "on another");
    tally.add("from joint", start.curves.size() > 1);
    tally.add("twice", depth > 0);
    tally.add("back", truth.pace < 0);
    tally.add("level", line.ray.direction.z.is_zero());
    tally.add("upright", line.ray.direction.x.is_zero() && line.ray.direction.y.is_zero());
    tally.add("along", std::any_of(right.begin(), right.end(), is_sweep));
    if (right.empty()) {
      return;
    }
    const std::size_t next = stream.below(right.size());
    at = &*std::find_if(line.hits.begin(), line.hits.end(), [&](const Hit& hit) {
      return hit.carrier == right[next].carrier && hit.index == right[next].index;
    });
    truth.from = at->t;
    start = events.start_on(next);
  }
}

TEST_CASE("Rays spawned straight on or back meet what the ray does that spawns them", "[spawned]") {
  constexpr std::uint64_t kRays = 24;
  const Sweep sweep = support::kSweepsOfAllKinds[GENERATE(range(0, 4))];
  const ContourKind kind = support::kKinds[GENERATE(range(0, 3))];
  const bool is_polygon = kind == ContourKind::Line;
  const bool is_slow = sweep == Sweep::GeneralisedConic;
  const std::uint64_t scenes = (is_polygon ? 36 : 10) / (is_slow ? 3 : 1);
  support::ClassTally tally = new_tally();
  std::uint64_t made = 0;
  for (std::uint64_t id = 0; made < scenes; ++id) {
    SeededStream stream(
        "spawned-sweeps/along", kSeed,
        10'000 * static_cast<std::uint64_t>(sweep) + 1'000 * static_cast<std::uint64_t>(kind) + id);
    const auto surface = support::any_swept_surface(stream, sweep, kind);
    if (!surface) {
      continue;
    }
    const std::string text = scene_text(stream, *surface, ++made % 2 == 0);
    INFO(text);
    const scene::Scene scene = scene::parse_scene(text, "random");
    for (std::uint64_t r = 0; r < kRays; ++r) {
      const bool is_special = r % 2 == 0;
      const bool is_parallel = r % 4 == 1;
      tally.add(is_special ? "special" : is_parallel ? "parallel" : "free");
      const ExactRay local =
          is_special    ? support::any_ray(stream, sweep, joints_of(*surface), surface->scaling())
          : is_parallel ? any_parallel_ray(stream, *surface)
                        : any_free_ray(stream);
      const Line line(scene, in_world(scene, local));
      if (!line.in_carrier) {
        spawn_along(stream, scene, line, tally);
      }
    }
  }
  INFO(name_of(sweep) << " of " << name_of(kind) << ": " << tally);
  // An eighth of the rays starts on the sweep or more, and few where nothing can be told.
  const std::uint64_t rays = scenes * kRays;
  for (const char* reached : {"between", "on sweep", "on another", "twice", "back", "along"}) {
    CHECK(tally.count(reached) >= rays / 8);
  }
  for (const char* reached : {"singular", "level", "upright", "from joint"}) {
    CHECK(tally.count(reached) >= rays / 200);
  }
  CHECK(tally.count("undecided") <= rays / 5);
}

// What a ray meets that goes back at a pace from a class of another one, as far as that one's
// start.
std::string fault_back(const SpawnedEvents& back, const SpawnedEvents& forth, std::size_t from,
                       surface::CarrierIndex start, double pace) {
  const auto found = back.classes();
  const auto met = forth.classes();
  if (found.size() <= from) {
    return fmt::format("{} crossings on the way back, {} on the way", found.size(), from + 1);
  }
  for (std::size_t i = 0; i <= from; ++i) {
    const bool is_start = i == from;
    if (found[i].carrier != (is_start ? start : met[from - 1 - i].carrier)) {
      return fmt::format("crossing {} is of another carrier", i);
    }
    // Each s is off by 2^-52 max(1, s) at most, and difference and quotient are rounded: by less
    // than 2^-49 of the largest in all.
    const double s = (met[from].s - (is_start ? 0 : met[from - 1 - i].s)) / pace;
    if (std::abs(found[i].s - s) >
        std::ldexp(std::max({1.0, met[from].s / pace, met[from].s}), -49)) {
      return fmt::format("crossing {} is elsewhere", i);
    }
  }
  return "";
}

TEST_CASE("A ray that turns back meets what it met, and the surface that it started on",
          "[spawned]") {
  constexpr std::uint64_t kRays = 40;
  const Sweep sweep = support::kSweeps[GENERATE(range(0, 3))];
  const ContourKind kind = support::kKinds[GENERATE(range(0, 3))];
  support::ClassTally tally{"turned", "on sweep", "passed sweep", "undecided"};
  const std::uint64_t scenes = kind == ContourKind::Line ? 12 : 6;
  std::uint64_t made = 0;
  for (std::uint64_t id = 0; made < scenes; ++id) {
    SeededStream stream(
        "spawned-sweeps/back", kSeed,
        10'000 * static_cast<std::uint64_t>(sweep) + 1'000 * static_cast<std::uint64_t>(kind) + id);
    const auto surface = support::any_swept_surface(stream, sweep, kind);
    if (!surface) {
      continue;
    }
    const std::string text = scene_text(stream, *surface, ++made % 2 == 0);
    INFO(text);
    const scene::Scene scene = scene::parse_scene(text, "random");
    for (std::uint64_t r = 0; r < kRays; ++r) {
      const Line line(scene, in_world(scene, any_free_ray(stream)));
      if (line.in_carrier || line.hits.empty()) {
        continue;
      }
      const Hit& hit = line.hits[stream.below(line.hits.size())];
      const ExactPoint way = any_free_ray(stream).direction;
      SpawnedEvents forth(scene);
      if (!forth.find(forth.start_on(line.ray, hit.t), way)) {
        tally.add("undecided");
        continue;
      }
      if (forth.classes().empty()) {
        continue;
      }
      const std::size_t from = stream.below(forth.classes().size());
      const int pace = static_cast<int>(stream.integer(1, 5));
      SpawnedEvents back(scene);
      if (!back.find(forth.start_on(from), Rational(-pace) * way)) {
        tally.add("undecided");
        continue;
      }
      if (const std::string why = fault_back(back, forth, from, hit.carrier, pace); !why.empty()) {
        FAIL(why << ", ray \"" << geometry::to_text(line.ray) << "\" from " << hit.t.lower()
                 << " towards " << way.x << ' ' << way.y << ' ' << way.z << ", back from " << from);
      }
      const auto is_sweep = [&scene](surface::CarrierIndex carrier) {
        return scene.carriers[carrier].sweep != nullptr;
      };
      tally.add("turned");
      tally.add("on sweep", is_sweep(hit.carrier));
      tally.add("passed sweep", from > 0 && is_sweep(forth.classes()[from - 1].carrier));
    }
  }
  INFO(name_of(sweep) << " of " << name_of(kind) << ": " << tally);
  CHECK(tally.count("turned") >= scenes * kRays / 4);
  CHECK(tally.count("on sweep") >= scenes * kRays / 40);
  CHECK(tally.count("passed sweep") >= scenes * kRays / 40);
  CHECK(tally.count("undecided") == 0);  // these rays are in no special position
}

}  // namespace
}  // namespace lamina
