// Rays a second: the truth, every method, every number type. Figures in README.md.
#include <benchmark/benchmark.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "census/truth.hpp"
#include "method/classify.hpp"
#include "method/tracer.hpp"
#include "number/all_numbers.hpp"
#include "scene/rays.hpp"

// Counts heap allocations: after warm-up a ray in hardware numbers makes none.
static std::atomic<std::uint64_t> g_allocations{0};

void* operator new(std::size_t size) {
  ++g_allocations;
  if (void* memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
BENCHMARK_CAPTURE(exact_truth, twelve_leaves, kTwelveLeaves);
BENCHMARK_CAPTURE(exact_truth, two_tori, kTwoTori);

template <typename Number>
std::vector<geometry::Ray<Number>> rounded_rays(const Setup& setup) {
  using Traits = number::number_traits<Number>;
  std::vector<geometry::Ray<Number>> rays;
  for (const auto& [o, d] : setup.rays) {
    rays.push_back({{Traits::from_exact(o.x), Traits::from_exact(o.y), Traits::from_exact(o.z)},
                    {Traits::from_exact(d.x), Traits::from_exact(d.y), Traits::from_exact(d.z)}});
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
        .run(method, step);
    benchmark::DoNotOptimize(report.interfaces.data());
  };
  for (std::size_t i = 0; i < kRays; ++i) {
    one(i);
  }
  const std::uint64_t before = g_allocations;
  std::size_t i = 0;
  for (auto _ : state) {
    one(i++);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["allocations"] = benchmark::Counter(static_cast<double>(g_allocations - before),
                                                     benchmark::Counter::kAvgIterations);
}

#define LAMINA_METHOD(name, method)                                      \
  BENCHMARK_CAPTURE(trace<double>, twelve_leaves_##name, kTwelveLeaves, method); \
  BENCHMARK_CAPTURE(trace<double>, two_tori_##name, kTwoTori, method)
LAMINA_METHOD(roth, "roth");
LAMINA_METHOD(wyvill_sharp, "wyvill-sharp");
LAMINA_METHOD(epsilon, "epsilon:1e-6");
LAMINA_METHOD(regularized, "regularized");
LAMINA_METHOD(wyvill_trotman, "wyvill-trotman");
#undef LAMINA_METHOD

#define LAMINA_NUMBER(Number) \
  BENCHMARK_CAPTURE(trace<Number>, number_twelve_leaves, kTwelveLeaves, "wyvill-trotman"); \
  BENCHMARK_CAPTURE(trace<Number>, number_two_tori, kTwoTori, "wyvill-trotman");
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_NUMBER)
#undef LAMINA_NUMBER

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
