// Sweeps of splines in double, by the number of their pieces: rays a second, and pieces that are
// there, tested and hit. Figures in README.md.
#include "experiments/benchmarks/sweep_benchmarks.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "geometry/rounding.hpp"
#include "scene/rays.hpp"
#include "surface/rounded_sweep.hpp"

namespace lamina {
namespace {

using Rays = std::vector<geometry::Ray<double>>;
using Sweep = surface::RoundedSweep<double>;

constexpr std::size_t kRays = 4096;

// From the axis up the outside and down the inside, to the axis: a bowl on a foot, in closed form,
// at points of even steps.
std::string glass(int points) {
  std::string text;
  for (int i = 0; i < points; ++i) {
    const double place = 2.0 * i / (points - 1);  // 0 .. 1 outside, 1 .. 2 inside
    const double outside = place <= 1 ? place : 2 - place;
    const double width = place <= 1 ? 1 : 0.85;
    const double angle = std::numbers::pi / 2 * outside;
    // Ellipses about one centre, on the axis at both ends of the profile; the outer one is dented.
    const double dent = place <= 1 ? 0.05 * std::pow(std::sin(3 * angle), 2) : 0;
    const bool at_end = i == 0 || i + 1 == points;
    const double u = at_end ? 0 : (width - dent) * std::sin(angle);
    const double v = -2 * width * std::cos(angle);
    text += fmt::format("{}[{:.6f}, {:.6f}]", i == 0 ? "" : ", ", u, v);
  }
  return fmt::format("rotational_sweep() contour([{}], kind=\"catmull_rom\", closed=false);", text);
}

std::string prism(int points, double (*radius)(int point, double angle)) {
  std::string text;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const double r = radius(i, angle);
    text += fmt::format("{}[{:.6f}, {:.6f}]", i == 0 ? "" : ", ", r * std::cos(angle),
                        r * std::sin(angle));
  }
  return fmt::format("translational_sweep() contour([{}], kind=\"catmull_rom\");", text);
}

// Five petals, however many points.
std::string flower(int points) {
  return prism(points, [](int, double angle) { return 1 + 0.25 * std::cos(5 * angle); });
}

// A ray of it for every two points: the more there are, the more pieces a line meets.
std::string star(int points) {
  return prism(points, [](int point, double) { return point % 2 == 0 ? 1.25 : 0.5; });
}

// Rays from outside through random points of the box: the same box for all numbers of points.
Rays rays_at(const scene::Bounds& box) {
  base::SeededStream stream("benchmark/sweeps", 1, 0);
  Rays rays;
  for (const geometry::ExactRay& ray : scene::uniform_rays(box, kRays, stream)) {
    rays.push_back(geometry::rounded<double>(ray));
  }
  return rays;
}

// The side of the scene's first leaf alone, which all the pieces are of.
void cross_sweep(benchmark::State& state, const std::string& text, const scene::Bounds& box,
                 bool each_piece) {
  const scene::Scene scene = scene::parse_scene(text, "benchmark");
  const surface::SweptSurface& exact = *scene.leaves.front().surface.sweep;
  const Sweep sweep(exact, surface::AsPrinted{.each_piece = each_piece});
  const Rays rays = rays_at(box);
  const auto pieces = static_cast<std::uint32_t>(exact.contour().pieces().size());
  std::vector<Sweep::Crossing> crossings;
  std::uint64_t solved = 0;
  std::uint64_t hit = 0;
  for (const auto& ray : rays) {
    for (std::uint32_t i = 0; i < pieces; ++i) {
      solved += sweep.rules_out(ray, i) ? 0U : 1U;
    }
    sweep.find_crossings(ray, {}, crossings);
    hit += crossings.size();
  }
  std::size_t i = 0;
  for (auto _ : state) {
    sweep.find_crossings(rays[i++ % kRays], {}, crossings);
    benchmark::DoNotOptimize(crossings.data());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["pieces"] = pieces;
  state.counters["solved"] = static_cast<double>(solved) / kRays;
  state.counters["crossings"] = static_cast<double>(hit) / kRays;
}

}  // namespace

void benchmarks::register_sweeps() {
  const number::Rational r = number::Rational(5) / 4;
  const scene::Bounds around_glass{{-1, -1, -2}, {1, 1, 0}};
  const scene::Bounds around_prism{{-r, -r, 0}, {r, r, 1}};
  struct Named {
    const char* name;
    std::string (*text)(int points);
    scene::Bounds box;
  };
  for (const Named& solid :
       {Named{"glass", glass, around_glass}, Named{"flower", flower, around_prism},
        Named{"star", star, around_prism}}) {
    for (const bool each_piece : {false, true}) {
      for (const int points : {10, 20, 30, 40, 50}) {
        benchmark::RegisterBenchmark(
            fmt::format("sweep/{}/{}/{}", solid.name, each_piece ? "list" : "tree", points).c_str(),
            [=](benchmark::State& state) {
              cross_sweep(state, solid.text(points), solid.box, each_piece);
            });
      }
    }
  }
}

}  // namespace lamina
