// Laws of the methods: what must be equal, in exact numbers or in all.
#include <catch2/catch.hpp>

#include "geometry/ray_text.hpp"
#include "number/all_numbers.hpp"
#include "support/class_tally.hpp"
#include "support/law_models.hpp"
#include "trace/number_choice.hpp"

namespace lamina {
namespace {

using support::LawModel;
using support::TruthBench;

constexpr std::uint64_t kSeed = 3;
constexpr std::uint64_t kRays = 12;

template <typename Check>
void for_each_model(std::uint64_t lattice_models, std::uint64_t family_models, Check check) {
  for (std::uint64_t i = 0; i < lattice_models; ++i) {
    check(support::lattice_model(kSeed, i, kRays, {.tori = i % 16 == 0}));
  }
  for (std::uint64_t i = 0; i < family_models; ++i) {
    check(support::family_model(kSeed, i, kRays));
  }
}

std::string place(const LawModel& model, const geometry::ExactRay& ray) {
  return model.name + ", ray \"" + geometry::to_text(ray) + "\" in\n" + model.text;
}

bool several(const census::TruthClass& cls) { return cls.leaves.size() > 1; }

TEST_CASE("roth and regularized see the same media in exact numbers", "[laws]") {
  support::ClassTally tally{"rays", "interfaces", "other surface"};
  for_each_model(80, 60, [&](const LawModel& model) {
    TruthBench bench(model.text);
    for (const auto& ray : model.rays) {
      bench.find(ray);
      const method::Report roth = bench.report(method::roth());
      const method::Report regularized = bench.report(method::regularized());
      bool same = roth.start == regularized.start && roth.end == regularized.end &&
                  roth.interfaces.size() == regularized.interfaces.size();
      bool other_surface = false;
      for (std::size_t i = 0; same && i < roth.interfaces.size(); ++i) {
        const auto& a = roth.interfaces[i];
        const auto& b = regularized.interfaces[i];
        same = a.transition == b.transition && bench.tracer().equal_t(a.crossing, b.crossing);
        other_surface = other_surface || a.crossing != b.crossing;
      }
      if (!same) {
        FAIL(place(model, ray));
      }
      tally.add("rays");
      tally.add("interfaces", !roth.interfaces.empty());
      tally.add("other surface", other_surface);
    }
  });
  INFO(tally);
  CHECK(tally.count("interfaces") >= tally.count("rays") / 10);
  CHECK(tally.count("other surface") >= tally.count("rays") / 50);
}

TEST_CASE("epsilon:0 is regularized in every number type", "[laws]") {
  std::vector<trace::NumberChoice> numbers;
#define LAMINA_CHOICE(Number) numbers.push_back(trace::number_choice<Number>());
  LAMINA_FOR_EACH_NUMBER(LAMINA_CHOICE)
#undef LAMINA_CHOICE
  const std::vector<method::Method> methods{method::epsilon(0, false), method::epsilon(0, true)};
  support::ClassTally tally{"reports", "interfaces", "equal t"};
  for_each_model(48, 32, [&](const LawModel& model) {
    const scene::Scene scene = scene::parse_scene(model.text, model.name);
    for (const auto& number : numbers) {
      const auto tracer = number.make_tracer(scene, {});
      for (const auto& ray : model.rays) {
        tracer->find(ray);
        method::Report regularized;
        tracer->run(method::regularized(), regularized);
        for (const method::Method& epsilon : methods) {
          method::Report report;
          tracer->run(epsilon, report);
          bool same = report.start == regularized.start && report.end == regularized.end &&
                      report.inconsistent == regularized.inconsistent &&
                      report.interfaces.size() == regularized.interfaces.size();
          for (std::size_t i = 0; same && i < report.interfaces.size(); ++i) {
            same = report.interfaces[i].crossing == regularized.interfaces[i].crossing &&
                   report.interfaces[i].transition == regularized.interfaces[i].transition;
          }
          if (!same) {
            FAIL(epsilon.name << " on " << number.name << ": " << place(model, ray));
          }
          tally.add("reports");
          tally.add("interfaces", !report.interfaces.empty());
        }
        bool equal = false;
        for (std::size_t i = 1; i < tracer->crossings().size(); ++i) {
          equal = equal || tracer->equal_t(i - 1, i);
        }
        tally.add("equal t", equal);
      }
    }
  });
  INFO(tally);
  CHECK(tally.count("interfaces") >= tally.count("reports") / 10);
  CHECK(tally.count("equal t") >= tally.count("reports") / 20);
}

// Survey C.4: with complete lists that alternate and start right, events in any order that
// keeps each leaf's own leave the exact state behind every class.
TEST_CASE("wyvill-trotman by parity has the true medium behind every class", "[laws]") {
  const method::Method method = method::parse_method("wyvill-trotman:parity:no-look-ahead");
  support::ClassTally tally{"rays", "several leaves", "several media in one class"};
  for_each_model(80, 60, [&](const LawModel& model) {
    TruthBench bench(model.text);
    for (const auto& ray : model.rays) {
      bench.find(ray);
      method::Report report;
      const auto records = bench.tracer().explain(method, report);
      REQUIRE(records.size() == bench.truth().crossings().size());
      bool right = report.start == bench.truth().start() && report.end == bench.truth().end() &&
                   report.rejected == 0 && report.inconsistent == 0;
      bool passing = false;
      const auto& classes = bench.truth().classes();
      for (const census::TruthClass& cls : classes) {
        const std::size_t last = cls.first_crossing + cls.leaves.size() - 1;
        right = right && records[last].crossing == last &&
                records[last].medium == cls.effect.transition.to;
        for (std::size_t i = cls.first_crossing; i < last; ++i) {
          passing = passing || (records[i].medium != cls.effect.transition.from &&
                                records[i].medium != cls.effect.transition.to);
        }
      }
      if (!right) {
        FAIL(place(model, ray));
      }
      tally.add("rays");
      tally.add("several leaves", std::any_of(classes.begin(), classes.end(), several));
      tally.add("several media in one class", passing);
    }
  });
  INFO(tally);
  CHECK(tally.count("several leaves") >= tally.count("rays") / 5);
  CHECK(tally.count("several media in one class") >= tally.count("rays") / 100);
}

// Before its first crossing a leaf's state does not change: in exact numbers any reference point
// there is as good as minus infinity. The one evaluates f, the other asks for the sign of its
// leading coefficient.
TEST_CASE("A reference point in exact numbers has the state of minus infinity", "[laws]") {
  std::vector<method::Method> methods;
  // No round numbers, so that the point is on no surface that the ray only touches.
  for (const char* distance : {"1.0000001e-9", "0.7853981", "1234567.89"}) {
    methods.push_back(method::parse_method(std::string("wyvill-trotman:reference:") + distance));
  }
  support::ClassTally tally{"states", "inside", "crossed", "not crossed"};
  for_each_model(40, 30, [&](const LawModel& model) {
    TruthBench bench(model.text);
    for (const auto& ray : model.rays) {
      bench.find(ray);
      for (csg::LeafIndex leaf = 0; leaf < bench.scene().leaves.size(); ++leaf) {
        const bool expected = bench.truth().starts_inside(leaf);
        for (const method::Method& method : methods) {
          if (bench.tracer().starts_inside(method, leaf) != expected) {
            FAIL(method.name << ", leaf " << leaf << ": " << place(model, ray));
          }
        }
        tally.add("states");
        tally.add("inside", expected);
        tally.add(bench.truth().crossings_of(leaf).empty() ? "not crossed" : "crossed");
      }
    }
  });
  INFO(tally);
  CHECK(tally.count("inside") >= tally.count("states") / 10);
  CHECK(tally.count("crossed") >= tally.count("states") / 10);
  CHECK(tally.count("not crossed") >= tally.count("states") / 50);
}

}  // namespace
}  // namespace lamina
