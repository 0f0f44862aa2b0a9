#include "surface/swept_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/contract.hpp"
#include "surface/contour_curve.hpp"
#include "surface/exact_line.hpp"

namespace lamina::surface {
namespace {

using geometry::Contour;
using geometry::ContourPiece;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::Rectangle;
using geometry::value_at;
using number::IntegerPolynomial;
using number::Rational;
using number::Root;

using Polynomial = RationalPolynomial;
using PlaneRay = PlaneRayOver<Rational>;

Polynomial shifted(Polynomial p, const Rational& by) {
  p.front() += by;
  return p;
}

bool is_on_axis(const ContourPiece& piece) {
  return std::all_of(piece.u.begin(), piece.u.end(), [](const Rational& c) { return c.is_zero(); });
}

struct Range {
  Rational low;
  Rational high;
};

Range range_of(const Rational& a, const Rational& b) { return a < b ? Range{a, b} : Range{b, a}; }

// Encloses a polynomial over an interval of t; the narrowest that does, for degree 2 at most.
Range range_over(const Polynomial& p, const Range& t) {
  if (p.size() > 3) {
    Range range{p.back(), p.back()};
    for (auto c = std::next(p.rbegin()); c != p.rend(); ++c) {
      const auto [least, greatest] =
          std::minmax({Rational(range.low * t.low), Rational(range.low * t.high),
                       Rational(range.high * t.low), Rational(range.high * t.high)});
      range = {least + *c, greatest + *c};
    }
    return range;
  }
  Range range = range_of(value_at(p, t.low), value_at(p, t.high));
  if (p.size() > 2 && !p[2].is_zero()) {
    const Rational turn = -p[1] / (2 * p[2]);
    if (t.low < turn && turn < t.high) {
      const Rational extreme = value_at(p, turn);
      range = {std::min(range.low, extreme), std::max(range.high, extreme)};
    }
  }
  return range;
}

// Is low <= x / w <= high impossible for these?
bool is_off(const Range& x, const Range& w, const Rational& low, const Rational& high) {
  // Beyond a bound x - low w and x - high w have the same sign.
  const auto minus = [&](const Rational& bound) {
    const Range scaled = range_of(bound * w.low, bound * w.high);
    return Range{x.low - scaled.high, x.high - scaled.low};
  };
  const Range from_low = minus(low);
  const Range from_high = minus(high);
  return (w.low > 0 || w.high < 0) &&
         ((from_low.high < 0 && from_high.high < 0) || (from_low.low > 0 && from_high.low > 0));
}

// Is no point of the ray with t in this interval in the rectangle, for certain?
bool misses(const PlaneRay& ray, const Range& t, const Rectangle& box) {
  const Range w = range_over(ray.w, t);
  if (is_off(range_over(ray.v, t), w, box.v_min, box.v_max)) {
    return true;
  }
  if (ray.u) {
    return is_off(range_over(*ray.u, t), w, box.u_min, box.u_max);
  }
  const Range squared = range_over(ray.u_squared, t);
  return squared.high < least_square(box) || squared.low > box.u_max * box.u_max;
}

struct Candidate {
  Root t;
  std::optional<std::uint32_t> piece;  // none where nothing but the ray's sample points may change
};

// False for the zero polynomial, which has no roots of its own.
bool add_roots(std::vector<Candidate>& candidates, const Polynomial& p,
               const std::optional<std::uint32_t>& piece) {
  const IntegerPolynomial integral = number::with_cleared_denominators(p);
  if (integral.degree() > 0) {
    for (const Root& root : number::real_roots(integral)) {
      candidates.push_back({root, piece});
    }
  }
  return !integral.is_zero();
}

// Where a ray that stays on the curve of a piece passes the piece's ends: the piece is straight, or
// the ray has one place in the plane, or that is the apex of a conic sweep, which is found here.
void add_ends(std::vector<Candidate>& candidates, const PlaneRay& ray, const ContourPiece& piece,
              std::uint32_t index) {
  for (const Rational& s : {Rational(0), Rational(1)}) {
    Polynomial v = ray.v;
    add(v, ray.w, -value_at(piece.v, s));
    add_roots(candidates, v, index);
    const Rational u_end = value_at(piece.u, s);
    Polynomial u = ray.u ? *ray.u : shifted(ray.u_squared, -u_end * u_end);
    if (ray.u) {
      add(u, ray.w, -u_end);
    }
    add_roots(candidates, u, index);
  }
}

bool is_near(const Candidate& candidate, const PlaneRay& ray, const Rectangle& box) {
  const double low = candidate.t.lower();
  const double high = candidate.t.upper();
  return !std::isfinite(low) || !std::isfinite(high) ||
         !misses(ray, {Rational(low), Rational(high)}, box);
}

// Is the ray's point at this root in the rectangle? Exact.
bool is_in(const PlaneRay& ray, const Root& t, const Rectangle& box) {
  const auto sign = [&t](const Polynomial& p) {
    return sign_at(number::with_cleared_denominators(p), t);
  };
  const int w = sign(ray.w);
  // The sign of x / w - bound, for x / w as for u and v.
  const auto beyond = [&](Polynomial x, const Rational& bound) {
    add(x, ray.w, -bound);
    return w * sign(x);
  };
  const Polynomial& u = ray.u ? *ray.u : ray.u_squared;
  const Rational u_min = ray.u ? box.u_min : least_square(box);
  const Rational u_max = ray.u ? box.u_max : Rational(box.u_max * box.u_max);
  return beyond(u, u_min) >= 0 && beyond(u, u_max) <= 0 && beyond(ray.v, box.v_min) >= 0 &&
         beyond(ray.v, box.v_max) <= 0;
}

// The piece that a ray crosses at the candidates of one t.
std::uint32_t crossed_piece(const PlaneRay& ray, const Contour& contour,
                            std::span<const Candidate> candidates) {
  const auto on_piece = [&](const Candidate& candidate) {
    return candidate.piece &&
           (candidates.size() == 1 || is_in(ray, candidate.t, contour.boxes()[*candidate.piece]));
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), on_piece);
  LAMINA_REQUIRE(found != candidates.end(), "a ray gets inside through a piece");
  return *found->piece;
}

// A point of the (u, v) plane: v, and u or its square.
struct PlanePlace {
  std::optional<Rational> u;
  Rational u_squared;
  Rational v;
};

// The sign of u(s) - u.
template <typename Parameter>
int side_in_u(const Polynomial& u, const PlanePlace& place, const Parameter& s) {
  Polynomial difference =
      place.u ? shifted(u, -*place.u) : shifted(multiply(u, u), -place.u_squared);
  if constexpr (std::is_same_v<Parameter, Root>) {
    return sign_at(number::with_cleared_denominators(difference), s);
  } else {
    return value_at(difference, s).sign();
  }
}

// The sign of u(s) - u for all of a piece, or zero if its rectangle does not tell.
int side_in_u(const Rectangle& box, const PlanePlace& place) {
  const bool right = place.u ? box.u_min > *place.u : least_square(box) > place.u_squared;
  const bool left = place.u ? box.u_max < *place.u : box.u_max * box.u_max < place.u_squared;
  return right ? 1 : left ? -1 : 0;
}

// For s just below 1: just above 0 of the polynomial of 1 - s.
int sign_before_one(const Polynomial& p) {
  Polynomial turned{p.back()};
  for (auto c = std::next(p.rbegin()); c != p.rend(); ++c) {
    turned = multiply(turned, {1, -1});
    turned.front() += *c;
  }
  return sign_after_zero(turned);
}

// Counts how often a contour passes the half-line from a place to greater u. Goes along the whole
// contour by the sign of v(s) - v in the open intervals between its zeros: what is passed at a
// joint, or by pieces on the line itself, shows in the signs before and after.
class PassingCount {
 public:
  PassingCount(const Contour& contour, const PlanePlace& place) : place_(place) {
    const auto pieces = contour.pieces();
    const bool turned = !place_.u;
    for (std::size_t i = 0; i < pieces.size() && !on_contour_; ++i) {
      if (!turned || !is_on_axis(pieces[i])) {
        go_along(pieces[i], contour.boxes()[i]);
      }
    }
    // An open contour is closed along the axis, which no place is left of.
    if (!on_contour_ && contour.closed() && last_sign_ != first_sign_) {
      count_at(pieces.front().u, Rational(0));
    }
  }

  [[nodiscard]] int side() const { return on_contour_ ? 0 : passings_ % 2 == 1 ? -1 : 1; }

 private:
  void go_along(const ContourPiece& piece, const Rectangle& box) {
    if (box.v_min > place_.v || box.v_max < place_.v) {
      begin_with(box.v_min > place_.v ? 1 : -1, piece);
      return;
    }
    const Polynomial height = shifted(piece.v, -place_.v);
    const IntegerPolynomial g = number::with_cleared_denominators(height);
    if (g.is_zero()) {
      const int from = side_in_u(piece.u, place_, Rational(0));
      const int to = side_in_u(piece.u, place_, Rational(1));
      on_contour_ = from * to <= 0;
      return;
    }
    begin_with(sign_after_zero(height), piece);
    const int all = side_in_u(box, place_);
    if (all != 0) {
      // No matter where on the piece, only whether.
      const int sign = sign_before_one(height);
      passings_ += sign != last_sign_ && all > 0 ? 1 : 0;
      last_sign_ = sign;
      return;
    }
    on_contour_ = height.front().is_zero() && side_in_u(piece.u, place_, Rational(0)) == 0;
    for (const Root& s : g.degree() > 0 ? number::real_roots(g) : std::vector<Root>{}) {
      if (compare(s, Rational(0)) <= 0 || compare(s, Rational(1)) > 0) {
        continue;
      }
      const int side = side_in_u(piece.u, place_, s);
      on_contour_ = on_contour_ || side == 0;
      if (s.multiplicity() % 2 == 1 && compare(s, Rational(1)) < 0) {
        last_sign_ = -last_sign_;
        passings_ += side > 0 ? 1 : 0;
      }
    }
  }

  // The sign just behind the start of a piece.
  void begin_with(int sign, const ContourPiece& piece) {
    if (first_sign_ == 0) {
      first_sign_ = last_sign_ = sign;
    } else if (sign != last_sign_) {
      count_at(piece.u, Rational(0));
      last_sign_ = sign;
    }
  }

  void count_at(const Polynomial& u, const Rational& s) {
    passings_ += side_in_u(u, place_, s) > 0 ? 1 : 0;
  }

  PlanePlace place_;
  int first_sign_ = 0;
  int last_sign_ = 0;
  int passings_ = 0;
  bool on_contour_ = false;
};

// What x and y are divided by to get u and v, in a sweep that is not turned.
struct Scales {
  Rational x;
  Rational y;
};

Scales scales_at(const SweptSurface& surface, const Rational& z) {
  switch (surface.sweep()) {
    case Sweep::Conic:
      return {z, z};
    case Sweep::GeneralisedConic:
      return {value_at(surface.scaling().x, z), value_at(surface.scaling().y, z)};
    case Sweep::Translational:
    case Sweep::Rotational:
      break;
  }
  return {1, 1};
}

// None at heights where x or y is scaled to nothing.
std::optional<PlanePlace> place_of(const SweptSurface& surface, const ExactPoint& local) {
  const auto& [x, y, z] = local;
  if (surface.sweep() == Sweep::Rotational) {
    return PlanePlace{{}, x * x + y * y, z};
  }
  const auto [scale_x, scale_y] = scales_at(surface, z);
  if (scale_x.is_zero() || scale_y.is_zero()) {
    return std::nullopt;
  }
  return PlanePlace{Rational(x / scale_x), {}, y / scale_y};
}

// There: is the point where the surface is drawn together to a point or to a line?
bool is_in_pinch(const SweptSurface& surface, const ExactPoint& local) {
  const auto [scale_x, scale_y] = scales_at(surface, local.z);
  // Is there one of the contour's points with this u, or v?
  const auto reaches = [&](const Polynomial ContourPiece::*coordinate, const Rational& value) {
    const auto pieces = surface.contour().pieces();
    return std::any_of(pieces.begin(), pieces.end(), [&](const ContourPiece& piece) {
      const IntegerPolynomial f =
          number::with_cleared_denominators(shifted(piece.*coordinate, -value));
      const auto roots = f.degree() > 0 ? number::real_roots(f) : std::vector<Root>{};
      return f.is_zero() || std::any_of(roots.begin(), roots.end(), [](const Root& s) {
               return compare(s, Rational(0)) >= 0 && compare(s, Rational(1)) <= 0;
             });
    });
  };
  const bool on_x =
      scale_x.is_zero() ? local.x.is_zero() : reaches(&ContourPiece::u, local.x / scale_x);
  return on_x &&
         (scale_y.is_zero() ? local.y.is_zero() : reaches(&ContourPiece::v, local.y / scale_y));
}

// Of a curve's point from a place, squared, to first order.
Rational squared_distance(const PlanePlace& place, const Rational& u, const Rational& v) {
  const Rational dv = v - place.v;
  if (!place.u && u.is_zero()) {
    return place.u_squared + dv * dv;
  }
  const Rational du = place.u ? u - *place.u : (u * u - place.u_squared) / (2 * u);
  return du * du + dv * dv;
}

// Not above squared_distance of any point of a piece with this rectangle.
Rational least_squared_distance(const PlanePlace& place, const Rectangle& box) {
  const Rational dv =
      std::max({Rational(0), Rational(box.v_min - place.v), Rational(place.v - box.v_max)});
  if (place.u) {
    const Rational du =
        std::max({Rational(0), Rational(box.u_min - *place.u), Rational(*place.u - box.u_max)});
    return du * du + dv * dv;
  }
  // What squared_distance has for du grows with u.
  const Rational u = least_square(box) > place.u_squared       ? box.u_min
                     : box.u_max * box.u_max < place.u_squared ? box.u_max
                                                               : Rational(0);
  return u <= 0 ? Rational(dv * dv) : squared_distance(place, u, place.v) + dv * dv;
}

// Where a contour has the u or the v of a place that is all but on it, whichever is nearer.
SweptSurface::Foot foot_of(const SweptSurface& surface, const PlanePlace& place) {
  constexpr int kBits = 320;  // more than any number type here has
  const auto pieces = surface.contour().pieces();
  std::vector<std::pair<Rational, std::uint32_t>> nearest_first;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (surface.sweeps(i)) {
      nearest_first.emplace_back(least_squared_distance(place, surface.contour().boxes()[i]), i);
    }
  }
  std::sort(nearest_first.begin(), nearest_first.end());
  SweptSurface::Foot best;
  std::optional<Rational> least;
  for (const auto& [not_below, i] : nearest_first) {
    if (least && not_below > *least) {
      break;
    }
    const ContourPiece& piece = pieces[i];
    const auto consider = [&, index = i](const Rational& s) {
      const Rational distance = squared_distance(place, value_at(piece.u, s), value_at(piece.v, s));
      if (!least || distance < *least) {
        least = distance;
        best = {index, s};
      }
    };
    consider(0);
    const auto next = static_cast<std::uint32_t>((i + 1) % pieces.size());
    if ((next == 0 && !surface.contour().closed()) || !surface.sweeps(next)) {
      consider(1);  // at the axis
    }
    const Polynomial in_u = place.u ? shifted(piece.u, -*place.u)
                                    : shifted(multiply(piece.u, piece.u), -place.u_squared);
    for (const Polynomial& p : {in_u, shifted(piece.v, -place.v)}) {
      const IntegerPolynomial f = number::with_cleared_denominators(p);
      for (const Root& root : f.degree() > 0 ? number::real_roots(f) : std::vector<Root>{}) {
        if (compare(root, Rational(0)) > 0 && compare(root, Rational(1)) < 0) {
          consider(enclosure(root, kBits).lower);
        }
      }
    }
  }
  return best;
}

}  // namespace

std::string_view name_of(Sweep sweep) {
  switch (sweep) {
    case Sweep::Translational:
      return "translational_sweep";
    case Sweep::Conic:
      return "conic_sweep";
    case Sweep::GeneralisedConic:
      return "generalised_conic_sweep";
    case Sweep::Rotational:
      break;
  }
  return "rotational_sweep";
}

std::strong_ordering operator<=>(const SweptSurface& a, const SweptSurface& b) {
  const auto key = [](const SweptSurface& x) {
    return std::tuple(x.sweep(), x.scaling().x.size(), x.scaling().y.size(), x.contour().kind(),
                      x.contour().closed(), x.contour().points().size());
  };
  if (const auto order = key(a) <=> key(b); order != 0) {
    return order;
  }
  if (a.scaling() != b.scaling()) {
    return std::tie(a.scaling().x, a.scaling().y) < std::tie(b.scaling().x, b.scaling().y)
               ? std::strong_ordering::less
               : std::strong_ordering::greater;
  }
  for (std::size_t i = 0; i < a.contour().points().size(); ++i) {
    const geometry::PlanePoint& p = a.contour().points()[i];
    const geometry::PlanePoint& q = b.contour().points()[i];
    if (p != q) {
      return std::tie(p.u, p.v) < std::tie(q.u, q.v) ? std::strong_ordering::less
                                                     : std::strong_ordering::greater;
    }
  }
  return std::strong_ordering::equal;
}

SweptSurface::SweptSurface(Sweep sweep, std::shared_ptr<const Contour> contour)
    : sweep_(sweep), contour_(std::move(contour)) {
  if (sweep_ == Sweep::Rotational) {
    contour_->require_right_of_axis();
  } else if (!contour_->closed()) {
    throw base::InputError("an open contour can only be turned about its axis: close it");
  }
  if (contour_->orientation() == 0) {
    throw base::InputError("the contour encloses nothing: move a point off the axis");
  }
  std::vector<ContourCurve> curves;
  for (std::uint32_t i = 0; i < contour_->pieces().size(); ++i) {
    curves.push_back(sweeps(i) ? curve_of(sweep_, contour_->pieces()[i]) : ContourCurve{});
  }
  curves_ = std::make_shared<const std::vector<ContourCurve>>(std::move(curves));
}

SweptSurface::SweptSurface(Scaling scaling, std::shared_ptr<const Contour> contour)
    : SweptSurface(Sweep::GeneralisedConic, std::move(contour)) {
  constexpr std::size_t kMostDegree = 5;  // of w: 15 of the polynomial in t
  for (Polynomial* p : {&scaling.x, &scaling.y}) {
    while (!p->empty() && p->back().is_zero()) {
      p->pop_back();
    }
    if (p->empty()) {
      throw base::InputError("x and y cannot be scaled by zero: state a coefficient other than 0");
    }
  }
  const auto& [p, q] = scaling;
  const std::size_t degree = p == q ? p.size() - 1 : p.size() + q.size() - 2;
  if (degree > kMostDegree || (p != q && std::max(p.size(), q.size()) > kMostDegree)) {
    throw base::InputError(
        "the polynomials that scale x and y must be of degree 5 at most, both together unless they "
        "are equal, with 4 at most for one");
  }
  if (p == q && (p == Polynomial{1} || p == Polynomial{0, 1})) {
    sweep_ = p.size() == 1 ? Sweep::Translational : Sweep::Conic;
    return;
  }
  scaling_ = std::move(scaling);
}

const ContourCurve& SweptSurface::curve(std::uint32_t piece) const { return (*curves_)[piece]; }

bool SweptSurface::sweeps(std::uint32_t piece) const {
  return sweep_ != Sweep::Rotational || !is_on_axis(contour_->pieces()[piece]);
}

int SweptSurface::side(const ExactPoint& local) const {
  if (const auto place = place_of(*this, local)) {
    return PassingCount(*contour_, *place).side();
  }
  return is_in_pinch(*this, local) ? 0 : 1;
}

ExactPoint SweptSurface::normal_at(const ExactPoint& local, const Foot& foot) const {
  const auto& [x, y, z] = local;
  const Rational& s = foot.s;
  const ContourPiece& piece = contour_->pieces()[foot.piece];
  const int side = contour_->orientation();
  const Rational n_u = side * value_at(derivative(piece.v), s);
  const Rational n_v = -side * value_at(derivative(piece.u), s);
  const Rational u = value_at(piece.u, s);
  const Rational v = value_at(piece.v, s);
  switch (sweep_) {
    case Sweep::Translational:
      return {n_u, n_v, 0};
    case Sweep::Conic:
      return Rational(z.sign()) * ExactPoint{n_u, n_v, -(n_u * u + n_v * v)};
    case Sweep::GeneralisedConic: {
      // The gradient of what is zero at (x / p, y / q), times the absolute value of p q.
      const auto [p, q] = scales_at(*this, z);
      const Rational slope_p = value_at(derivative(scaling_.x), z);
      const Rational slope_q = value_at(derivative(scaling_.y), z);
      return Rational(p.sign() * q.sign()) *
             ExactPoint{n_u * q, n_v * p, -(n_u * u * slope_p * q + n_v * v * slope_q * p)};
    }
    case Sweep::Rotational:
      break;
  }
  return u.is_zero() ? ExactPoint{0, 0, n_v} : ExactPoint{n_u * x, n_u * y, n_v * u};
}

SweptSurface::Foot SweptSurface::foot_near(const ExactPoint& local) const {
  const auto place = place_of(*this, local);
  LAMINA_REQUIRE(place.has_value(), "where the scaling is zero, no one point is below");
  return foot_of(*this, *place);
}

ExactPoint SweptSurface::normal_near(const ExactPoint& local) const {
  return place_of(*this, local) ? normal_at(local, foot_near(local)) : ExactPoint{0, 0, 0};
}

std::optional<SweptSurface::Facets> SweptSurface::facets(const ExactPoint& local) const {
  const bool flat = contour_->kind() == geometry::ContourKind::Line &&
                    (sweep_ == Sweep::Translational || sweep_ == Sweep::Conic);
  const auto at = flat ? place_of(*this, local) : std::nullopt;
  if (!at) {
    return std::nullopt;
  }
  const PlanePlace& place = *at;
  const auto pieces = contour_->pieces();
  Facets facets;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const ContourPiece& piece = pieces[i];
    const Rational u = *place.u - piece.u[0];
    const Rational v = place.v - piece.v[0];
    const Rational along = u * piece.u[1] + v * piece.v[1];
    const Rational whole = piece.u[1] * piece.u[1] + piece.v[1] * piece.v[1];
    if (u * piece.v[1] != v * piece.u[1] || along < 0 || along > whole) {
      continue;
    }
    facets.normals.push_back(normal_at(local, {i, along / whole}));
    if (along.is_zero()) {
      const ContourPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
      const Rational turn = before.u[1] * piece.v[1] - before.v[1] * piece.u[1];
      facets.convex = turn.sign() * contour_->orientation() >= 0;
    }
  }
  return facets.normals.empty() ? std::nullopt : std::optional(std::move(facets));
}

SweptSurface::Crossings SweptSurface::crossings(const ExactRay& local) const {
  const PlaneRay ray = plane_ray(*this, local);
  PlaneMonomials<Rational> monomials(ray);
  std::vector<Candidate> candidates;
  if (sweep_ == Sweep::Conic || sweep_ == Sweep::GeneralisedConic) {
    add_roots(candidates, ray.w, std::nullopt);
  }
  const auto pieces = contour_->pieces();
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Rectangle& box = contour_->boxes()[i];
    if (!sweeps(i) || (ray.u ? line_misses(ray, box) : ring_is_missed(ray, box))) {
      continue;
    }
    std::vector<Candidate> of_piece;
    if (!add_roots(of_piece, monomials.restrict(curve(i)), i)) {
      add_ends(of_piece, ray, pieces[i], i);
    }
    std::copy_if(of_piece.begin(), of_piece.end(), std::back_inserter(candidates),
                 [&](const Candidate& c) { return is_near(c, ray, box); });
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    const auto order = compare(a.t, b.t);
    return order < 0 || (order == 0 && a.piece < b.piece);
  });

  const auto side_at = [&](const Rational& t) { return side(local.origin + t * local.direction); };
  Crossings result;
  const LineStart start =
      walk(std::span<const Candidate>(candidates), side_at, [&](std::span<const Candidate> equal) {
        result.crossings.push_back({equal.front().t, crossed_piece(ray, *contour_, equal)});
      });
  if (start.in_boundary) {
    return {false, true, {}};
  }
  result.starts_inside = start.inside;
  return result;
}

}  // namespace lamina::surface
