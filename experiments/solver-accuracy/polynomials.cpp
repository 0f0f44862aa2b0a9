#include "experiments/solver-accuracy/polynomials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/near-tangent/grazing.hpp"
#include "experiments/random_sweep.hpp"
#include "geometry/rounding.hpp"
#include "number/all_numbers.hpp"
#include "scene/families.hpp"
#include "scene/rays.hpp"
#include "surface/carrier.hpp"
#include "surface/certified_surface.hpp"
#include "surface/ray_sphere.hpp"
#include "surface/rounded_surface.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina::experiments {
namespace {

using base::SeededStream;
using number::Integer;
using number::Rational;

using Coefficients = std::vector<Rational>;

template <number::RoundedNumber Number>
std::optional<HeldPolynomial> rounded(const Coefficients& ideal) {
  using Traits = number::number_traits<Number>;
  HeldPolynomial held;
  for (const Rational& c : ideal) {
    const Number x = Traits::from_exact(c);
    if (!(x - x == 0)) {
      return std::nullopt;
    }
    held.ascending.push_back(Traits::to_exact(x));
  }
  return held;
}

// What has a degree and coefficients `c`, ascending.
template <number::RoundedNumber Number, typename Polynomial>
std::optional<HeldPolynomial> as_held(const Polynomial& p) {
  HeldPolynomial held;
  for (int i = 0; i <= p.degree; ++i) {
    if (!(p.c[i] - p.c[i] == 0)) {
      return std::nullopt;
    }
    held.ascending.push_back(number::number_traits<Number>::to_exact(p.c[i]));
  }
  return held;
}

template <number::RoundedNumber Number>
std::optional<HeldPolynomial> along_ray(const surface::LocalSurface& surface,
                                        const geometry::ExactRay& ray, bool recentred) {
  const surface::RayPolynomial<Number> p = surface::RoundedSurface<Number>(surface).polynomial(
      geometry::rounded<Number>(ray), recentred);
  auto held = as_held<Number>(p);
  if (held) {
    held->shift = number::number_traits<Number>::to_exact(p.shift);
  }
  return held;
}

template <number::RoundedNumber Number>
std::optional<HeldPolynomial> on_piece(const surface::SweptSurface& sweep, std::uint32_t piece,
                                       const geometry::ExactRay& ray) {
  return as_held<Number>(
      surface::RoundedSweep<Number>(sweep).polynomial(geometry::rounded<Number>(ray), piece));
}

// Of the unit sphere.
template <number::RoundedNumber Number>
poly::Solution on_sphere(const geometry::ExactRay& ray, surface::SphereFormula formula) {
  using Traits = number::number_traits<Number>;
  const poly::RealRoots<Number> found =
      surface::ray_sphere<Number>(geometry::rounded<Number>(ray), Number(1), formula);
  poly::Solution solution;
  for (int i = 0; i < found.count; ++i) {
    solution.roots.push_back({Traits::to_exact(found.t[i]), found.multiplicity[i]});
  }
  return solution;
}

poly::Solution certified(const surface::LocalSurface& surface, const geometry::ExactRay& ray,
                         double most) {
  const poly::CertifiedRoots found =
      surface::CertifiedSurface(surface, geometry::AffineMap())
          .crossings({nearest_double(ray.origin), nearest_double(ray.direction)}, {0, most});
  poly::Solution solution;
  solution.outcome = found.outcome;
  for (int i = 0; i < found.count; ++i) {
    const auto& [low, high] = found.t[i];
    solution.roots.push_back({Rational(low + (high - low) / 2), 1});
  }
  return solution;
}

// What each number type makes of polynomials that are given, and of rays.
struct Holder {
  std::optional<HeldPolynomial> (*rounded)(const Coefficients&);
  std::optional<HeldPolynomial> (*along_ray)(const surface::LocalSurface&,
                                             const geometry::ExactRay&, bool);
  std::optional<HeldPolynomial> (*on_piece)(const surface::SweptSurface&, std::uint32_t,
                                            const geometry::ExactRay&);
  poly::Solution (*on_sphere)(const geometry::ExactRay&, surface::SphereFormula);
};

const Holder& holder(const std::string& number) {
#define LAMINA_HOLDER(Number)             \
  {number::number_traits<Number>::name(), \
   {rounded<Number>, along_ray<Number>, on_piece<Number>, on_sphere<Number>}},
  static const std::map<std::string, Holder> all{LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_HOLDER)};
#undef LAMINA_HOLDER
  return all.at(number);
}

Problem given(Coefficients ideal, poly::ExactRange range = {Rational(0), Rational(1)}) {
  return {ideal,
          std::move(range),
          [ideal](const std::string& number) { return holder(number).rounded(ideal); },
          {}};
}

Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

Coefficients with_roots(const Coefficients& roots) {
  Coefficients product{1};
  for (const Rational& root : roots) {
    product = times(product, {-root, 1});
  }
  return product;
}

// Roots in [0, 1], one in each of n equal parts and not near its ends.
Coefficients separated_roots(int n, SeededStream& stream) {
  Coefficients roots;
  for (int i = 0; i < n; ++i) {
    roots.emplace_back((i + stream.uniform(0.2, 0.8)) / n);
  }
  return roots;
}

Coefficients clustered_roots(int n, int members, double distance, SeededStream& stream) {
  Coefficients roots = separated_roots(n - members + 1, stream);
  const auto first = roots[stream.below(roots.size())];
  for (int i = 1; i < members; ++i) {
    roots.push_back(first + Rational(distance * stream.uniform(i, i + 0.5)));
  }
  return roots;
}

// Different multiples of 1/32, so that few bits hold the coefficients.
Coefficients short_roots(int n, SeededStream& stream) {
  constexpr int kParts = 32;
  std::vector<int> places(kParts - 1);
  for (int i = 1; i < kParts; ++i) {
    places[i - 1] = i;
  }
  Coefficients roots;
  for (int i = 0; i < n; ++i) {
    std::swap(places[i], places[i + stream.below(places.size() - i)]);
    roots.emplace_back(places[i], kParts);
  }
  return roots;
}

Coefficients rootless(int n, SeededStream& stream) {
  Coefficients product{1};
  for (int i = 0; i < n; i += 2) {
    const Rational middle(stream.unit());
    const Rational height(stream.uniform(0.1, 1));
    product = times(product, {middle * middle + height * height, -2 * middle, 1});
  }
  return product;
}

Coefficients scaled(Coefficients c, int exponent) {
  const Rational factor = number::parse_rational(fmt::format("1e{}", exponent));
  for (Rational& x : c) {
    x *= factor;
  }
  return c;
}

constexpr const char* kHaines = "haines";
constexpr const char* kPbrt = "pbrt";
constexpr const char* kCertifiedFromScene = "certified-from-scene";

// Up to twice the distance of what the ray is aimed at: directions have length one.
Problem ray_problem(const surface::LocalSurface& surface, const geometry::ExactRay& ray,
                    double distance, bool recentred) {
  const number::IntegerPolynomial p = surface::RayMonomials(ray).restrict(
      surface::carrier_of(surface, geometry::AffineMap()).carrier);
  return {Coefficients(p.coefficients().begin(), p.coefficients().end()),
          {Rational(0), Rational(2 * distance)},
          [surface, ray, recentred](const std::string& number) {
            return holder(number).along_ray(surface, ray, recentred);
          },
          [surface, ray, distance](const std::string& solver,
                                   const std::string& number) -> std::optional<poly::Solution> {
            if (solver == kCertifiedFromScene) {
              return number == "double" ? std::optional(certified(surface, ray, 2 * distance))
                                        : std::nullopt;
            }
            return holder(number).on_sphere(ray, solver == kHaines ? surface::SphereFormula::Haines
                                                                   : surface::SphereFormula::Pbrt);
          }};
}

// At a random point of the ball that bounds the solid, from `distance` away.
geometry::ExactRay ray_at(double bounding_radius, double distance, SeededStream& stream) {
  const auto target = bounding_radius * std::cbrt(stream.unit()) * scene::random_direction(stream);
  return scene::ray_from(target + distance * scene::random_direction(stream), target,
                         scene::Held::Float);
}

void add_ray_families(std::vector<PolynomialFamily>& all) {
  const surface::LocalSurface ball = surface::sphere(1);
  const surface::LocalSurface ring = surface::torus(1, Rational(1, 4));
  for (const bool is_ring : {false, true}) {
    const surface::LocalSurface surface = is_ring ? ring : ball;
    const std::string name = is_ring ? "torus" : "sphere";
    const int degree = is_ring ? 4 : 2;
    const std::vector<std::string> from_scene =
        is_ring ? std::vector<std::string>{kCertifiedFromScene}
                : std::vector<std::string>{kHaines, kPbrt, kCertifiedFromScene};
    for (const bool recentred : {false, true}) {
      const std::string form = recentred ? " recentred" : "";
      // They are the same for both forms.
      const auto& scene_solvers = recentred ? std::vector<std::string>() : from_scene;
      for (const double distance : {3.0, 1e3, 1e6}) {
        all.push_back({name + form, fmt::format("from {:g}", distance), degree, scene_solvers,
                       [surface, is_ring, distance, recentred](SeededStream& stream) {
                         const double radius = is_ring ? 1.25 : 1;
                         return ray_problem(surface, ray_at(radius, distance, stream), distance,
                                            recentred);
                       }});
      }
      for (const int k : {6, 10, 14}) {
        constexpr double kDistance = 3;
        const Aim aim = grazing_aim(is_ring ? "ring" : "ball", k, kDistance);
        all.push_back({name + form, fmt::format("grazing 1e-{}", k), degree, scene_solvers,
                       [surface, aim, recentred](SeededStream& stream) {
                         const scene::FamilyMember in_place{
                             {}, {}, [](const geometry::Vector3<double>& p) { return p; }};
                         return ray_problem(surface, aim.draw(in_place, {}, stream), kDistance,
                                            recentred);
                       }});
      }
    }
  }
}

// Where a ray meets a spline's piece, in the contour's parameter, not divided by anything: with
// t = (v - o_z) / d_z, (o_x + t d_x)^2 + (o_y + t d_y)^2 = u^2 of a turned one.
Coefficients across(const surface::SweptSurface& sweep, std::uint32_t piece,
                    const geometry::ExactRay& ray) {
  const auto& [o, d] = ray;
  const auto& [u, v] = sweep.contour().pieces()[piece];
  const auto combined = [](const Rational& a, const Coefficients& x, const Rational& b,
                           const Coefficients& y) {
    Coefficients sum(std::max(x.size(), y.size()));
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = (i < x.size() ? a * x[i] : Rational(0)) + (i < y.size() ? b * y[i] : Rational(0));
    }
    return sum;
  };
  if (sweep.sweep() == surface::Sweep::Translational) {
    return combined(1, combined(d.y, u, -d.x, v), d.x * o.y - d.y * o.x, {1});
  }
  const Coefficients x = combined(d.x, v, o.x * d.z - o.z * d.x, {1});
  const Coefficients y = combined(d.y, v, o.y * d.z - o.z * d.y, {1});
  return combined(1, combined(1, times(x, x), 1, times(y, y)), -d.z * d.z, times(u, u));
}

// At one of the pieces whose rectangles the ray meets; rays that meet none are drawn anew.
Problem sweep_problem(surface::Sweep kind, const RayFamily& rays, SeededStream& stream) {
  for (;;) {
    const surface::SweptSurface sweep = any_sweep(
        stream, kind,
        stream.chance(0.5) ? geometry::ContourKind::BSpline : geometry::ContourKind::CatmullRom);
    const geometry::ExactRay ray = any_ray(stream, sweep, rays);
    const surface::RoundedSweep<double> rounded(sweep);
    std::vector<std::uint32_t> met;
    for (std::uint32_t i = 0; i < sweep.contour().pieces().size(); ++i) {
      if (sweep.sweeps(i) && !rounded.rules_out(geometry::rounded<double>(ray), i)) {
        met.push_back(i);
      }
    }
    if (met.empty()) {
      continue;
    }
    const std::uint32_t piece = met[stream.below(met.size())];
    return {across(sweep, piece, ray),
            {Rational(0), Rational(1)},
            [sweep, piece, ray](const std::string& number) {
              return holder(number).on_piece(sweep, piece, ray);
            },
            {}};
  }
}

void add_sweep_families(std::vector<PolynomialFamily>& all) {
  constexpr int kBitsOfDouble = 53;
  for (const surface::Sweep sweep : {surface::Sweep::Translational, surface::Sweep::Rotational}) {
    const auto add = [&](const std::string& parameter, const RayFamily& rays) {
      all.push_back(
          {short_name(sweep) + " sweep",
           parameter,
           sweep == surface::Sweep::Rotational ? 6 : 3,
           {},
           [sweep, rays](SeededStream& stream) { return sweep_problem(sweep, rays, stream); }});
    };
    for (const double distance : {3.0, 1e3, 1e6}) {
      add(fmt::format("from {:g}", distance), {RayKind::From, distance});
    }
    for (const int k : {6, 10}) {
      add(fmt::format("grazing 1e-{}", k), {RayKind::Grazing, std::pow(10.0, -k), kBitsOfDouble});
    }
  }
}

std::vector<PolynomialFamily> make_families() {
  std::vector<PolynomialFamily> all;
  const std::vector<int> degrees{2, 3, 4, 6, 10};
  for (const int n : degrees) {
    all.push_back({"separated", "", n, {}, [n](SeededStream& stream) {
                     return given(with_roots(separated_roots(n, stream)));
                   }});
  }
  for (const int members : {2, 3}) {
    for (const int n : degrees) {
      for (const int k : {3, 6, 9, 12}) {
        if (n < members) {
          continue;
        }
        all.push_back({fmt::format("cluster of {}", members),
                       fmt::format("1e-{}", k),
                       n,
                       {},
                       [n, members, k](SeededStream& stream) {
                         return given(
                             with_roots(clustered_roots(n, members, std::pow(10.0, -k), stream)));
                       }});
      }
    }
  }
  for (const int n : degrees) {
    all.push_back({"double root", "", n, {}, [n](SeededStream& stream) {
                     Coefficients roots = short_roots(n - 1, stream);
                     roots.push_back(roots.front());
                     return given(with_roots(roots));
                   }});
  }
  for (const int n : degrees) {
    if (n % 2 == 0) {
      all.push_back(
          {"no root", "", n, {}, [n](SeededStream& stream) { return given(rootless(n, stream)); }});
    }
  }
  for (const int n : degrees) {
    all.push_back({"roots at 0 and 1", "", n, {}, [n](SeededStream& stream) {
                     Coefficients roots = short_roots(n - 2, stream);
                     roots.insert(roots.end(), {Rational(0), Rational(1)});
                     return given(with_roots(roots));
                   }});
  }
  for (const int n : degrees) {
    for (const int k : {150, -150, -310}) {
      all.push_back({"badly scaled", fmt::format("1e{}", k), n, {}, [n, k](SeededStream& stream) {
                       return given(scaled(with_roots(separated_roots(n, stream)), k));
                     }});
    }
  }
  add_ray_families(all);
  add_sweep_families(all);
  return all;
}

}  // namespace

const std::vector<PolynomialFamily>& polynomial_families() {
  static const std::vector<PolynomialFamily> all = make_families();
  return all;
}

}  // namespace lamina::experiments
