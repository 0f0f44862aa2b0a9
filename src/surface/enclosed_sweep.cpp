#include "surface/enclosed_sweep.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lamina::surface {
namespace {

using geometry::AffineMap;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::Rectangle;
using number::Enclosure;
using number::Integer;
using number::Interval;
using number::Rational;
using EnclosedPoint = EnclosedSweep::EnclosedPoint;
using Polynomial = std::vector<Interval>;
using PlaneRay = PlaneRayOver<Interval>;

EnclosedPoint to_local(const AffineMap& map, const EnclosedPoint& point) {
  const auto along = [&](std::size_t row) {
    const auto entry = [&](std::size_t i) { return as_in(point.x, map.rows.at(row).at(i)); };
    return entry(0) * point.x + entry(1) * point.y + entry(2) * point.z + entry(3);
  };
  return {along(0), along(1), along(2)};
}

// Coordinates that do not change along the ray are constants.
PlaneRay plane_ray_of(const SweptSurface& surface, const EnclosedPoint& origin,
                      const ExactPoint& direction) {
  const auto linear = [](const Interval& from, const Rational& way) {
    return way.is_zero() ? Polynomial{from} : Polynomial{from, as_in(from, way)};
  };
  return plane_ray<Interval>(surface, {{linear(origin.x, direction.x),
                                        linear(origin.y, direction.y),
                                        linear(origin.z, direction.z),
                                        {as_in(origin.x, 1)}}});
}

Interval value_at(const Polynomial& p, const Interval& s) {
  Interval value = p.back();
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    value = value * s + p[i];
  }
  return value;
}

// The point at s as a ray that stays there.
PlaneRay place_at(const PlaneRay& ray, const Interval& s) {
  const auto at = [&s](const Polynomial& p) {
    return p.empty() ? Polynomial{} : Polynomial{value_at(p, s)};
  };
  return {ray.u ? std::optional(at(*ray.u)) : std::nullopt, at(ray.u_squared), at(ray.v),
          at(ray.w)};
}

// Is x / w < low or x / w > high, for certain? At w = 0 it is, if x is not zero.
bool is_off(const Interval& x, const Interval& w, const Rational& low, const Rational& high) {
  const auto beyond_low = (x - as_in(x, low) * w).sign();
  return beyond_low && *beyond_low != 0 && beyond_low == (x - as_in(x, high) * w).sign();
}

bool is_off(const PlaneRay& place, const std::vector<Rectangle>& boxes) {
  const Interval& v = place.v[0];
  const Interval& w = place.w[0];
  return std::all_of(boxes.begin(), boxes.end(), [&](const Rectangle& box) {
    return is_off(v, w, box.v_min, box.v_max) ||
           (place.u ? is_off((*place.u)[0], w, box.u_min, box.u_max)
                    : is_off(place.u_squared[0], w, least_square(box), box.u_max * box.u_max));
  });
}

// Does the whole ray miss them, for certain?
bool is_missed(const PlaneRay& ray, const std::vector<Rectangle>& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [&ray](const Rectangle& box) {
    return ray.u ? line_misses(ray, box) : ring_is_missed(ray, box);
  });
}

bool is_zero(const Interval& coefficient) { return coefficient.sign() == 0; }

bool is_uncertain(const Interval& coefficient) { return !coefficient.sign(); }

// s = u / (1 - u), which does not reach 1.
Interval parameter(const Enclosure& u, int bits) {
  return {Enclosure{u.lower / (1 - u.lower), u.upper / (1 - u.upper)}, bits};
}

// The root is refined until it is narrow, or no rectangle of its pieces holds the ray's point.
bool is_off(poly::IsolatedRoot& root, const PlaneRay& ray, const std::vector<Rectangle>& boxes) {
  constexpr int kSteps = 4;  // to about 2^-20, as the Newton method doubles the bits
  for (int step = 0; step < kSteps; ++step) {
    if (root.bounds().upper < 1 &&
        is_off(place_at(ray, parameter(root.bounds(), ray.v[0].bits())), boxes)) {
      return true;
    }
    if (!root.refine()) {
      break;
    }
  }
  return false;
}

// The one with the smallest power of two below it, 0 < u < 1, of the closed interval.
Rational dyadic_in(const Enclosure& interval) {
  for (unsigned bits = 1;; ++bits) {
    const Integer whole = Integer(1) << bits;
    const Rational scaled = interval.lower * whole;
    const Integer above = (numerator(scaled) + denominator(scaled) - 1) / denominator(scaled);
    Rational u(std::max(above, Integer(1)), whole);
    if (u <= interval.upper && u < 1) {
      return u;
    }
  }
}

// Values u between consecutive roots, one before and one behind them; none if the roots cannot be
// told from zero or from infinity. The roots' intervals do not overlap.
std::optional<std::vector<Rational>> samples(std::vector<EnclosedSweep::Crossing>& candidates) {
  if (!candidates.empty()) {
    poly::IsolatedRoot& first = candidates.front().root;
    poly::IsolatedRoot& last = candidates.back().root;
    while (first.bounds().lower <= 0 || last.bounds().upper >= 1) {
      if (!(first.bounds().lower <= 0 ? first : last).refine()) {
        return std::nullopt;
      }
    }
  }
  std::vector<Rational> result;
  for (std::size_t i = 0; i <= candidates.size(); ++i) {
    result.push_back(
        dyadic_in({i == 0 ? Rational(0) : candidates[i - 1].root.bounds().upper,
                   i == candidates.size() ? Rational(1) : candidates[i].root.bounds().lower}));
  }
  return result;
}

// The degree of u, v and w in a point's coordinates; u^2 of a rotational sweep counts as two.
int plane_degree(const SweptSurface& surface) {
  if (surface.sweep() != Sweep::GeneralisedConic) {
    return 1;
  }
  const PlaneRayOver<Rational> any = plane_ray(surface, {{0, 0, 0}, {1, 1, 1}});
  return static_cast<int>(std::max({any.u->size(), any.v.size(), any.w.size()})) - 1;
}

}  // namespace

EnclosedSweep::EnclosedSweep(std::shared_ptr<const PlacedSweep> sweep) : sweep_(std::move(sweep)) {
  const SweptSurface& surface = this->surface();
  const auto pieces = surface.contour().pieces();
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (!surface.sweeps(i)) {
      continue;
    }
    const ContourCurve& equation = surface.curve(i);
    auto known = std::find_if(curves_.begin(), curves_.end(), [&equation](const Curve& curve) {
      return curve.equation == equation;
    });
    if (known == curves_.end()) {
      known = curves_.insert(known, {equation, {}, {}});
      if (surface.sweep() == Sweep::Rotational) {
        known->on_axis = curve_on_axis(pieces[i]);
      }
    }
    known->boxes.push_back(surface.contour().boxes()[i]);
  }
}

std::vector<EnclosedSweep::CurveIndex> EnclosedSweep::curves_at(const ExactRay& ray,
                                                                const number::Root& t,
                                                                const EnclosedPoint& point) const {
  const AffineMap& map = sweep_->to_local;
  PlaneMonomials<Interval> enclosed(plane_ray_of(surface(), to_local(map, point), {0, 0, 0}));
  PlaneMonomials<Rational> exact(
      plane_ray(surface(), {apply(map, ray.origin), apply_to_direction(map, ray.direction)}));
  std::vector<CurveIndex> curves;
  for (CurveIndex c = 0; c < curves_.size(); ++c) {
    const ContourCurve& equation = curves_[c].equation;
    if (enclosed.restrict(equation).front().sign().value_or(0) == 0 &&
        sign_at(number::with_cleared_denominators(exact.restrict(equation)), t) == 0) {
      curves.push_back(c);
    }
  }
  return curves;
}

// Is the coefficient of this power of s zero for all origins? It is a polynomial in these, of a
// degree not above that of g less the power, and zero if it is so at all points with coordinates
// 0, 1, 2 ... of a sum not above that degree.
bool EnclosedSweep::has_zero_coefficient(const ContourCurve& equation, const ExactPoint& direction,
                                         std::size_t power) const {
  constexpr int kMost = 2;  // a cubic's coefficients that can be zero for all
  const int degree = equation.degree * plane_degree(surface()) - static_cast<int>(power);
  if (degree > kMost) {
    return false;
  }
  for (int x = 0; x <= degree; ++x) {
    for (int y = 0; x + y <= degree; ++y) {
      for (int z = 0; x + y + z <= degree; ++z) {
        PlaneMonomials<Rational> monomials(plane_ray(surface(), {{x, y, z}, direction}));
        const std::vector<Rational> g = monomials.restrict(equation);
        if (power < g.size() && !g[power].is_zero()) {
          return false;
        }
      }
    }
  }
  return true;
}

// Inside or outside as an exact point that no curve's piece separates from it.
std::optional<int> EnclosedSweep::side_at(const EnclosedPoint& point) const {
  constexpr int kFewBits = 24;  // mostly suffice, and so make the exact point a short one
  for (int bits = kFewBits;; bits *= 2) {
    const auto rounded = [bits](const Interval& x) {
      return bits < x.bits() ? Interval(Enclosure{x.lower(), x.upper()}, bits) : x;
    };
    const EnclosedPoint box{rounded(point.x), rounded(point.y), rounded(point.z)};
    const PlaneRay place = plane_ray_of(surface(), box, {0, 0, 0});
    PlaneMonomials<Interval> monomials(place);
    const bool is_free = std::all_of(curves_.begin(), curves_.end(), [&](const Curve& curve) {
      return is_off(place, curve.boxes) ||
             monomials.restrict(curve.equation).front().sign().value_or(0) != 0;
    });
    if (is_free) {
      const auto middle = [](const Interval& x) { return Rational((x.lower() + x.upper()) / 2); };
      return surface().side({middle(box.x), middle(box.y), middle(box.z)});
    }
    if (bits >= point.x.bits()) {
      return std::nullopt;
    }
  }
}

struct EnclosedSweep::LocalRay {
  EnclosedPoint origin;
  ExactPoint direction;
  PlaneRay plane;
  PlaneMonomials<Interval> monomials;
  const Start& start;

  [[nodiscard]] bool starts_on(CurveIndex curve) const {
    return std::binary_search(start.curves.begin(), start.curves.end(), curve);
  }
};

EnclosedSweep::LocalRay EnclosedSweep::local_ray(const EnclosedPoint& origin,
                                                 const ExactPoint& direction,
                                                 const Start& start) const {
  const EnclosedPoint from = to_local(sweep_->to_local, origin);
  const ExactPoint way = apply_to_direction(sweep_->to_local, direction);
  const PlaneRay plane = plane_ray_of(surface(), from, way);
  return {from, way, plane, PlaneMonomials<Interval>(plane), start};
}

Polynomial EnclosedSweep::restrict(CurveIndex curve, LocalRay& ray) const {
  const bool is_on_axis =
      !ray.plane.u && std::all_of(ray.plane.u_squared.begin(), ray.plane.u_squared.end(), is_zero);
  const ContourCurve& equation = is_on_axis ? *curves_[curve].on_axis : curves_[curve].equation;
  Polynomial g = ray.monomials.restrict(equation);
  if (ray.starts_on(curve)) {
    g.front() = Interval();
  }
  while (!g.empty() &&
         (is_zero(g.back()) || (is_uncertain(g.back()) &&
                                has_zero_coefficient(equation, ray.direction, g.size() - 1)))) {
    g.pop_back();
  }
  g.erase(g.begin(), std::find_if_not(g.begin(), g.end(), is_zero));
  return g;
}

std::optional<poly::IsolatedRoot> EnclosedSweep::root_at(const Place& place,
                                                         const EnclosedPoint& origin,
                                                         const ExactPoint& direction,
                                                         const Start& start) const {
  LocalRay ray = local_ray(origin, direction, start);
  auto roots = poly::positive_roots(restrict(place.curve, ray));
  return roots ? std::optional(std::move((*roots)[place.root])) : std::nullopt;
}

std::optional<EnclosedSweep::Crossings> EnclosedSweep::crossings(const EnclosedPoint& origin,
                                                                 const ExactPoint& direction,
                                                                 const Start& start) const {
  LocalRay ray = local_ray(origin, direction, start);
  std::vector<Crossing> candidates;
  for (CurveIndex c = 0; c < curves_.size(); ++c) {
    const Curve& curve = curves_[c];
    if (is_missed(ray.plane, curve.boxes)) {
      continue;
    }
    Polynomial g = restrict(c, ray);
    if (g.empty()) {
      // It stays on the curve: on the surface, if that is nothing but this curve around the start.
      return ray.starts_on(c) && start.on_surface && start.curves.size() == 1
                 ? std::optional(Crossings{})
                 : std::nullopt;
    }
    auto roots = poly::positive_roots(std::move(g));
    if (!roots) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < roots->size(); ++i) {
      if (!is_off((*roots)[i], ray.plane, curve.boxes)) {
        candidates.push_back({std::move((*roots)[i]), {c, i}});
      }
    }
  }
  const bool is_sorted = poly::sort_by_root(
      candidates, [](Crossing& candidate) -> poly::IsolatedRoot& { return candidate.root; });
  const auto between = is_sorted ? samples(candidates) : std::nullopt;
  if (!between) {
    return std::nullopt;
  }
  Crossings result;
  int before = 0;
  for (std::size_t i = 0; i <= candidates.size(); ++i) {
    const Rational s = (*between)[i] / (1 - (*between)[i]);
    const auto at = [&s](const Interval& x, const Rational& along) {
      return x + as_in(x, s * along);
    };
    const auto& [o, d] = std::tie(ray.origin, ray.direction);
    const auto side = side_at({at(o.x, d.x), at(o.y, d.y), at(o.z, d.z)});
    if (!side) {
      return std::nullopt;
    }
    if (i == 0) {
      result.sign = *side;
    } else if (*side != before) {
      result.crossings.push_back(std::move(candidates[i - 1]));
    }
    before = *side;
  }
  return result;
}

}  // namespace lamina::surface
