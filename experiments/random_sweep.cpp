#include "experiments/random_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>

#include "base/contract.hpp"

namespace lamina::experiments {
namespace {

using base::SeededStream;
using geometry::ContourKind;
using geometry::ContourPiece;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::PlanePoint;
using geometry::value_at;
using geometry::Vector3;
using number::nearest_double;
using number::Rational;
using surface::Scaling;
using surface::Sweep;
using surface::SweptSurface;

constexpr double kAway = 4;    // of rays that are not far: outside of every sweep's box
constexpr double kHeight = 1;  // of the part of an endless sweep that rays are aimed at

Rational on_grid(double value) {
  constexpr int kDenominator = 1024;
  constexpr int kSteps = 6;
  return {kSteps * static_cast<std::int64_t>(std::lround(value * kDenominator / kSteps)),
          kDenominator};
}

// With angles that increase by less than half a turn: the polygon goes around the centre once.
std::vector<PlanePoint> any_star(SeededStream& stream, const PlanePoint& centre) {
  const std::int64_t count = stream.integer(4, 12);
  std::vector<PlanePoint> points;
  for (std::int64_t i = 0; i < count; ++i) {
    const double turn =
        (static_cast<double>(i) + stream.uniform(0, 0.8)) / static_cast<double>(count);
    const double angle = 2 * std::numbers::pi * turn;
    const double radius = stream.uniform(0.25, 1.5);
    points.push_back({centre.u + on_grid(radius * std::cos(angle)),
                      centre.v + on_grid(radius * std::sin(angle))});
  }
  return points;
}

// Always upwards, so that it does not cross itself.
std::vector<PlanePoint> any_profile(SeededStream& stream) {
  const std::int64_t last = stream.integer(3, 8);
  std::vector<PlanePoint> points{{0, on_grid(-1)}};
  for (std::int64_t i = 1; i < last; ++i) {
    const double height =
        (static_cast<double>(i) + stream.uniform(-0.4, 0.4)) * 2 / static_cast<double>(last) - 1;
    points.push_back({on_grid(stream.uniform(0.375, 1.5)), on_grid(height)});
  }
  points.push_back({0, on_grid(1)});
  return points;
}

Vector3<double> any_unit(SeededStream& stream) {
  for (;;) {
    const Vector3<double> v{stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)};
    const double square = dot(v, v);
    if (square > 0.01 && square <= 1) {
      return geometry::normalised(v);
    }
  }
}

Rational held(double value, int bits) {
  return bits == 24 ? Rational(static_cast<float>(value)) : Rational(value);
}

ExactRay held(const Vector3<double>& origin, const Vector3<double>& direction, int bits) {
  return {{held(origin.x, bits), held(origin.y, bits), held(origin.z, bits)},
          {held(direction.x, bits), held(direction.y, bits), held(direction.z, bits)}};
}

// A random point of the box of the surface's part that rays are aimed at.
Vector3<double> any_aim(SeededStream& stream, const SweptSurface& surface) {
  const auto boxes = surface.contour().boxes();
  geometry::Rectangle all = boxes.front();
  for (const geometry::Rectangle& box : boxes) {
    all.u_min = std::min(all.u_min, box.u_min);
    all.u_max = std::max(all.u_max, box.u_max);
    all.v_min = std::min(all.v_min, box.v_min);
    all.v_max = std::max(all.v_max, box.v_max);
  }
  const double v = stream.uniform(nearest_double(all.v_min), nearest_double(all.v_max));
  if (surface.sweep() == Sweep::Rotational) {
    const double most = nearest_double(all.u_max);
    return {stream.uniform(-most, most), stream.uniform(-most, most), v};
  }
  const double u = stream.uniform(nearest_double(all.u_min), nearest_double(all.u_max));
  const double z = stream.uniform(-kHeight, kHeight);
  if (surface.sweep() == Sweep::GeneralisedConic) {
    const auto& [p, q] = surface.scaling();
    return {u * nearest_double(value_at(p, Rational(z))),
            v * nearest_double(value_at(q, Rational(z))), z};
  }
  return surface.sweep() == Sweep::Conic ? Vector3<double>{u * z, v * z, z}
                                         : Vector3<double>{u, v, z};
}

double slope_at(const std::vector<Rational>& p, double s) {
  double slope = 0;
  for (std::size_t i = p.size() - 1; i > 0; --i) {
    slope = slope * s + static_cast<double>(i) * nearest_double(p[i]);
  }
  return slope;
}

// At a random point of a random piece.
ExactRay grazing(SeededStream& stream, const SweptSurface& surface, const RayFamily& family) {
  const auto pieces = surface.contour().pieces();
  std::size_t i = 0;
  do {
    i = stream.below(pieces.size());
  } while (!surface.sweeps(static_cast<std::uint32_t>(i)));
  const double s = stream.uniform(0, 1);
  const double u = nearest_double(value_at(pieces[i].u, Rational(s)));
  const double v = nearest_double(value_at(pieces[i].v, Rational(s)));
  const double du = slope_at(pieces[i].u, s);
  const double dv = slope_at(pieces[i].v, s);
  Vector3<double> point;
  Vector3<double> along_contour;
  Vector3<double> along_sweep;
  switch (surface.sweep()) {
    case Sweep::Translational:
      point = {u, v, stream.uniform(-kHeight, kHeight)};
      along_contour = {du, dv, 0};
      along_sweep = {0, 0, 1};
      break;
    case Sweep::Conic: {
      const double z = (stream.chance(0.5) ? 1 : -1) * stream.uniform(0.25, 1) * kHeight;
      point = {u * z, v * z, z};
      along_contour = {du, dv, 0};
      along_sweep = {u, v, 1};
      break;
    }
    case Sweep::GeneralisedConic: {
      const auto& [of_x, of_y] = surface.scaling();
      const double z = stream.uniform(-kHeight, kHeight);
      const double p = nearest_double(value_at(of_x, Rational(z)));
      const double q = nearest_double(value_at(of_y, Rational(z)));
      point = {u * p, v * q, z};
      along_contour = {du * p, dv * q, 0};
      along_sweep = {u * slope_at(of_x, z), v * slope_at(of_y, z), 1};
      break;
    }
    case Sweep::Rotational: {
      const double angle = stream.uniform(0, 2 * std::numbers::pi);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      point = {u * x, u * y, v};
      along_contour = {du * x, du * y, dv};
      along_sweep = {-y, x, 0};
      break;
    }
  }
  const Vector3<double> a = geometry::normalised(along_contour);
  const Vector3<double> outward = geometry::normalised(cross(a, geometry::normalised(along_sweep)));
  const Vector3<double> b = cross(outward, a);
  const double angle = stream.uniform(0, 2 * std::numbers::pi);
  const Vector3<double> direction = std::cos(angle) * a + std::sin(angle) * b;
  // Which of both sides is inside shows well away from rounding, and from the other side's surface.
  constexpr double kProbe = 1.0 / 1024;
  const auto exact = [](const Vector3<double>& p) {
    return ExactPoint{Rational(p.x), Rational(p.y), Rational(p.z)};
  };
  const double inwards = surface.side(exact(point + kProbe * outward)) < 0 ? 1 : -1;
  const Vector3<double> through = point + inwards * family.parameter * outward;
  return held(through - kAway * direction, direction, family.held_bits);
}

// Through where a piece begins. Of a rotational sweep in a plane x = 0 or y = 0, since its radius
// is a short number there.
ExactRay through_joint(SeededStream& stream, const SweptSurface& surface) {
  const auto pieces = surface.contour().pieces();
  Rational u;
  Rational v;
  do {
    const ContourPiece& piece = pieces[stream.below(pieces.size())];
    u = piece.u.front();
    v = piece.v.front();
  } while (surface.sweep() == Sweep::Rotational && u.is_zero());
  ExactPoint joint{u, v, 0};
  switch (surface.sweep()) {
    case Sweep::Translational:
      joint.z = Rational(stream.integer(-4, 4), 4);
      break;
    case Sweep::Conic: {
      joint.z = Rational((stream.chance(0.5) ? 1 : -1) * stream.integer(1, 4), 4);
      joint.x *= joint.z;
      joint.y *= joint.z;
      break;
    }
    case Sweep::GeneralisedConic:
      joint.z = stream.chance(0.5) ? 1 : -1;
      joint.x *= value_at(surface.scaling().x, joint.z);
      joint.y *= value_at(surface.scaling().y, joint.z);
      break;
    case Sweep::Rotational: {
      const Rational radius = stream.chance(0.5) ? u : -u;
      joint = stream.chance(0.5) ? ExactPoint{radius, 0, v} : ExactPoint{0, radius, v};
      break;
    }
  }

  const auto component = [&stream] {
    return Rational((stream.chance(0.5) ? 1 : -1) * stream.integer(1, 64), 64);
  };
  const ExactPoint direction{component(), component(), component()};
  return {joint - Rational(static_cast<int>(kAway)) * direction, direction};
}

// A line and a parabola, of coefficients of four bits.
Scaling any_scaling(SeededStream& stream) {
  const auto any = [&stream] {
    return Rational((stream.chance(0.5) ? 1 : -1) * stream.integer(1, 8), 8);
  };
  return {{any(), any()}, {any(), any(), any()}};
}

}  // namespace

std::string short_name(Sweep sweep) {
  const std::string name(surface::name_of(sweep));
  return name.substr(0, name.find('_'));
}

SweptSurface any_sweep(SeededStream& stream, Sweep sweep, ContourKind kind) {
  const bool turned = sweep == Sweep::Rotational;
  for (;;) {
    const bool closed = !turned || stream.chance(0.5);
    const PlanePoint centre{turned ? on_grid(2) : on_grid(stream.uniform(-1, 1)),
                            on_grid(stream.uniform(-1, 1))};
    std::vector<PlanePoint> points = closed ? any_star(stream, centre) : any_profile(stream);
    try {
      auto contour = std::make_shared<const geometry::Contour>(std::move(points), kind, closed);
      return sweep == Sweep::GeneralisedConic
                 ? SweptSurface(any_scaling(stream), std::move(contour))
                 : SweptSurface(sweep, std::move(contour));
    } catch (const base::InputError&) {
      LAMINA_REQUIRE(kind != ContourKind::Line, "a star and a profile do not cross themselves");
    }
  }
}

std::string RayFamily::name() const {
  switch (kind) {
    case RayKind::From:
      return "from";
    case RayKind::Grazing:
      return "grazing";
    case RayKind::Joint:
      return "joint";
    case RayKind::Along:
      return "along the axis";
    case RayKind::Level:
      return "level";
  }
  return {};
}

ExactRay any_ray(SeededStream& stream, const SweptSurface& surface, const RayFamily& family) {
  const int bits = family.held_bits;
  switch (family.kind) {
    case RayKind::From:
      break;
    case RayKind::Grazing:
      return grazing(stream, surface, family);
    case RayKind::Joint:
      return through_joint(stream, surface);
    case RayKind::Along:
    case RayKind::Level: {
      const double angle = stream.uniform(0, 2 * std::numbers::pi);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double upwards = stream.chance(0.5) ? 1 : -1;
      const bool along = family.kind == RayKind::Along;
      const double across = along ? family.parameter : 1;
      const double axial = upwards * (along ? 1 : family.parameter);
      const Vector3<double> direction{across * x, across * y, axial};
      return held(any_aim(stream, surface) - kAway * direction, direction, bits);
    }
  }
  const Vector3<double> direction = any_unit(stream);
  return held(any_aim(stream, surface) - family.parameter * direction, direction, bits);
}

surface::SphereSweep any_sphere_sweep(SeededStream& stream, ContourKind kind) {
  const bool closed = stream.chance(0.5);
  const std::int64_t count = stream.integer(3, 7);
  std::vector<ExactPoint> points;
  const auto any = [&stream] { return on_grid(stream.uniform(-1.5, 1.5)); };
  while (static_cast<std::int64_t>(points.size()) < count) {
    const ExactPoint point{any(), any(), any()};
    if (std::find(points.begin(), points.end(), point) == points.end()) {
      points.push_back(point);
    }
  }
  return {Rational(stream.integer(16, 32), 64),
          std::make_shared<const geometry::Trajectory>(std::move(points), kind, closed)};
}

ExactRay any_ray(SeededStream& stream, const surface::SphereSweep& surface,
                 const RayFamily& family) {
  const geometry::Trajectory& trajectory = surface.trajectory();
  const double radius = nearest_double(surface.radius());
  const auto pieces = trajectory.pieces();
  const geometry::TrajectoryPiece& piece = pieces[stream.below(pieces.size())];
  const double u = stream.unit();
  const Vector3<double> centre = nearest_double(geometry::point_at(piece, Rational(u)));
  const Vector3<double> direction = any_unit(stream);
  if (family.kind == RayKind::From) {
    const Vector3<double> aim =
        centre + 1.25 * radius * std::cbrt(stream.unit()) * any_unit(stream);
    return held(aim - family.parameter * direction, direction, family.held_bits);
  }
  LAMINA_REQUIRE(family.kind == RayKind::Grazing, "a sphere sweep has no other rays");
  // At right angles to the trajectory, so that the point is on the envelope.
  const Vector3<double> along = geometry::normalised(
      Vector3<double>{slope_at(piece[0], u), slope_at(piece[1], u), slope_at(piece[2], u)});
  const Vector3<double> outward = geometry::normalised(cross(along, any_unit(stream)));
  const Vector3<double> beside = geometry::normalised(cross(outward, direction));
  const Vector3<double> through = centre + (radius - family.parameter) * outward;
  return held(through - kAway * beside, beside, family.held_bits);
}

}  // namespace lamina::experiments
