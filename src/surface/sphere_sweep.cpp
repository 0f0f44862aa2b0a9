#include "surface/sphere_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/contract.hpp"
#include "surface/exact_line.hpp"

namespace lamina::surface {
namespace {

using geometry::Box;
using geometry::ExactPoint;
using geometry::ExactRay;
using geometry::point_at;
using geometry::TrajectoryPiece;
using geometry::value_at;
using number::Integer;
using number::IntegerPolynomial;
using number::Rational;
using number::Root;
using Polynomial = RationalPolynomial;

// Their sum over the coordinates.
Polynomial dot(const TrajectoryPiece& a, const TrajectoryPiece& b) {
  Polynomial sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    add(sum, multiply(a[i], b[i]));
  }
  return sum;
}

// c(u) - p.
TrajectoryPiece from(const ExactPoint& p, TrajectoryPiece piece) {
  piece[0].front() -= p.x;
  piece[1].front() -= p.y;
  piece[2].front() -= p.z;
  return piece;
}

// |p - c(u)|^2 - r^2, which has as leading coefficient the square of c's.
Polynomial beyond_ball(const ExactPoint& p, const TrajectoryPiece& piece, const Rational& radius) {
  const TrajectoryPiece arm = from(p, piece);
  Polynomial result = dot(arm, arm);
  result.front() -= radius * radius;
  return result;
}

std::vector<Root> roots_in_unit(const Polynomial& p) {
  const IntegerPolynomial integral = number::with_cleared_denominators(p);
  std::vector<Root> roots =
      integral.degree() > 0 ? number::real_roots(integral) : std::vector<Root>{};
  std::erase_if(roots, [](const Root& root) {
    return compare(root, Rational(0)) <= 0 || compare(root, Rational(1)) >= 0;
  });
  return roots;
}

// Coefficients over Bernstein's basis, times a positive number.
std::vector<Integer> bernstein(const Polynomial& p) {
  const Polynomial b = geometry::bezier(p);
  Integer common = 1;
  for (const Rational& c : b) {
    common = lcm(common, Integer(denominator(c)));
  }
  std::vector<Integer> integers;
  for (const Rational& c : b) {
    integers.push_back(numerator(c) * (common / denominator(c)));
  }
  return integers;
}

// The sign of the least value on [0, 1], if some halvings tell.
std::optional<int> least_sign_by_halving(std::vector<Integer> b, int halvings) {
  if (b.front().sign() < 0 || b.back().sign() < 0) {
    return -1;
  }
  if (std::all_of(b.begin(), b.end(), [](const Integer& c) { return c.sign() > 0; })) {
    return 1;
  }
  if (halvings == 0) {
    return std::nullopt;
  }
  // De Casteljau, each level twice as large as it should be.
  const std::size_t degree = b.size() - 1;
  std::vector<Integer> low(b.size());
  std::vector<Integer> high(b.size());
  for (std::size_t level = 0; level <= degree; ++level) {
    const std::size_t last = degree - level;
    low[level] = b.front() << static_cast<unsigned>(last);
    high[last] = b[last] << static_cast<unsigned>(last);
    for (std::size_t i = 0; i < last; ++i) {
      b[i] += b[i + 1];
    }
  }
  const auto of_low = least_sign_by_halving(std::move(low), halvings - 1);
  if (of_low == -1) {
    return of_low;
  }
  const auto of_high = least_sign_by_halving(std::move(high), halvings - 1);
  return of_high == -1 || of_low ? of_high : std::nullopt;
}

// Of a polynomial that is not zero: the sign of its least value on [0, 1]; exact.
int least_sign(const Polynomial& p) {
  constexpr int kHalvings = 6;  // then isolating the roots takes less time
  if (const auto sign = least_sign_by_halving(bernstein(p), kHalvings)) {
    return *sign;
  }
  // Not negative at the ends.
  const std::vector<Root> roots = roots_in_unit(p);
  const bool changes = std::any_of(roots.begin(), roots.end(),
                                   [](const Root& root) { return root.multiplicity() % 2 == 1; });
  if (changes || sign_after_zero(p) < 0) {
    return -1;
  }
  return roots.empty() && !p.front().is_zero() && !value_at(p, 1).is_zero() ? 1 : 0;
}

// By Bareiss: all divisions are exact.
Integer determinant(std::vector<std::vector<Integer>> m) {
  const std::size_t n = m.size();
  Integer pivot = 1;
  bool negative = false;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const auto row = std::find_if(m.begin() + static_cast<std::ptrdiff_t>(k), m.end(),
                                  [k](const auto& r) { return !r[k].is_zero(); });
    if (row == m.end()) {
      return 0;
    }
    const auto top = m.begin() + static_cast<std::ptrdiff_t>(k);
    negative = negative != (row != top);
    std::swap(*row, *top);
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j) {
        m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / pivot;
      }
    }
    pivot = m[k][k];
  }
  return negative ? Integer(-m[n - 1][n - 1]) : m[n - 1][n - 1];
}

// Through values at 0, 1, 2 ...: Newton's form by forward differences.
Polynomial interpolated(std::vector<Integer> values) {
  Polynomial newton;
  Integer factorial = 1;
  for (std::size_t k = 0; k < values.size(); ++k) {
    newton.emplace_back(values[0], factorial);
    factorial *= k + 1;
    for (std::size_t i = 0; i + k + 1 < values.size(); ++i) {
      values[i] = values[i + 1] - values[i];
    }
  }
  Polynomial result;
  for (std::size_t k = newton.size(); k-- > 0;) {
    result = multiply(result, {-Rational(k), 1});
    add(result, {newton[k]});
  }
  return result;
}

// A polynomial in u, ascending, whose coefficients are polynomials in t; the leading one, of a
// degree above 0, is a constant that is not zero.
using InU = std::vector<Polynomial>;

// Zero where two roots u of f are one, times a constant that is not zero: the resultant of df/du
// and n f - u df/du, where n is f's degree, by Bezout's matrix. Its degree in t is at most
// `degree`; so many points and one more give it.
Polynomial discriminant(const InU& f, std::size_t degree) {
  Integer common = 1;
  for (const Polynomial& in_t : f) {
    for (const Rational& c : in_t) {
      common = lcm(common, Integer(denominator(c)));
    }
  }
  const std::size_t n = f.size() - 1;
  std::vector<Integer> values;
  for (std::size_t t = 0; t <= degree; ++t) {
    std::vector<Integer> at_t;
    for (const Polynomial& in_t : f) {
      at_t.push_back(numerator(Rational(common * value_at(in_t, Rational(t)))));
    }
    std::vector<Integer> slope(n);
    std::vector<Integer> rest(n);
    for (std::size_t k = 0; k < n; ++k) {
      slope[k] = Integer(k + 1) * at_t[k + 1];
      rest[k] = Integer(n - k) * at_t[k];
    }
    const std::size_t size = n - 1;
    std::vector<std::vector<Integer>> bezout(size, std::vector<Integer>(size));
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t k = 0; k <= std::min(i, size - 1 - j); ++k) {
          bezout[i][j] += rest[j + k + 1] * slope[i - k] - rest[i - k] * slope[j + k + 1];
        }
      }
    }
    values.push_back(determinant(std::move(bezout)));
  }
  return interpolated(std::move(values));
}

// A ray at one piece: f = a t^2 - 2 p(u) t + q(u), which is not positive where the ball is met.
struct PieceOnRay {
  Rational a;    // |d|^2
  Polynomial p;  // (c(u) - o).d
  Polynomial q;  // |c(u) - o|^2 - r^2

  PieceOnRay(const ExactRay& ray, const TrajectoryPiece& piece, const Rational& radius)
      : a(geometry::dot(ray.direction, ray.direction)), q(beyond_ball(ray.origin, piece, radius)) {
    const TrajectoryPiece arm = from(ray.origin, piece);
    add(p, arm[0], ray.direction.x);
    add(p, arm[1], ray.direction.y);
    add(p, arm[2], ray.direction.z);
  }

  // a q - p^2: above 0 where the ball at u is off the ray, below 0 where it is crossed.
  [[nodiscard]] Polynomial off_ray() const {
    Polynomial result;
    add(result, q, a);
    add(result, multiply(p, p), -1);
    return result;
  }

  [[nodiscard]] Polynomial at(const Rational& u) const {
    return {value_at(q, u), -2 * value_at(p, u), a};
  }

  // By the weights of its terms, of degree 4 k - 2 where c is of degree k.
  [[nodiscard]] Polynomial discriminant_in_u() const {
    InU f;
    for (const Rational& c : q) {
      f.push_back({c});
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
      f[i].push_back(-2 * p[i]);
    }
    f.front().push_back(a);
    return discriminant(f, 2 * f.size() - 4);
  }

  // For a piece along the ray, at the distance r: the t of the balls at which it turns back.
  [[nodiscard]] Polynomial turns() const {
    InU f;
    for (const Rational& c : p) {
      f.push_back({c});
    }
    f.front().push_back(-a);
    return f.size() > 2 ? discriminant(f, f.size() - 2) : Polynomial{1};
  }
};

struct Candidate {
  Root t;
};

// The t for which the ray is in the box made larger by the radius; none if it misses that.
std::optional<number::Enclosure> clip(const ExactRay& ray, const Box& box, const Rational& radius) {
  std::optional<number::Enclosure> within;
  const auto clip_along = [&](const Rational& o, const Rational& d, const Rational& lower,
                              const Rational& upper) {
    if (d.is_zero()) {
      return lower - radius <= o && o <= upper + radius;
    }
    Rational low = (lower - radius - o) / d;
    Rational high = (upper + radius - o) / d;
    if (high < low) {
      low.swap(high);
    }
    within = within ? number::Enclosure{std::max(low, within->lower), std::min(high, within->upper)}
                    : number::Enclosure{low, high};
    return within->lower <= within->upper;
  };
  const auto& [o, d] = ray;
  const bool meets = clip_along(o.x, d.x, box.lower.x, box.upper.x) &&
                     clip_along(o.y, d.y, box.lower.y, box.upper.y) &&
                     clip_along(o.z, d.z, box.lower.z, box.upper.z);
  return meets ? within : std::nullopt;
}

// Adds the roots, but those that are beyond these t for certain.
void add_roots(std::vector<Candidate>& candidates, const Polynomial& p,
               const number::Enclosure& within) {
  const IntegerPolynomial integral = number::with_cleared_denominators(p);
  LAMINA_REQUIRE(!integral.is_zero(), "what may cross a ray is the root of a polynomial");
  for (const Root& root : number::real_roots(integral)) {
    const number::Enclosure bounds = bounds_of(root);
    if (bounds.upper >= within.lower && bounds.lower <= within.upper) {
      candidates.push_back({root});
    }
  }
}

// Squared.
Rational distance_from(const Box& box, const ExactPoint& p) {
  const auto gap = [](const Rational& x, const Rational& lower, const Rational& upper) {
    return std::max({Rational(0), Rational(lower - x), Rational(x - upper)});
  };
  const ExactPoint to{gap(p.x, box.lower.x, box.upper.x), gap(p.y, box.lower.y, box.upper.y),
                      gap(p.z, box.lower.z, box.upper.z)};
  return geometry::dot(to, to);
}

}  // namespace

std::strong_ordering operator<=>(const SphereSweep& a, const SphereSweep& b) {
  if (const int order = a.radius().compare(b.radius()); order != 0) {
    return order <=> 0;
  }
  return a.trajectory() <=> b.trajectory();
}

SphereSweep::SphereSweep(const Rational& radius,
                         std::shared_ptr<const geometry::Trajectory> trajectory)
    : radius_(radius), trajectory_(std::move(trajectory)) {
  if (radius <= 0) {
    throw base::InputError("the radius of the ball must be positive");
  }
}

int SphereSweep::side(const ExactPoint& local) const {
  const auto pieces = trajectory_->pieces();
  int side = 1;
  for (std::size_t i = 0; i < pieces.size() && side >= 0; ++i) {
    if (distance_from(trajectory_->boxes()[i], local) <= radius_ * radius_) {
      side = std::min(side, least_sign(beyond_ball(local, pieces[i], radius_)));
    }
  }
  return side;
}

SphereSweep::Crossings SphereSweep::crossings(const ExactRay& local) const {
  const auto pieces = trajectory_->pieces();
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto within = clip(local, trajectory_->boxes()[i], radius_);
    if (!within) {
      continue;
    }
    const PieceOnRay piece(local, pieces[i], radius_);
    const Polynomial off_ray = piece.off_ray();
    const bool along =
        std::all_of(off_ray.begin(), off_ray.end(), [](const Rational& c) { return c.is_zero(); });
    if (!along && least_sign(off_ray) > 0) {
      continue;
    }
    add_roots(candidates, along ? piece.turns() : piece.discriminant_in_u(), *within);
    // Where two pieces go on in one direction, the ball there is in the way of neither.
    const bool has_corners = along || trajectory_->kind() == geometry::ContourKind::Line;
    if (has_corners || (i == 0 && !trajectory_->closed())) {
      add_roots(candidates, piece.at(0), *within);
    }
    if (has_corners || (i + 1 == pieces.size() && !trajectory_->closed())) {
      add_roots(candidates, piece.at(1), *within);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return compare(a.t, b.t) < 0; });

  Crossings result;
  const LineStart start = walk(
      std::span<const Candidate>(candidates),
      [&](const Rational& t) { return side(local.origin + t * local.direction); },
      [&](std::span<const Candidate> equal) { result.t.push_back(equal.front().t); });
  if (start.in_boundary) {
    return {true, {}};
  }
  return result;
}

bool SphereSweep::has_one_foot(const ExactPoint& local) const {
  const auto pieces = trajectory_->pieces();
  std::size_t feet = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Polynomial beyond = beyond_ball(local, pieces[i], radius_);
    feet += roots_in_unit(beyond).size() + (beyond.front().is_zero() ? 1 : 0);
    if (i + 1 == pieces.size() && !trajectory_->closed()) {
      feet += value_at(beyond, 1).is_zero() ? 1 : 0;
    }
  }
  return feet == 1;
}

SphereSweep::Foot SphereSweep::foot_near(const ExactPoint& local) const {
  constexpr int kBits = 320;  // more than any number type here has
  const auto pieces = trajectory_->pieces();
  std::vector<std::pair<Rational, std::uint32_t>> nearest_first;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    nearest_first.emplace_back(distance_from(trajectory_->boxes()[i], local), i);
  }
  std::sort(nearest_first.begin(), nearest_first.end());
  Foot best;
  std::optional<Rational> least;
  for (const auto& [not_below, i] : nearest_first) {
    if (least && not_below > *least) {
      break;
    }
    const Polynomial squared = beyond_ball(local, pieces[i], 0);
    const auto consider = [&, index = i](const Rational& u) {
      const Rational distance = value_at(squared, u);
      if (!least || distance < *least) {
        least = distance;
        best = {index, u};
      }
    };
    consider(0);
    consider(1);
    for (const Root& root : roots_in_unit(derivative(squared))) {
      consider(enclosure(root, kBits).lower);
    }
  }
  return best;
}

ExactPoint SphereSweep::normal_near(const ExactPoint& local) const {
  const Foot foot = foot_near(local);
  return local - point_at(trajectory_->pieces()[foot.piece], foot.u);
}

}  // namespace lamina::surface
