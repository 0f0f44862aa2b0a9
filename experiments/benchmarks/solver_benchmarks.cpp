// Root finders in double: time a polynomial, and backward error. Figures in README.md.
#include "experiments/benchmarks/solver_benchmarks.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "experiments/benchmarks/allocation_counter.hpp"
#include "poly/solution.hpp"
#include "scene/rays.hpp"
#include "surface/certified_surface.hpp"
#include "surface/rounded_surface.hpp"

namespace lamina {
namespace {

using number::Rational;

constexpr std::size_t kPolynomials = 1000;
constexpr poly::Range<double> kUnit{0, 1};

// One root in each of n equal parts of [0, 1], not near the part's ends: the family `separated` of
// solver-accuracy.
std::vector<double> separated(int n, base::SeededStream& stream) {
  std::vector<Rational> exact{1};
  for (int i = 0; i < n; ++i) {
    const Rational root((i + stream.uniform(0.2, 0.8)) / n);
    exact.insert(exact.begin(), Rational(0));
    for (std::size_t k = 0; k + 1 < exact.size(); ++k) {
      exact[k] -= root * exact[k + 1];
    }
  }
  std::vector<double> c;
  for (const Rational& x : exact) {
    c.push_back(number::nearest_double(x));
  }
  return c;
}

// A product of quadratics without roots: the family `no root`.
std::vector<double> rootless(int n, base::SeededStream& stream) {
  std::vector<double> c{1};
  for (int i = 0; i < n; i += 2) {
    const double middle = stream.unit();
    const double height = stream.uniform(0.1, 1);
    std::vector<double> product(c.size() + 2);
    for (std::size_t k = 0; k < c.size(); ++k) {
      product[k] += c[k] * (middle * middle + height * height);
      product[k + 1] -= 2 * c[k] * middle;
      product[k + 2] += c[k];
    }
    c = product;
  }
  return c;
}

using Draw = std::vector<double> (*)(int, base::SeededStream&);

std::vector<std::vector<double>> polynomials(Draw draw, int n) {
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < kPolynomials; ++i) {
    base::SeededStream stream("benchmark/polynomials", 1, i);
    all.push_back(draw(n, stream));
  }
  return all;
}

// |p(t)| / (u sum |c_i t^i|), exact.
double backward_error(const std::vector<double>& c, double t) {
  Rational value = 0;
  Rational terms = 0;
  Rational power = 1;
  for (const double x : c) {
    value += Rational(x) * power;
    terms += abs(Rational(x) * power);
    power *= Rational(t);
  }
  return std::ldexp(number::nearest_double(abs(value) / terms), 53);
}

void solve(benchmark::State& state, poly::Solver solver, Draw draw, int n) {
  const auto all = polynomials(draw, n);
  const auto one = [&](std::size_t i) {
    return poly::real_roots(std::span<const double>(all[i % kPolynomials]), kUnit, solver);
  };
  std::size_t i = 0;
  std::uint64_t allocated = 0;
  for (auto _ : state) {
    const std::uint64_t before = benchmarks::allocations();
    benchmark::DoNotOptimize(one(i++).count);
    allocated += benchmarks::allocations() - before;
  }
  int wrong = 0;
  double backward = 0;
  for (std::size_t k = 0; k < kPolynomials; ++k) {
    const auto roots = one(k);
    wrong += roots.count == (draw == separated ? n : 0) ? 0 : 1;
    for (int r = 0; r < roots.count; ++r) {
      backward = std::max(backward, backward_error(all[k], roots.t[r]));
    }
  }
  state.counters["allocations"] = static_cast<double>(allocated);
  state.counters["wrong_counts"] = wrong;
  state.counters["backward_u"] = backward;
}

// On a shared machine the fastest of several repetitions says most.
template <typename Function>
void add(const std::string& name, Function&& function) {
  benchmark::RegisterBenchmark(name.c_str(), function)
      ->ComputeStatistics("least", [](const std::vector<double>& times) {
        return *std::min_element(times.begin(), times.end());
      });
}

// Rays from 3 away at random points of the ball that bounds the solid.
std::vector<geometry::Ray<double>> rays_at(double bounding_radius) {
  std::vector<geometry::Ray<double>> all;
  for (std::size_t i = 0; i < kPolynomials; ++i) {
    base::SeededStream stream("benchmark/rays", 1, i);
    const auto target =
        bounding_radius * std::cbrt(stream.unit()) * scene::random_direction(stream);
    const auto ray =
        scene::ray_from(target + 3.0 * scene::random_direction(stream), target, scene::Held::Float);
    all.push_back({nearest_double(ray.origin), nearest_double(ray.direction)});
  }
  return all;
}

// One call of `crossings` a ray, by its number of roots.
template <typename Crossings>
void cross(benchmark::State& state, double bounding_radius, const Crossings& crossings) {
  const auto rays = rays_at(bounding_radius);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(crossings(rays[i++ % kPolynomials]));
  }
}

void register_surfaces() {
  struct Solid {
    const char* name;
    surface::LocalSurface surface;
    double bounding_radius;
  };
  for (const Solid& solid : {Solid{"sphere", surface::sphere(1), 1},
                             Solid{"torus", surface::torus(1, Rational(1, 4)), 1.25}}) {
    for (const auto recentring : {poly::Recentring::None, poly::Recentring::All}) {
      const std::string name =
          fmt::format("cross/{}/{}", solid.name,
                      recentring == poly::Recentring::None ? "as_given" : "recentred");
      add(name, [solid, recentring](benchmark::State& state) {
        const surface::RoundedSurface<double> rounded(solid.surface);
        const poly::Solvers solvers{.recentring = recentring};
        cross(state, solid.bounding_radius, [&](const geometry::Ray<double>& ray) {
          return rounded.crossings(ray, solvers).roots.count;
        });
      });
    }
    add(fmt::format("cross/{}/certified", solid.name), [solid](benchmark::State& state) {
      const surface::CertifiedSurface certified(solid.surface, geometry::AffineMap());
      cross(state, solid.bounding_radius, [&](const geometry::Ray<double>& ray) {
        return certified.crossings(ray, {0, 6}).count;
      });
    });
  }
}

}  // namespace

namespace benchmarks {

void register_solvers() {
  for (const int n : {2, 3, 4, 6, 10}) {
    for (const poly::SolverInfo& info : poly::all_solvers()) {
      if (!poly::fits(info.solver, n)) {
        continue;
      }
      const std::string name =
          "solve/separated/" + std::to_string(n) + "/" + std::string(info.name);
      add(name, [solver = info.solver, n](benchmark::State& state) {
        solve(state, solver, separated, n);
      });
    }
  }
  for (const poly::SolverInfo& info : poly::all_solvers()) {
    if (poly::fits(info.solver, 6)) {
      const std::string name = "solve/no_root/6/" + std::string(info.name);
      add(name,
          [solver = info.solver](benchmark::State& state) { solve(state, solver, rootless, 6); });
    }
  }
  register_surfaces();
}

}  // namespace benchmarks
}  // namespace lamina
