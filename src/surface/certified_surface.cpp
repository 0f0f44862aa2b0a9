#include "surface/certified_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "number/double_interval.hpp"

namespace lamina::surface {
namespace {

using geometry::Ray;
using geometry::Vector3;
using number::DoubleInterval;
using number::middle_of;
using poly::Bounds;
using poly::CertifiedRoots;

Bounds bounds_of(const DoubleInterval& x) { return {x.inf(), x.sup()}; }
DoubleInterval interval(const Bounds& x) { return {x.low, x.high}; }

// Most coefficients are 0 or 1, and a product of intervals takes long.
DoubleInterval times(const Bounds& c, const DoubleInterval& x) {
  if (c.low == c.high && (c.low == 0 || c.low == 1)) {
    return c.low == 0 ? DoubleInterval(0) : x;
  }
  return interval(c) * x;
}

// c[0] v.x + c[1] v.y + c[2] v.z
DoubleInterval dot(std::span<const Bounds> c, const Vector3<DoubleInterval>& v) {
  return times(c[0], v.x) + times(c[1], v.y) + times(c[2], v.z);
}

Vector3<DoubleInterval> at(const Ray<DoubleInterval>& ray, const DoubleInterval& t) {
  return ray.origin + t * ray.direction;
}

CertifiedRoots undecided() {
  CertifiedRoots none;
  none.outcome = poly::Outcome::Undecided;
  return none;
}

// Those that are in the range, of enclosures in the order of their roots; undecided where two
// overlap, or an end of the range is in one.
CertifiedRoots only_in(const poly::Range<double>& range,
                       std::span<const DoubleInterval> ascending) {
  CertifiedRoots roots;
  double before = -std::numeric_limits<double>::infinity();
  for (const DoubleInterval& t : ascending) {
    if (t.inf() <= before) {
      return undecided();
    }
    before = t.sup();
    if (t.sup() < range.low || range.high < t.inf()) {
      continue;
    }
    if (t.inf() <= range.low || range.high <= t.sup()) {
      return undecided();
    }
    roots.t[roots.count++] = bounds_of(t);
  }
  return roots;
}

// The crossings of a t^2 + 2 b t + c, or of 2 b t + c where a is certainly zero.
std::optional<std::size_t> quadratic(const DoubleInterval& a, const DoubleInterval& b,
                                     const DoubleInterval& c, std::array<DoubleInterval, 2>& t) {
  const auto sign_a = number::sign(a);
  if (sign_a == 0) {
    const auto sign_b = number::sign(b);
    if (sign_b == 0) {
      return number::sign(c).value_or(0) != 0 ? std::optional<std::size_t>(0) : std::nullopt;
    }
    t[0] = -c / (DoubleInterval(2) * b);
    return sign_b ? std::optional<std::size_t>(1) : std::nullopt;
  }
  const DoubleInterval discriminant = CGAL::square(b) - a * c;
  const auto sign = number::sign(discriminant);
  if (!sign_a || sign.value_or(0) == 0) {
    return std::nullopt;
  }
  if (sign == -1) {
    return 0;
  }
  // At the point nearest to the centre b is about zero: nothing cancels in either.
  const DoubleInterval root = CGAL::sqrt(discriminant);
  t = {(-b - root) / a, (root - b) / a};
  if (sign_a == -1) {
    std::swap(t[0], t[1]);
  }
  return 2;
}

}  // namespace

CertifiedSurface::CertifiedSurface(const LocalSurface& exact, const geometry::AffineMap& to_local)
    : kind_(exact.kind) {
  const auto enclosed = [](const number::Rational& x) { return bounds_of(number::enclosing(x)); };
  std::transform(exact.coefficients.begin(), exact.coefficients.end(), c_.begin(), enclosed);
  for (std::size_t i = 0; i < to_local_.size(); ++i) {
    std::transform(to_local.rows[i].begin(), to_local.rows[i].end(), to_local_[i].begin(),
                   enclosed);
  }
  if (kind_ == Kind::Torus) {
    const number::RoundingUpwards upwards;
    bounding_radius_ = c_[0].high + c_[1].high;
  }
}

poly::CertifiedRoots CertifiedSurface::crossings(const Ray<double>& world,
                                                 const poly::Range<double>& range) const {
  const number::RoundingUpwards upwards;
  const auto local = [this](const Vector3<double>& v, double w) {
    const Vector3<DoubleInterval> point{v.x, v.y, v.z};
    const auto row = [&](std::size_t i) -> DoubleInterval {
      return dot(to_local_[i], point) + times(to_local_[i][3], w);
    };
    return Vector3<DoubleInterval>{row(0), row(1), row(2)};
  };
  const Ray<DoubleInterval> ray{local(world.origin, 1), local(world.direction, 0)};
  const Vector3<DoubleInterval>& d = ray.direction;
  std::array<DoubleInterval, 2> t;
  if (kind_ == Kind::Plane) {
    const auto count =
        quadratic(0, dot(c_, d) / DoubleInterval(2), dot(c_, ray.origin) + interval(c_[3]), t);
    return count ? only_in(range, std::span(t).first(*count)) : undecided();
  }
  // Any shift is right: it is a double, and the point there is enclosed.
  const double dd = middle_of(dot(d, d));
  const double nearest = -middle_of(dot(ray.origin, d)) / dd;
  if (!std::isfinite(nearest)) {
    return undecided();
  }
  if (kind_ == Kind::Quadric) {
    const Vector3<DoubleInterval> o = at(ray, nearest);
    const DoubleInterval half(0.5);
    const auto half_gradient = [&](const Vector3<DoubleInterval>& v) {
      return Vector3<DoubleInterval>{
          times(c_[0], v.x) + half * (times(c_[3], v.y) + times(c_[4], v.z)),
          times(c_[1], v.y) + half * (times(c_[3], v.x) + times(c_[5], v.z)),
          times(c_[2], v.z) + half * (times(c_[4], v.x) + times(c_[5], v.y))};
    };
    const std::span<const Bounds> linear = std::span(c_).subspan(6, 3);
    const Vector3<DoubleInterval> along = half_gradient(d);
    const auto count = quadratic(dot(along, d), dot(along, o) + half * dot(linear, d),
                                 dot(half_gradient(o), o) + dot(linear, o) + interval(c_[9]), t);
    if (!count) {
      return undecided();
    }
    const auto found = std::span(t).first(*count);
    for (DoubleInterval& root : found) {
      root += DoubleInterval(nearest);
    }
    return only_in(range, found);
  }
  // From outside of the ball that bounds the torus to outside of it again.
  const double reach = 2 * bounding_radius_ / std::sqrt(dd);
  const double start = nearest - reach;
  const Vector3<DoubleInterval> o = at(ray, start);
  const DoubleInterval four(4);
  const DoubleInterval major = interval(c_[0]);
  const DoubleInterval minor = interval(c_[1]);
  const DoubleInterval ring = CGAL::square(major);
  const DoubleInterval gap = (major - minor) * (major + minor);
  const auto squared = [](const Vector3<DoubleInterval>& v) {
    return CGAL::square(v.x) + CGAL::square(v.y) + CGAL::square(v.z);
  };
  const Vector3<DoubleInterval> end = at(ray, DoubleInterval(start) + DoubleInterval(2 * reach));
  const double outside = bounding_radius_ * bounding_radius_;
  const DoubleInterval dd_interval = squared(d);
  const DoubleInterval od = dot(o, d);
  if (!(squared(o).inf() > outside && squared(end).inf() > outside && od.sup() < 0 &&
        dot(end, d).inf() > 0)) {
    return undecided();
  }
  const DoubleInterval k = squared(o) + gap;
  const std::array<Bounds, 5> f{
      bounds_of(CGAL::square(k) - four * ring * (CGAL::square(o.x) + CGAL::square(o.y))),
      bounds_of(four * od * k - four * DoubleInterval(2) * ring * (o.x * d.x + o.y * d.y)),
      bounds_of(DoubleInterval(2) * dd_interval * k + four * CGAL::square(od) -
                four * ring * (CGAL::square(d.x) + CGAL::square(d.y))),
      bounds_of(four * dd_interval * od), bounds_of(CGAL::square(dd_interval))};
  const CertifiedRoots found = poly::certified_roots(f, 2 * reach);
  if (found.outcome != poly::Outcome::Found) {
    return undecided();
  }
  std::array<DoubleInterval, 4> shifted;
  for (int i = 0; i < found.count; ++i) {
    shifted[i] = interval(found.t[i]) + DoubleInterval(start);
  }
  return only_in(range, std::span(shifted).first(found.count));
}

}  // namespace lamina::surface
