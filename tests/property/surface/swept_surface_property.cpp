// Crossings of swept contours: against an oracle that solves for the contour's parameter, against
// hand-written clipping by half-planes, and against the equations of a double cone.
#include "surface/swept_surface.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"
#include "support/random_sweeps.hpp"
#include "support/reference_sweep.hpp"

namespace lamina {
namespace {

using base::SeededStream;
using geometry::Contour;
using geometry::ContourKind;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using reference::SweptCurve;
using support::any_dyadic;
using support::kKinds;
using support::kSweeps;
using surface::Sweep;
using surface::SweptSurface;
using Doubt = SweptCurve::Doubt;
using Membership = SweptCurve::Membership;
using Vector = geometry::Vector3<double>;

constexpr std::uint64_t kSeed = 1;

// Of each sweep: of polygons, and of either kind of spline, which take twenty times as long.
constexpr std::uint64_t kPolygons = 112;
constexpr std::uint64_t kSplines = 20;
constexpr std::uint64_t kRaysPerContour = 40;
// Of a ray and a piece; 10^5 in all.
constexpr std::uint64_t kLeastPairsOfPolygons = 25'000;
constexpr std::uint64_t kLeastPairsOfSplines = 4'200;

constexpr int kBits = 80;       // of enclosures of the roots under test
constexpr int kMoreBits = 400;  // where these meet

// A multiple of 1/16, 0 < s < 1.
Rational any_parameter(SeededStream& stream) { return {stream.integer(1, 15), 16}; }

// As the code under test takes it, and as the oracle does.
struct Solid {
  SweptSurface surface;
  SweptCurve reference;
};

reference::PlaneCurve curve_of(const Contour& contour) {
  reference::PlaneCurve curve;
  curve.kind = contour.kind() == ContourKind::Line      ? reference::PlaneCurve::Kind::Line
               : contour.kind() == ContourKind::BSpline ? reference::PlaneCurve::Kind::BSpline
                                                        : reference::PlaneCurve::Kind::CatmullRom;
  curve.closed = contour.closed();
  for (const PlanePoint& point : contour.points()) {
    curve.points.push_back({point.u, point.v});
  }
  return curve;
}

reference::SweepKind kind_of(Sweep sweep) {
  return sweep == Sweep::Translational ? reference::SweepKind::Translational
         : sweep == Sweep::Conic       ? reference::SweepKind::Conic
                                       : reference::SweepKind::Rotational;
}

Solid solid_of(SweptSurface surface) {
  SweptCurve reference(kind_of(surface.sweep()), curve_of(surface.contour()));
  return {std::move(surface), std::move(reference)};
}

Solid solid_of(Sweep sweep, std::vector<PlanePoint> points, ContourKind kind, bool closed) {
  return solid_of(
      SweptSurface(sweep, std::make_shared<const Contour>(std::move(points), kind, closed)));
}

std::optional<Solid> any_solid(SeededStream& stream, Sweep sweep, ContourKind kind) {
  std::optional<SweptSurface> surface = support::any_swept_surface(stream, sweep, kind);
  return surface ? std::optional(solid_of(std::move(*surface))) : std::nullopt;
}

SweptCurve::Point coordinates(const ExactPoint& p) { return {p.x, p.y, p.z}; }

Membership membership(const Solid& solid, const ExactPoint& p) {
  return solid.reference.membership(coordinates(p));
}

Rational value_at(const SweptCurve::Polynomial& polynomial, const Rational& s) {
  Rational value = 0;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) {
    value = value * s + *c;
  }
  return value;
}

Rational slope_at(const SweptCurve::Polynomial& polynomial, const Rational& s) {
  Rational slope = 0;
  for (std::size_t i = polynomial.size() - 1; i > 0; --i) {
    slope = slope * s + static_cast<int>(i) * polynomial[i];
  }
  return slope;
}

// A point of the surface, and two directions in its tangent plane. The first one leaves the
// contour's u or v as it is, but for a turned one; the second goes along the contour.
struct Spot {
  ExactPoint point;
  ExactPoint across;
  ExactPoint along;
};

Spot spot_at(SeededStream& stream, Sweep sweep, const SweptCurve::Piece& piece, const Rational& s) {
  const Rational u = value_at(piece.u, s);
  const Rational v = value_at(piece.v, s);
  const Rational du = slope_at(piece.u, s);
  const Rational dv = slope_at(piece.v, s);
  switch (sweep) {
    case Sweep::Translational:
      return {{u, v, any_dyadic(stream, -2, 2)}, {0, 0, 1}, {du, dv, 0}};
    case Sweep::Conic: {
      const Rational z = any_dyadic(stream, 0.25, 3) * (stream.chance(0.5) ? 1 : -1);
      return {{u * z, v * z, z}, {u, v, 1}, {du, dv, 0}};
    }
    case Sweep::Rotational: {
      const Rational half = any_dyadic(stream, -4, 4);  // the tangent of half the angle
      const Rational cosine = (1 - half * half) / (1 + half * half);
      const Rational sine = 2 * half / (1 + half * half);
      return {{u * cosine, u * sine, v}, {-sine, cosine, 0}, {du * cosine, du * sine, dv}};
    }
    case Sweep::GeneralisedConic:
      break;
  }
  return {};
}

const SweptCurve::Piece& any_piece(SeededStream& stream, const Solid& solid) {
  const auto& pieces = solid.reference.pieces();
  return pieces[stream.below(pieces.size())];
}

Vector any_unit(SeededStream& stream) {
  while (true) {
    const Vector v{stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    if (dot(v, v) <= 1 && dot(v, v) > 0.01) {
      return normalised(v);
    }
  }
}

ExactPoint exactly(const Vector& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

ExactPoint any_direction(SeededStream& stream) {
  ExactPoint d;
  while (d == ExactPoint{}) {
    d = {Rational(stream.integer(-16, 16), 8), Rational(stream.integer(-16, 16), 8),
         Rational(stream.integer(-16, 16), 8)};
  }
  return d;
}

// A ray with the t at which it is near the surface, and about what of t is one unit of length.
struct Aim {
  ExactRay ray;
  Rational t;
  double unit = 1;
};

Aim through(const ExactPoint& point, const ExactPoint& direction, const Rational& t) {
  const Vector d = nearest_double(direction);
  return {{point - t * direction, direction}, t, 1 / std::sqrt(dot(d, d))};
}

enum class RayClass : std::uint8_t { Any, Level, FromAxis, AlongAxis, ThroughJoint, Tangent };

// Half of the rays are in no special position.
constexpr std::array<RayClass, 10> kRayClasses{
    RayClass::Any, RayClass::Level,     RayClass::Any, RayClass::FromAxis,     RayClass::Any,
    RayClass::Any, RayClass::AlongAxis, RayClass::Any, RayClass::ThroughJoint, RayClass::Tangent};

Aim aimed(SeededStream& stream, const Solid& solid, RayClass cls) {
  const Sweep sweep = solid.surface.sweep();
  const SweptCurve::Piece& piece = any_piece(stream, solid);
  const Rational s = cls == RayClass::ThroughJoint ? Rational(0) : any_parameter(stream);
  const Spot spot = spot_at(stream, sweep, piece, s);
  const Rational t = any_dyadic(stream, -8, 8);
  if (cls == RayClass::ThroughJoint) {
    return through(spot.point, any_direction(stream), t);
  }
  if (cls == RayClass::Tangent) {
    const Rational across = stream.chance(0.2) ? 0 : stream.integer(1, 8);
    const ExactPoint d = across * spot.across + Rational(stream.integer(1, 8)) * spot.along;
    return d == ExactPoint{} ? through(spot.point, any_direction(stream), t)
                             : through(spot.point, d, t);
  }
  const double off = stream.chance(0.5) ? 0.3 : 0.01;
  const Vector target = nearest_double(spot.point) + off * stream.unit() * any_unit(stream);
  Vector origin = target + std::pow(10.0, stream.uniform(0, 3)) * any_unit(stream);
  switch (cls) {
    case RayClass::Level:
      origin.z = target.z;
      break;
    case RayClass::FromAxis:
      origin = {0, 0, origin.z};
      break;
    case RayClass::AlongAxis:
      origin = {target.x, target.y, origin.z};
      break;
    default:
      break;
  }
  const Vector d = target - origin;
  const double length = std::sqrt(dot(d, d));
  if (stream.chance(0.5)) {
    return {{exactly(origin), exactly(d)}, 1, 1 / length};
  }
  return {{exactly(origin), exactly(normalised(d))}, Rational(length), 1};
}

std::string text_of(const Solid& solid, const ExactRay& ray) {
  std::ostringstream out;
  out << "sweep " << static_cast<int>(solid.surface.sweep()) << " of "
      << (solid.surface.contour().closed() ? "a closed" : "an open") << " contour of kind "
      << static_cast<int>(solid.surface.contour().kind()) << " by";
  for (const PlanePoint& p : solid.surface.contour().points()) {
    out << ' ' << p.u << ',' << p.v;
  }
  const auto& [o, d] = ray;
  out << "; the ray from " << o.x << ' ' << o.y << ' ' << o.z << " towards " << d.x << ' ' << d.y
      << ' ' << d.z;
  return out.str();
}

// What is wrong with the crossings, given the true ones; or nothing.
std::string fault(const SweptSurface::Crossings& found, const SweptCurve::Crossings& truth) {
  if (found.in_boundary) {
    return "the ray does not run along the surface";
  }
  if (found.crossings.size() != truth.crossings.size()) {
    return std::to_string(found.crossings.size()) + " crossings, not " +
           std::to_string(truth.crossings.size());
  }
  for (std::size_t i = 0; i < truth.crossings.size(); ++i) {
    const number::Enclosure bounds = enclosure(found.crossings[i].t, kBits);
    if (bounds.upper < truth.crossings[i].lower || bounds.lower > truth.crossings[i].upper) {
      return "crossing " + std::to_string(i) + " is elsewhere";
    }
    if (found.crossings[i].piece != truth.crossings[i].piece) {
      return "crossing " + std::to_string(i) + " is of another piece";
    }
  }
  return "";
}

// Rationals between the crossings, and one before and one after them.
std::vector<Rational> between(const std::vector<SweptSurface::Crossing>& crossings) {
  if (crossings.empty()) {
    return {0};
  }
  std::vector<Rational> result{enclosure(crossings.front().t, kBits).lower - 1};
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    Rational low = enclosure(crossings[i - 1].t, kBits).upper;
    Rational high = enclosure(crossings[i].t, kBits).lower;
    if (low >= high) {
      low = enclosure(crossings[i - 1].t, kMoreBits).upper;
      high = enclosure(crossings[i].t, kMoreBits).lower;
    }
    result.push_back((low + high) / 2);
  }
  result.push_back(enclosure(crossings.back().t, kBits).upper + 1);
  return result;
}

// Whether the crossings have the ray inside at t; none at a crossing.
std::optional<bool> is_inside(const SweptSurface::Crossings& found, const Rational& t) {
  bool inside = found.starts_inside;
  for (const SweptSurface::Crossing& crossing : found.crossings) {
    const auto order = compare(crossing.t, t);
    if (order == 0) {
      return std::nullopt;
    }
    inside = inside != (order < 0);
  }
  return inside;
}

// The same of what the oracle says of points; counts how many of these it decides.
std::string fault_at_points(const Solid& solid, const ExactRay& ray,
                            const SweptSurface::Crossings& found, const std::vector<Rational>& at,
                            support::ClassTally& tally) {
  for (const Rational& t : at) {
    const Membership truth = membership(solid, ray.origin + t * ray.direction);
    tally.add("points");
    tally.add("undecided points", truth == Membership::Undecided);
    const std::optional<bool> inside = is_inside(found, t);
    if (truth != Membership::Undecided && inside && *inside != (truth == Membership::Inside)) {
      return std::string("the point at t = ") + number::to_text(t) + " is " +
             (*inside ? "not inside" : "inside");
    }
  }
  return "";
}

// Of a ray for which the oracle has doubts: whether it runs along the surface, so far as that is
// known, and what is inside between the crossings and near the surface.
std::string fault_in_doubt(const Solid& solid, const Aim& aim, const SweptSurface::Crossings& found,
                           const SweptCurve::Crossings& truth, support::ClassTally& tally) {
  const Membership at_target = membership(solid, aim.ray.origin + aim.t * aim.ray.direction);
  // A piece may be beside a level ray, at the same height.
  const bool is_level = solid.surface.sweep() == Sweep::Rotational && aim.ray.direction.z == 0;
  const bool may_be_point =
      truth.doubt == Doubt::NoEquation && !is_level && at_target == Membership::Undecided;
  if (found.in_boundary) {
    tally.add("in the boundary");
    return truth.has_piece_along || may_be_point ? "" : "the ray does not run along the surface";
  }
  if (truth.has_piece_along && !is_level) {
    return "the ray runs along the surface";
  }
  std::vector<Rational> at = between(found.crossings);
  for (const double step : {-0.3, -0.01, 0.011, 0.31}) {
    at.push_back(aim.t + Rational(step * aim.unit));
  }
  at.insert(at.end(), {Rational(-1'000'000), Rational(1'000'000)});
  return fault_at_points(solid, aim.ray, found, at, tally);
}

std::string fault(const Solid& solid, const Aim& aim, support::ClassTally& tally) {
  const SweptSurface::Crossings found = solid.surface.crossings(aim.ray);
  const SweptCurve::Crossings truth =
      solid.reference.crossings(coordinates(aim.ray.origin), coordinates(aim.ray.direction));
  tally.add("touch", truth.touches > 0);
  switch (truth.doubt) {
    case Doubt::None:
      tally.add("certain");
      tally.add("crossed", !truth.crossings.empty());
      tally.add("crossed often", truth.crossings.size() > 2);
      break;
    case Doubt::Inseparable:
      tally.add("inseparable");
      break;
    case Doubt::Joint:
      tally.add("joint");
      break;
    case Doubt::InSurface:
      tally.add("piece along");
      break;
    case Doubt::NoEquation:
      tally.add("no equation");
      break;
  }
  if (truth.doubt != Doubt::None) {
    return fault_in_doubt(solid, aim, found, truth, tally);
  }
  const std::string why = fault(found, truth);
  return why.empty()
             ? fault_at_points(solid, aim.ray, found, {between(found.crossings).front()}, tally)
             : why;
}

support::ClassTally new_tally() {
  return {"certain",     "crossed", "crossed often",    "touch",           "inseparable", "joint",
          "piece along", "points",  "undecided points", "in the boundary", "no equation"};
}

// Part of a line; no bound is at infinity.
struct Span {
  std::optional<Rational> low;
  std::optional<Rational> high;
  std::size_t low_piece = 0;
  std::size_t high_piece = 0;
  bool is_empty = false;
  bool is_along = false;  // the line is in one of the bounding planes

  // Keeps where g0 + g1 t >= 0. Pieces come in ascending order: of equal bounds, the first is kept.
  void clip(const Rational& g0, const Rational& g1, std::size_t piece) {
    if (g1 == 0) {
      is_along = is_along || g0 == 0;
      is_empty = is_empty || g0 < 0;
      return;
    }
    const Rational t = -g0 / g1;
    if (g1 > 0 && (!low || t > *low)) {
      low = t;
      low_piece = piece;
    } else if (g1 < 0 && (!high || t < *high)) {
      high = t;
      high_piece = piece;
    }
  }
  // Whether more than a point is left.
  [[nodiscard]] bool is_long() const { return !is_empty && (!low || !high || *low < *high); }
};

// Corners on a circle, counterclockwise: a convex polygon.
std::vector<PlanePoint> any_convex(SeededStream& stream) {
  const Rational radius(stream.integer(1, 8), 4);
  const PlanePoint centre{any_dyadic(stream, -1, 1), any_dyadic(stream, -1, 1)};
  const std::int64_t count = stream.integer(3, 9);
  std::vector<PlanePoint> points;
  for (std::int64_t i = 0; i < count; ++i) {
    // The tangent of half the angle, ascending.
    const Rational half = Rational(2 * i - count + 1, 2) + Rational(stream.integer(0, 3), 4);
    points.push_back({centre.u + radius * (1 - half * half) / (1 + half * half),
                      centre.v + radius * 2 * half / (1 + half * half)});
  }
  return points;
}

// The parts of the line of the ray in the solid over a convex polygon: one over (x, y), or one in
// either nappe.
std::vector<Span> clipped(Sweep sweep, const std::vector<PlanePoint>& corners,
                          const ExactRay& ray) {
  const auto& [o, d] = ray;
  std::vector<Span> spans(sweep == Sweep::Conic ? 2 : 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanePoint& a = corners[i];
    const PlanePoint& b = corners[(i + 1) % corners.size()];
    // n . (x, y, 1) is positive to the left of the edge.
    const ExactPoint n{a.v - b.v, b.u - a.u, a.u * b.v - a.v * b.u};
    if (sweep == Sweep::Translational) {
      spans[0].clip(n.x * o.x + n.y * o.y + n.z, n.x * d.x + n.y * d.y, i);
    } else {
      spans[0].clip(dot(n, o), dot(n, d), i);
      spans[1].clip(-dot(n, o), -dot(n, d), i);
    }
  }
  return spans;
}

// What is wrong with the crossings, given the parts of the line that are inside; or nothing.
std::string fault(const SweptSurface::Crossings& found, std::vector<Span> inside) {
  const bool is_along =
      std::any_of(inside.begin(), inside.end(), [](const Span& span) { return span.is_along; });
  // The line of an edge contains the edge.
  if (found.in_boundary != is_along) {
    return is_along ? "the ray runs along the surface" : "the ray does not run along the surface";
  }
  if (is_along) {
    return found.crossings.empty() ? "" : "crossings in the surface";
  }
  std::erase_if(inside, [](const Span& span) { return !span.is_long(); });
  std::sort(inside.begin(), inside.end(),
            [](const Span& a, const Span& b) { return !a.low || (b.low && *a.low < *b.low); });
  if (found.starts_inside != (!inside.empty() && !inside.front().low)) {
    return "starts on the wrong side";
  }
  std::vector<std::pair<Rational, std::size_t>> ends;
  for (const Span& span : inside) {
    if (span.low) {
      ends.emplace_back(*span.low, span.low_piece);
    }
    if (span.high) {
      ends.emplace_back(*span.high, span.high_piece);
    }
  }
  if (found.crossings.size() != ends.size()) {
    return std::to_string(found.crossings.size()) + " crossings, not " +
           std::to_string(ends.size());
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (compare(found.crossings[i].t, ends[i].first) != 0) {
      return "crossing " + std::to_string(i) + " is not at " + number::to_text(ends[i].first);
    }
    if (found.crossings[i].piece != ends[i].second) {
      return "crossing " + std::to_string(i) + " is not of piece " + std::to_string(ends[i].second);
    }
  }
  return "";
}

// f(t) = c0 + c1 t + c2 t^2
struct Quadratic {
  Rational c0;
  Rational c1;
  Rational c2;

  [[nodiscard]] Rational operator()(const Rational& t) const { return c0 + t * (c1 + t * c2); }
};

// x^2 + y^2 - (1 - w z)^2 along the ray: w is 1 for the upper cone and -1 for the lower one.
Quadratic cone_along(const ExactRay& ray, int w) {
  const auto& [o, d] = ray;
  const Rational radius = 1 - w * o.z;
  const Rational growth = -w * d.z;
  return {o.x * o.x + o.y * o.y - radius * radius, 2 * (o.x * d.x + o.y * d.y - radius * growth),
          d.x * d.x + d.y * d.y - growth * growth};
}

bool has_root_between(const Quadratic& f, const Rational& low, const Rational& high) {
  if (sign(f(low)) * sign(f(high)) <= 0) {
    return true;
  }
  if (f.c2 == 0) {
    return false;
  }
  const Rational extremum = -f.c1 / (2 * f.c2);
  return f(extremum) == 0 && low <= extremum && extremum <= high;
}

// Where 0 <= w z <= 1.
Span slab_along(const ExactRay& ray, int w) {
  Span slab;
  slab.clip(w * ray.origin.z, w * ray.direction.z, 0);
  slab.clip(1 - w * ray.origin.z, -w * ray.direction.z, 0);
  return slab;
}

// Whether the ray gets inside this half of the double cone.
bool enters_cone(const ExactRay& ray, int w) {
  const Quadratic f = cone_along(ray, w);
  const Span slab = slab_along(ray, w);
  if (slab.is_empty || (slab.low && slab.high && *slab.low > *slab.high)) {
    return false;
  }
  if ((slab.low && f(*slab.low) < 0) || (slab.high && f(*slab.high) < 0)) {
    return true;
  }
  if (f.c2 <= 0) {
    return false;  // not below its lower end
  }
  const Rational lowest = -f.c1 / (2 * f.c2);
  return (!slab.low || lowest > *slab.low) && (!slab.high || lowest < *slab.high) && f(lowest) < 0;
}

bool is_in_double_cone(const ExactPoint& p) {
  const Rational radius = 1 - abs(p.z);
  return radius > 0 && p.x * p.x + p.y * p.y < radius * radius;
}

// With small numbers: many rays go through a corner or along an edge.
ExactRay any_small_ray(SeededStream& stream) {
  const ExactPoint target{Rational(stream.integer(-8, 8), 8), Rational(stream.integer(-8, 8), 8),
                          Rational(stream.integer(-8, 8), 8)};
  return through(target, any_direction(stream), Rational(stream.integer(-16, 16), 4)).ray;
}

ExactRay any_coarse_ray(SeededStream& stream) {
  const auto coordinate = [&stream] { return Rational(stream.integer(-2, 2), 2); };
  const ExactPoint target{coordinate(), coordinate(), coordinate()};
  ExactPoint d;
  while (d == ExactPoint{}) {
    d = {Rational(stream.integer(-1, 1)), Rational(stream.integer(-1, 1)),
         Rational(stream.integer(-1, 1))};
  }
  return through(target, d, Rational(stream.integer(-8, 8), 2)).ray;
}

}  // namespace

TEST_CASE("Pieces of contours are those of an independent oracle", "[swept]") {
  const ContourKind kind = kKinds[GENERATE(range(0, 3))];
  std::uint64_t compared = 0;
  for (std::uint64_t case_id = 0; case_id < 100; ++case_id) {
    SeededStream stream("swept/pieces", kSeed, case_id);
    const std::optional<Solid> solid = any_solid(stream, Sweep::Rotational, kind);
    if (!solid) {
      continue;
    }
    const auto pieces = solid->surface.contour().pieces();
    REQUIRE(pieces.size() == solid->reference.pieces().size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      INFO("case " << case_id << ", piece " << i);
      CHECK(pieces[i].u == solid->reference.pieces()[i].u);
      CHECK(pieces[i].v == solid->reference.pieces()[i].v);
      ++compared;
    }
  }
  CHECK(compared >= 250);
}

TEST_CASE("Crossings of swept contours are those of the contour's parameter", "[swept]") {
  const Sweep sweep = kSweeps[GENERATE(range(0, 3))];
  const ContourKind kind = kKinds[GENERATE(range(0, 3))];
  const std::string name = "swept/" + std::to_string(static_cast<int>(sweep)) + '/' +
                           std::to_string(static_cast<int>(kind));
  support::ClassTally tally = new_tally();
  std::uint64_t pairs = 0;
  std::uint64_t contours = 0;
  std::uint64_t refused = 0;
  const bool is_polygon = kind == ContourKind::Line;
  const std::uint64_t wanted = is_polygon ? kPolygons : kSplines;
  for (std::uint64_t case_id = 0; contours < wanted && refused <= wanted; ++case_id) {
    SeededStream stream(name, kSeed, case_id);
    const std::optional<Solid> solid = any_solid(stream, sweep, kind);
    if (!solid) {
      ++refused;
      continue;
    }
    ++contours;
    for (std::uint64_t ray_id = 0; ray_id < kRaysPerContour; ++ray_id) {
      const Aim aim = aimed(stream, *solid, kRayClasses[ray_id % kRayClasses.size()]);
      if (const std::string why = fault(*solid, aim, tally); !why.empty()) {
        FAIL(name << ' ' << kSeed << ' ' << case_id << ", ray " << ray_id << ": " << why << ", "
                  << text_of(*solid, aim.ray));
      }
      pairs += solid->reference.pieces().size();
    }
  }
  const std::uint64_t rays = wanted * kRaysPerContour;
  INFO(name << ": " << tally << ", pairs " << pairs << ", refused contours " << refused);
  CHECK(contours == wanted);
  CHECK(pairs >= (is_polygon ? kLeastPairsOfPolygons : kLeastPairsOfSplines));
  CHECK(tally.count("inseparable") * 500 <= rays);  // a crossing at infinity
  CHECK(tally.count("certain") >= rays / 2);
  CHECK(tally.count("crossed") >= rays / 4);
  CHECK(tally.count("crossed often") >= (sweep == Sweep::Rotational ? rays / 20 : 1));
  CHECK(tally.count("joint") >= rays / 20);
  CHECK(tally.count("undecided points") * 10 <= tally.count("points"));
  CHECK((sweep == Sweep::Conic || tally.count("no equation") >= rays / 20));
  CHECK((is_polygon && sweep != Sweep::Rotational ? tally.count("in the boundary") >= rays / 40
                                                  : tally.count("touch") >= rays / 40));
}

TEST_CASE("Sides of swept contours are those of a count of crossings in the plane", "[swept]") {
  constexpr std::uint64_t kPoints = 112;  // of each contour: 10^4 in all
  const Sweep sweep = kSweeps[GENERATE(range(0, 3))];
  const ContourKind kind = kKinds[GENERATE(range(0, 3))];
  const std::uint64_t wanted = kind == ContourKind::Line ? 24 : 3;
  support::ClassTally tally{"inside", "outside", "undecided", "on the surface"};
  std::uint64_t contours = 0;
  for (std::uint64_t case_id = 0; contours < wanted && case_id < 10 * wanted; ++case_id) {
    SeededStream stream("swept/side", kSeed, case_id);
    const std::optional<Solid> solid = any_solid(stream, sweep, kind);
    if (!solid) {
      continue;
    }
    ++contours;
    for (std::uint64_t point_id = 0; point_id < kPoints; ++point_id) {
      const Spot spot = spot_at(stream, sweep, any_piece(stream, *solid), any_parameter(stream));
      INFO("case " << case_id << ", point " << point_id << ": "
                   << text_of(*solid, {spot.point, spot.along}));
      REQUIRE(solid->surface.side(spot.point) == 0);
      REQUIRE(membership(*solid, spot.point) == Membership::Undecided);
      tally.add("on the surface");
      const double off = std::pow(2.0, -stream.uniform(0, 40));
      const ExactPoint point = spot.point + exactly(off * any_unit(stream));
      const int side = solid->surface.side(point);
      switch (membership(*solid, point)) {
        case Membership::Inside:
          tally.add("inside");
          REQUIRE(side == -1);
          break;
        case Membership::Outside:
          tally.add("outside");
          REQUIRE(side == 1);
          break;
        case Membership::Undecided:
          tally.add("undecided");
          break;
      }
    }
    if (sweep == Sweep::Conic) {  // but for the apex, no point there is above the contour
      CHECK(solid->surface.side({Rational(1, 8), Rational(-1, 3), 0}) == 1);
    }
  }
  INFO(tally);
  CHECK(contours == wanted);
  CHECK(tally.count("inside") >= wanted * kPoints / 5);
  CHECK(tally.count("outside") >= wanted * kPoints / 5);
  CHECK(tally.count("undecided") * 100 <= wanted * kPoints);
}

TEST_CASE("Crossings of a swept convex polygon are those of its half-spaces", "[swept]") {
  constexpr std::uint64_t kCases = 3000;
  const Sweep sweep = GENERATE(Sweep::Translational, Sweep::Conic);
  const std::vector<PlanePoint> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  support::ClassTally tally{"missed", "crossed", "along a face", "through an edge"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    SeededStream stream("swept/convex", kSeed, case_id);
    const bool is_coarse = case_id % 2 == 0;
    const std::vector<PlanePoint> corners = is_coarse ? square : any_convex(stream);
    const Solid solid = solid_of(sweep, corners, ContourKind::Line, true);
    const ExactRay ray = is_coarse ? any_coarse_ray(stream) : any_small_ray(stream);
    const auto& [o, d] = ray;
    // All of such a ray has one u and v, and is in as many planes as the point is on edges' lines.
    if (sweep == Sweep::Translational ? d.x == 0 && d.y == 0 : cross(o, d) == ExactPoint{}) {
      continue;
    }
    const std::vector<Span> inside = clipped(sweep, corners, ray);
    const SweptSurface::Crossings found = solid.surface.crossings(ray);
    if (const std::string why = fault(found, inside); !why.empty()) {
      FAIL("case " << case_id << ": " << why << ", " << text_of(solid, ray));
    }
    tally.add(found.in_boundary ? "along a face" : found.crossings.empty() ? "missed" : "crossed");
    const SweptCurve::Crossings of_oracle =
        solid.reference.crossings(coordinates(o), coordinates(d));
    tally.add("through an edge", of_oracle.doubt == Doubt::Joint);
  }
  INFO(tally);
  CHECK(tally.each_at_least(kCases / 40));
}

TEST_CASE("Crossings of a turned corner are those of a double cone", "[swept]") {
  constexpr std::uint64_t kCases = 4000;
  const Solid solid =
      solid_of(Sweep::Rotational, {{0, -1}, {1, 0}, {0, 1}}, ContourKind::Line, false);
  support::ClassTally tally{"missed", "crossed", "lower", "upper", "along a line", "irrational"};
  for (std::uint64_t case_id = 0; case_id < kCases; ++case_id) {
    SeededStream stream("swept/cones", kSeed, case_id);
    const ExactRay ray = case_id % 2 == 0 ? any_coarse_ray(stream) : any_small_ray(stream);
    INFO("case " << case_id << ": " << text_of(solid, ray));
    const std::array<Quadratic, 2> cones{cone_along(ray, -1), cone_along(ray, 1)};
    const SweptSurface::Crossings found = solid.surface.crossings(ray);
    const bool is_along = std::any_of(cones.begin(), cones.end(), [](const Quadratic& f) {
      return f.c0 == 0 && f.c1 == 0 && f.c2 == 0;
    });
    REQUIRE(found.in_boundary == is_along);
    if (is_along) {
      tally.add("along a line");
      continue;
    }
    REQUIRE(!found.starts_inside);
    // The solid is convex.
    const bool enters = enters_cone(ray, -1) || enters_cone(ray, 1);
    REQUIRE(found.crossings.size() == (enters ? 2U : 0U));
    tally.add(enters ? "crossed" : "missed");
    if (!enters) {
      continue;
    }
    std::array<number::Enclosure, 2> bounds;
    for (std::size_t i = 0; i < 2; ++i) {
      const SweptSurface::Crossing& crossing = found.crossings[i];
      bounds.at(i) = enclosure(crossing.t, kBits);
      const auto& [low, high] = bounds.at(i);
      REQUIRE(crossing.piece < 2);
      const Quadratic& f = cones.at(crossing.piece);
      REQUIRE(has_root_between(f, low, high));
      tally.add("irrational", sign(f(low)) * sign(f(high)) < 0);
      const int w = crossing.piece == 0 ? -1 : 1;
      const Rational middle = w * (ray.origin.z + (low + high) / 2 * ray.direction.z);
      const Rational tiny = abs(ray.direction.z) * (high - low);
      REQUIRE(middle >= -tiny);
      REQUIRE(middle <= 1 + tiny);
      tally.add(crossing.piece == 0 ? "lower" : "upper");
    }
    const Rational halfway = (bounds[0].upper + bounds[1].lower) / 2;
    REQUIRE(bounds[0].upper < bounds[1].lower);
    REQUIRE(is_in_double_cone(ray.origin + halfway * ray.direction));
  }
  INFO(tally);
  CHECK(tally.each_at_least(kCases / 200));
}

TEST_CASE("Each kind of wrong crossing of a swept contour is noticed", "[swept]") {
  const auto found_at = [](std::uint32_t first_piece, const Rational& first) {
    SweptSurface::Crossings found;
    found.crossings = {{number::Root(first), first_piece}, {number::Root(Rational(2)), 3}};
    return found;
  };
  const SweptSurface::Crossings right = found_at(1, 1);

  SECTION("by the oracle's roots") {
    SweptCurve::Crossings truth;
    truth.crossings = {{1, 1, 1, 1}, {2, 2, 3, 1}};
    CHECK(fault(right, truth).empty());
    CHECK(!fault(found_at(2, 1), truth).empty());
    CHECK(!fault(found_at(1, Rational(9, 8)), truth).empty());
    SweptSurface::Crossings along = right;
    along.in_boundary = true;
    CHECK(!fault(along, truth).empty());
    truth.crossings.pop_back();
    CHECK(!fault(right, truth).empty());
  }
  SECTION("by clipping") {
    Span span;
    span.clip(-1, 1, 1);
    span.clip(2, -1, 3);
    CHECK(fault(right, {span}).empty());
    CHECK(!fault(found_at(2, 1), {span}).empty());
    CHECK(!fault(found_at(1, Rational(9, 8)), {span}).empty());
    SweptSurface::Crossings inside = right;
    inside.starts_inside = true;
    CHECK(!fault(inside, {span}).empty());
    span.clip(0, 0, 4);
    CHECK(!fault(right, {span}).empty());
  }
  SECTION("by points") {
    const Solid square =
        solid_of(Sweep::Translational, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, ContourKind::Line, true);
    const ExactRay ray{{0, Rational(1, 2), 0}, {1, 0, 0}};
    support::ClassTally tally = new_tally();
    const auto why = [&](const SweptSurface::Crossings& found) {
      return fault_at_points(square, ray, found, between(found.crossings), tally);
    };
    CHECK(why(right).empty());
    CHECK(!why(found_at(1, -3)).empty());
    SweptSurface::Crossings inside = right;
    inside.starts_inside = true;
    CHECK(!why(inside).empty());
    SweptSurface::Crossings few = right;
    few.crossings.erase(few.crossings.begin());
    CHECK(!why(few).empty());
  }
}

}  // namespace lamina
