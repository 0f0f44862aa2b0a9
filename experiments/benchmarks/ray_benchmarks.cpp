// Rays a second: the truth, every method, every number type. Figures in README.md.
#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "census/truth.hpp"
#include "experiments/benchmarks/allocation_counter.hpp"
#include "experiments/benchmarks/solver_benchmarks.hpp"
#include "experiments/benchmarks/sweep_benchmarks.hpp"
#include "geometry/rounding.hpp"
#include "method/classify.hpp"
#include "method/tracer.hpp"
#include "number/all_numbers.hpp"
#include "scene/rays.hpp"

namespace lamina {
namespace {

// Twelve planes and quadrics; the foot's top is the block's bottom, the bore ends in its top.
constexpr const char* kTwelveLeaves = R"(rotate([17, 29, 43]) difference() {
  add() {
    translate([-1, -1, 0]) cube([2, 2, 1]);
    translate([0, 0, -1]) cylinder(h=1, r=4/5);
  }
  translate([0, 0, 1/3]) cylinder(h=2/3, r=1/2);
})";

constexpr const char* kTwoTori = R"(rotate([17, 29, 43]) difference() {
  add() {
    torus(2, 1/2);
    translate([-2, -2, -1/2]) cube([4, 4, 1/2]);
  }
  rotate([90, 0, 0]) torus(2, 1/3);
})";

constexpr std::size_t kRays = 512;

struct Setup {
  scene::Scene scene;
  std::vector<geometry::ExactRay> rays;

  explicit Setup(const char* text) : scene(scene::parse_scene(text, "benchmark")) {
    base::SeededStream stream("benchmark", 1, 0);
    rays = scene::uniform_rays(*scene.bounds, kRays, stream);
  }
};

void exact_truth(benchmark::State& state, const char* text) {
  const Setup setup(text);
  census::Truth truth(setup.scene);
  std::size_t i = 0;
  for (auto _ : state) {
    truth.find(setup.rays[i++ % kRays]);
    benchmark::DoNotOptimize(truth.classes().data());
  }
  state.SetItemsProcessed(state.iterations());
}

template <typename Number>
std::vector<geometry::Ray<Number>> rounded_rays(const Setup& setup) {
  std::vector<geometry::Ray<Number>> rays;
  for (const geometry::ExactRay& ray : setup.rays) {
    rays.push_back(geometry::rounded<Number>(ray));
  }
  return rays;
}

// Crossings and classification together: what a renderer does for a ray.
template <typename Number>
void trace(benchmark::State& state, const char* text, const char* method_name) {
  const Setup setup(text);
  const method::Method method = method::parse_method(method_name);
  const Number step = number::number_traits<Number>::from_exact(method.epsilon);
  const auto rays = rounded_rays<Number>(setup);
  method::RayEvents<Number> events(setup.scene, {});
  csg::RayState ray_state(setup.scene.tree);
  method::Report report;
  const auto one = [&](std::size_t i) {
    events.find(rays[i % kRays]);
    method::Classifier(setup.scene, events, ray_state, report, method::IgnoreEvents{})
        .run(method, step, Number(0));
    benchmark::DoNotOptimize(report.interfaces.data());
  };
  for (std::size_t i = 0; i < kRays; ++i) {
    one(i);
  }
  std::size_t i = 0;
  std::uint64_t allocated = 0;  // by the rays alone, not by the benchmark around them
  for (auto _ : state) {
    const std::uint64_t before = benchmarks::allocations();
    one(i++);
    allocated += benchmarks::allocations() - before;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["allocations"] = static_cast<double>(allocated);
}

struct Named {
  const char* name;
  const char* scene;
};
constexpr std::array kScenes{Named{"twelve_leaves", kTwelveLeaves}, Named{"two_tori", kTwoTori}};

template <typename Number>
void register_trace(const Named& scene, const char* method) {
  const std::string name = std::string("trace/") + scene.name + "/" +
                           number::number_traits<Number>::name() + "/" + method;
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { trace<Number>(state, scene.scene, method); });
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  using namespace lamina;
  for (const Named& scene : kScenes) {
    benchmark::RegisterBenchmark((std::string("exact_truth/") + scene.name).c_str(),
                                 [=](benchmark::State& state) { exact_truth(state, scene.scene); });
    for (const char* method : {"roth", "wyvill-sharp", "epsilon:1e-6", "regularized"}) {
      register_trace<double>(scene, method);
    }
#define LAMINA_REGISTER(Number) register_trace<Number>(scene, "wyvill-trotman");
    LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_REGISTER)
#undef LAMINA_REGISTER
  }
  benchmarks::register_solvers();
  benchmarks::register_sweeps();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
