// Certified crossings against FLINT and Arb: of rays in general position, of near tangents and
// from very far; and that what 53 bits cannot tell is undecided.
#include "surface/certified_surface.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"
#include "support/reference_faces.hpp"
#include "support/reference_roots.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::AffineMap;
using geometry::ExactPoint;
using number::Integer;
using number::Rational;
using poly::CertifiedRoots;
using reference::Primitive;
using reference::RealRoot;
using Range = poly::Range<double>;
using Ray = geometry::Ray<double>;
using Vector = geometry::Vector3<double>;

constexpr std::uint64_t kSeed = 1;
constexpr int kBits = 200;  // of the oracle's enclosures

// As the code under test takes it, and as the oracle does.
struct Solid {
  surface::LocalSurface surface;
  Primitive primitive;
};

Solid unit_sphere() { return {surface::sphere(1), {Primitive::Kind::Sphere, {1}}}; }

Solid ring() {
  const Rational r(1, 4);
  return {surface::torus(1, r), {Primitive::Kind::Torus, {1, r}}};
}

Solid plane(const ExactPoint& n, const Rational& offset) {
  return {surface::plane(n, offset), {Primitive::Kind::HalfSpace, {n.x, n.y, n.z, offset}}};
}

Solid quadric(const std::array<std::array<Rational, 4>, 4>& matrix) {
  Primitive primitive{Primitive::Kind::Quadric, {}};
  for (const auto& row : matrix) {
    primitive.numbers.insert(primitive.numbers.end(), row.begin(), row.end());
  }
  return {surface::quadric(matrix), primitive};
}

Solid cylinder(const Rational& r) {
  return quadric({{{1, 0, 0, 0}, {0, 1, 0, 0}, {}, {0, 0, 0, -r * r}}});
}

// x^2 + y^2 = s^2 (z - a)^2
Solid cone(const Rational& s, const Rational& a) {
  const Rational ss = s * s;
  return quadric({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -ss, ss * a}, {0, 0, ss * a, -ss * a * a}}});
}

Rational any_rational(SeededStream& stream) {
  return {stream.integer(-9, 9), stream.integer(1, 9)};
}

ExactPoint any_vector(SeededStream& stream) {
  return {any_rational(stream), any_rational(stream), any_rational(stream)};
}

Solid any_plane(SeededStream& stream) {
  const Rational offset = any_rational(stream);
  return plane({any_rational(stream), any_rational(stream), stream.integer(1, 9)}, offset);
}

Solid any_quadric(SeededStream& stream) {
  std::array<std::array<Rational, 4>, 4> matrix;
  for (auto& row : matrix) {
    std::generate(row.begin(), row.end(), [&] { return any_rational(stream); });
  }
  return quadric(matrix);
}

AffineMap any_placement(SeededStream& stream) {
  ExactPoint sizes = any_vector(stream);
  for (Rational* size : {&sizes.x, &sizes.y, &sizes.z}) {
    *size = *size == 0 ? Rational(1) : *size;
  }
  const Rational w = stream.integer(1, 9);
  const AffineMap rotation = geometry::rotation(w, any_vector(stream));
  return compose(geometry::translation(any_vector(stream)),
                 compose(rotation, geometry::scaling(sizes)));
}

struct Case {
  Solid solid;
  AffineMap to_local;
  Ray ray;
  Range range;
};

std::string text_of(const Case& in) {
  const auto& [o, d] = in.ray;
  std::ostringstream out;
  out << std::hexfloat << o.x << ' ' << o.y << ' ' << o.z << " towards " << d.x << ' ' << d.y << ' '
      << d.z << " from " << in.range.low << " to " << in.range.high;
  return out.str();
}

ExactPoint exactly(const Vector& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

// A local ray goes to the world exactly, and is rounded there.
Case placed(const Solid& solid, const AffineMap& to_world, const Ray& local,
            const Range& range = {}) {
  return {solid,
          *inverse(to_world),
          {nearest_double(apply(to_world, exactly(local.origin))),
           nearest_double(apply_to_direction(to_world, exactly(local.direction)))},
          range};
}

CertifiedRoots crossings(const Case& in) {
  return surface::CertifiedSurface(in.solid.surface, in.to_local).crossings(in.ray, in.range);
}

// A multiple of f(o + t d), ascending, from five values of f: its degree is at most four.
std::vector<Integer> along(const Case& in) {
  const ExactPoint o = apply(in.to_local, exactly(in.ray.origin));
  const ExactPoint d = apply_to_direction(in.to_local, exactly(in.ray.direction));
  const auto at = [&](int t) {
    const ExactPoint p = o + Rational(t) * d;
    return reference::faces_at<Rational>(in.solid.primitive, {p.x, p.y, p.z})[0];
  };
  const Rational f = at(0);
  const Rational even = (at(1) + at(-1)) / 2 - f;      // c2 + c4
  const Rational odd = (at(1) - at(-1)) / 2;           // c1 + c3
  const Rational far_even = (at(2) + at(-2)) / 2 - f;  // 4 c2 + 16 c4
  const Rational far_odd = (at(2) - at(-2)) / 2;       // 2 c1 + 8 c3
  const Rational c4 = (far_even - 4 * even) / 12;
  const Rational c3 = (far_odd - 2 * odd) / 6;
  const std::array<Rational, 5> c{f, odd - c3, even - c4, c3, c4};
  Integer common = 1;
  for (const Rational& x : c) {
    common = lcm(common, denominator(x));
  }
  std::vector<Integer> whole;
  std::transform(c.begin(), c.end(), std::back_inserter(whole),
                 [&](const Rational& x) { return numerator(Rational(x * common)); });
  return whole;
}

bool is_below(const RealRoot& root, double t) {
  return std::isinf(t) ? t > 0 : root.upper < Rational(t);
}
bool is_above(const RealRoot& root, double t) {
  return std::isinf(t) ? t < 0 : root.lower > Rational(t);
}

// What is wrong with the crossings in the range, given those of all the line; or nothing.
std::string fault(const CertifiedRoots& found, const Range& range,
                  const std::vector<RealRoot>& truth) {
  std::vector<RealRoot> inside;
  for (const RealRoot& root : truth) {
    if (is_above(root, range.low) && is_below(root, range.high)) {
      inside.push_back(root);
    } else if (!is_below(root, range.low) && !is_above(root, range.high)) {
      return "a crossing is at an end of the range";
    }
  }
  if (found.count != static_cast<int>(inside.size())) {
    return std::to_string(found.count) + " crossings, not " + std::to_string(inside.size());
  }
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const auto is_between = [&bounds = found.t[i]](const RealRoot& root) {
      return !is_below(root, bounds.low) && !is_above(root, bounds.high);
    };
    if (inside[i].multiplicity != 1) {
      return "a crossing is not simple";
    }
    if (!is_between(inside[i])) {
      return "a crossing is elsewhere";
    }
    if (std::count_if(truth.begin(), truth.end(), is_between) != 1) {
      return "a crossing is not alone between its bounds";
    }
  }
  return "";
}

// Goes through the cases of a class, and counts how they end.
template <typename Make>
support::ClassTally go_through(const std::string& name, std::uint64_t cases, const Make& make) {
  const std::array<const char*, 5> counts{"none", "one", "two", "three", "four"};
  support::ClassTally tally{"none",     "one", "two", "three", "four", "some out of the range",
                            "undecided"};
  for (std::uint64_t case_id = 0; case_id < cases; ++case_id) {
    SeededStream stream("certified/" + name, kSeed, case_id);
    const Case in = make(stream, case_id);
    const CertifiedRoots found = crossings(in);
    if (found.outcome == poly::Outcome::Undecided) {
      tally.add("undecided");
      continue;
    }
    const std::vector<RealRoot> truth = reference::real_roots(along(in), kBits);
    if (const std::string why = fault(found, in.range, truth); !why.empty()) {
      FAIL(name << ' ' << kSeed << ' ' << case_id << ": " << why << ", of " << text_of(in));
    }
    tally.add(counts.at(found.count));
    tally.add("some out of the range", found.count < static_cast<int>(truth.size()));
  }
  return tally;
}

Vector in_unit_ball(SeededStream& stream) {
  while (true) {
    const Vector v{stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    if (dot(v, v) <= 1) {
      return v;
    }
  }
}

Vector any_unit(SeededStream& stream) { return normalised(in_unit_ball(stream)); }

// From this distance to a random point of the ball around the origin: all of the line, what is
// ahead, or a part with that point in it.
Case aimed(SeededStream& stream, const Solid& solid, const AffineMap& to_world, double radius,
           double distance) {
  const Vector origin = distance * any_unit(stream);
  Vector direction = radius * in_unit_ball(stream) - origin;
  double length = std::sqrt(dot(direction, direction));
  double target = 1;
  if (stream.chance(0.5)) {
    direction = normalised(direction);
    target = length;
    length = 1;
  }
  Range range;
  if (stream.chance(0.3)) {
    range.low = 0;
  } else if (stream.chance(0.4)) {
    const double reach = 2 * radius / length;
    range.low = target - stream.unit() * reach;
    range.high = target + stream.unit() * reach;
  }
  return placed(solid, to_world, {origin, direction}, range);
}

// At right angles to the normal, so far above a random point of the surface.
Case nearly_tangent(SeededStream& stream, bool is_ring, const AffineMap& to_world, double above) {
  Vector normal = any_unit(stream);
  Vector point = normal;
  if (is_ring) {
    const Vector of_disk = any_unit(stream);
    const Vector centre = normalised(Vector{of_disk.x, of_disk.y, 0});
    const Vector of_tube = any_unit(stream);
    normal = normalised(of_tube.x * centre + of_tube.y * Vector{0, 0, 1});
    point = centre + 0.25 * normal;
  }
  const Vector direction = normalised(cross(normal, any_unit(stream)));
  const Vector origin = point + above * normal - stream.uniform(1, 3) * direction;
  return placed(is_ring ? ring() : unit_sphere(), to_world, {origin, direction});
}

// Towards the origin, but for this much.
Case beside_centre(SeededStream& stream, const Solid& solid, double distance, double beside) {
  const Vector away = any_unit(stream);
  const Vector centre = beside * in_unit_ball(stream);
  const Vector origin = centre + distance * stream.uniform(0.3, 3) * away;
  return placed(solid, AffineMap(), {origin, stream.uniform(-2, -0.1) * away});
}

// A point of a surface that is exact in doubles, and the normal there.
struct Contact {
  Solid solid;
  Vector point;
  Vector normal;
};

// At t through the point or touching there, exactly: all numbers are small.
Case through(SeededStream& stream, const Contact& contact, double t, bool touches) {
  const auto coordinate = [&stream] { return static_cast<double>(stream.integer(-16, 16)) / 8; };
  Vector d{};
  while (d == Vector{}) {
    d = {coordinate(), coordinate(), coordinate()};
    d = touches ? cross(contact.normal, d) : d;
  }
  const AffineMap scaling = geometry::scaling({3, 6, 3});  // thirds are no doubles
  const AffineMap moved = compose(geometry::translation({5, -7, 11}), scaling);
  return placed(contact.solid, stream.chance(0.5) ? moved : AffineMap(),
                {contact.point - t * d, d});
}

}  // namespace

TEST_CASE("Certified crossings are those of FLINT and Arb, and nearly all are decided",
          "[certified]") {
  struct Shape {
    std::string name;
    double radius;  // of the ball that is aimed at
    Solid (*make)(SeededStream&);
  };
  static const std::array<Shape, 6> shapes{
      {{"sphere", 1, [](SeededStream&) { return unit_sphere(); }},
       {"ring", 1.25, [](SeededStream&) { return ring(); }},
       {"cylinder", 1, [](SeededStream&) { return cylinder(Rational(2, 3)); }},
       {"cone", 1, [](SeededStream&) { return cone(Rational(3, 7), Rational(1, 3)); }},
       {"plane", 1, any_plane},
       {"quadric", 2, any_quadric}}};
  const Shape& shape = shapes[GENERATE(range(0, 6))];
  constexpr std::uint64_t kCases = 3000;
  constexpr std::array<double, 3> kDistances{3, 1e3, 1e6};
  const support::ClassTally tally =
      go_through(shape.name, kCases, [&](SeededStream& stream, std::uint64_t case_id) {
        const AffineMap to_world = case_id % 2 == 0 ? AffineMap() : any_placement(stream);
        return aimed(stream, shape.make(stream), to_world, shape.radius, kDistances[case_id % 3]);
      });
  INFO(shape.name << " " << tally);
  CHECK(tally.count("undecided") * 1000 <= kCases);
  CHECK(tally.count("none") >= kCases / 50);
  CHECK(tally.count("one") >= kCases / 50);
  CHECK((shape.name == "plane" || tally.count("two") >= kCases / 10));
  CHECK((shape.name != "ring" || tally.count("four") >= kCases / 100));
  CHECK(tally.count("some out of the range") >= kCases / 50);
}

TEST_CASE("Certified crossings of near tangents are those of FLINT and Arb", "[certified]") {
  constexpr std::uint64_t kCases = 2000;
  const bool is_ring = GENERATE(false, true);
  const double above = GENERATE(1e-6, 1e-10, 1e-14);
  INFO((is_ring ? "ring, " : "sphere, ") << above);
  const support::ClassTally tally =
      go_through("near", kCases, [&](SeededStream& stream, std::uint64_t case_id) {
        const AffineMap to_world = case_id % 4 < 2 ? AffineMap() : any_placement(stream);
        return nearly_tangent(stream, is_ring, to_world, case_id % 2 == 0 ? above : -above);
      });
  INFO(tally);
  if (above == 1e-14) {
    CHECK(tally.count("undecided") > 0);  // or else they were not near
    return;
  }
  CHECK(tally.count("undecided") * 1000 <= kCases);
  CHECK(tally.count("none") >= kCases / 4);
  CHECK(tally.count("two") >= kCases / 4);
  CHECK((!is_ring || tally.count("four") >= kCases / 20));
}

// From so far that rounding moves the ray by the size of the solid; and so near to the apex of a
// cone that the crossings of its nappes are some rounding errors apart, if there are any.
TEST_CASE("No certified crossing is wrong where few are decided", "[certified]") {
  struct Class {
    std::string name;
    Solid solid;
    std::vector<double> distances;
    double beside;
  };
  static const std::vector<double> far{1e12, 1e15, 1e16, 1e17, 1e18};
  static const std::array<Class, 4> classes{{{"far sphere", unit_sphere(), far, 1},
                                             {"far ring", ring(), far, 1},
                                             {"far cone", cone(1, 0), far, 1},
                                             {"apex", cone(1, 0), {1}, 4e-16}}};
  const Class& cls = classes[GENERATE(range(0, 4))];
  constexpr std::uint64_t kCases = 2500;
  const support::ClassTally tally =
      go_through(cls.name, kCases, [&](SeededStream& stream, std::uint64_t case_id) {
        const double distance = cls.distances[case_id % cls.distances.size()];
        return beside_centre(stream, cls.solid, distance, cls.beside);
      });
  INFO(cls.name << " " << tally);
  CHECK(tally.count("undecided") >= kCases / 4);
  CHECK(tally.count("two") >= kCases / 50);
  CHECK((cls.name == "far sphere" || tally.count("none") >= kCases / 50));
}

TEST_CASE("Tangents, rays in a surface and crossings at an end of the range are undecided",
          "[certified]") {
  constexpr std::uint64_t kCases = 2000;
  const std::vector<Contact> contacts{
      {unit_sphere(), {0, 1, 0}, {0, 1, 0}},
      {ring(), {1, 0, 0.25}, {0, 0, 1}},
      {ring(), {0, -1.25, 0}, {0, -1, 0}},
      {ring(), {0, 0.75, 0}, {0, -1, 0}},
      {cylinder(1), {1, 0, 3}, {1, 0, 0}},
      {cone(1, 0), {2, 0, -2}, {1, 0, 1}},
      {cone(1, 0), {0, 0, 0}, {1, 2, 3}},  // the apex: no ray crosses there
      {plane({1, 2, 3}, Rational(7, 4)), {0.5, -0.5, 0.75}, {1, 2, 3}}};
  support::ClassTally tally{"touches", "in the surface", "at an end"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    SeededStream stream("certified/through", kSeed, case_id);
    const double t = static_cast<double>(stream.integer(-16, 16)) / 8;
    const bool touches = stream.chance(0.5);
    Case in = through(stream, contacts[case_id % contacts.size()], t, touches);
    if (!touches) {
      (stream.chance(0.5) ? in.range.low : in.range.high) = t;
    }
    INFO(case_id << ": " << text_of(in));
    const std::vector<Integer> f = along(in);
    Rational value = 0;
    Rational slope = 0;
    for (auto c = f.rbegin(); c != f.rend(); ++c) {
      slope = slope * Rational(t) + value;
      value = value * Rational(t) + *c;
    }
    REQUIRE(value == 0);
    REQUIRE((!touches || slope == 0));
    CHECK(crossings(in).outcome == poly::Outcome::Undecided);
    const bool is_zero = std::all_of(f.begin(), f.end(), [](const Integer& c) { return c == 0; });
    tally.add(is_zero ? "in the surface" : touches ? "touches" : "at an end");
  }
  INFO(tally);
  CHECK(tally.each_at_least(kCases / 20));
}

TEST_CASE("Each kind of wrong certified crossing is noticed", "[certified]") {
  const Range line;
  CertifiedRoots found;
  found.t = {poly::Bounds{0.5, 1}, poly::Bounds{1.5, 2.5}};
  found.count = 2;
  CHECK(fault(found, line, {{1, 1, 1}, {2, 2, 1}}).empty());
  CHECK(!fault(found, {1, 3}, {{1, 1, 1}, {2, 2, 1}}).empty());
  CHECK(!fault(found, {1.5, 3}, {{1, 1, 1}, {2, 2, 1}}).empty());
  CHECK(!fault(found, line, {{1, 1, 1}}).empty());
  CHECK(!fault(found, line, {{1, 1, 2}, {2, 2, 1}}).empty());
  CHECK(!fault(found, line, {{1, 1, 1}, {3, 3, 1}}).empty());
  found.t[0].high = 2;
  CHECK(!fault(found, line, {{1, 1, 1}, {2, 2, 1}}).empty());
}

}  // namespace lamina
