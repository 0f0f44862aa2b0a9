#include "census/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "support/class_tally.hpp"
#include "support/law_models.hpp"
#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {
namespace {

using csg::LeafIndex;
using csg::Medium;
using geometry::ExactRay;
using method::Method;
using support::scene_of;

constexpr std::uint32_t kRandomOrders = 24;

std::vector<Method> spelled(const std::vector<std::string>& names) {
  std::vector<Method> methods;
  std::transform(names.begin(), names.end(), std::back_inserter(methods),
                 [](const std::string& name) { return method::parse_method(name); });
  return methods;
}

const std::vector<std::string> kMethods{"roth",           "wyvill-sharp",
                                        "epsilon:1e-3",   "regularized",
                                        "wyvill-trotman", "wyvill-trotman:parity:no-look-ahead"};

std::vector<trace::NumberChoice> numbers() {
  return {trace::number_choice<float>(), trace::number_choice<number::exact>()};
}

struct Bench {
  Bench(scene::Scene of, const trace::NumberChoice& number)
      : scene(std::move(of)), tracer(number.make_tracer(scene, {})), probe(scene, kRandomOrders) {}

  std::vector<std::uint32_t> outcomes(const std::vector<Method>& methods, const ExactRay& ray) {
    tracer->find(ray);
    std::vector<method::Report> reports(methods.size());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      tracer->run(methods[m], reports[m]);
    }
    return probe.outcomes(*tracer, methods, reports);
  }

  scene::Scene scene;
  std::unique_ptr<method::Tracer> tracer;
  OrderProbe probe;
};

std::vector<std::uint32_t> outcomes(const std::string& text, const ExactRay& ray,
                                    const std::vector<std::string>& methods,
                                    const trace::NumberChoice& number) {
  return Bench(scene_of(text), number).outcomes(spelled(methods), ray);
}

// What a method shows: which group of equal t, the media on both sides, and of roth, which may
// report a surface that changes nothing, that surface's material.
using Shown = std::vector<std::tuple<std::size_t, Medium, Medium, Medium>>;

Shown shown(method::Tracer& tracer, const scene::Scene& scene, const Method& method) {
  method::Report report;
  tracer.run(method, report);
  Shown result;
  const bool by_surface = method.name == "roth";
  for (const method::Interface& interface : report.interfaces) {
    const scene::Leaf& leaf = scene.leaves[tracer.crossings()[interface.crossing].leaf];
    std::size_t group = 0;
    for (std::size_t i = 1; i <= interface.crossing; ++i) {
      group += tracer.equal_t(i - 1, i) ? 0 : 1;
    }
    result.emplace_back(group, interface.transition.from, interface.transition.to,
                        by_surface ? leaf.medium : csg::kEmpty);
  }
  return result;
}

std::set<LeafIndex> tied_leaves(const method::Tracer& tracer) {
  std::set<LeafIndex> tied;
  for (std::size_t i = 1; i < tracer.crossings().size(); ++i) {
    if (tracer.equal_t(i - 1, i)) {
      tied.insert(tracer.crossings()[i - 1].leaf);
      tied.insert(tracer.crossings()[i].leaf);
    }
  }
  return tied;
}

// Every order of the tied leaves, in full, by a method that is run anew.
std::size_t outcomes_by_hand(Bench& bench, const Method& method) {
  const std::set<LeafIndex> tied = tied_leaves(*bench.tracer);
  std::vector<LeafIndex> order(tied.begin(), tied.end());
  std::vector<LeafIndex> rank(bench.scene.leaves.size());
  std::set<Shown> seen;
  do {
    for (LeafIndex i = 0; i < order.size(); ++i) {
      rank[order[i]] = i;
    }
    bench.tracer->reorder(rank);
    seen.insert(shown(*bench.tracer, bench.scene, method));
  } while (std::next_permutation(order.begin(), order.end()));
  std::iota(rank.begin(), rank.end(), LeafIndex{0});
  bench.tracer->reorder(rank);
  return seen.size();
}

std::string same_half_spaces(int count) {
  std::string text = "add() {\n";
  for (int i = 0; i < count; ++i) {
    text += "material(\"m" + std::to_string(i) + "\") halfspace([0, 0, 1], 0);\n";
  }
  return text + "}\n";
}

const ExactRay kDown{{1, 1, 5}, {0, 0, -1}};

TEST(OrderProbeTest, WhereNothingTiesThereIsOneAnswer) {
  for (const auto& number : numbers()) {
    EXPECT_EQ(outcomes("add() { cube(2); translate([0, 0, 1]) cube(2); }", kDown, kMethods, number),
              std::vector<std::uint32_t>(kMethods.size(), 1));
    EXPECT_EQ(outcomes("cube(2);", {{9, 9, 9}, {0, 0, 1}}, kMethods, number),
              std::vector<std::uint32_t>(kMethods.size(), 1));
  }
}

// One at a time, the second material is shown at once or after the first; at the far side the
// first is left before the second or after. Together, the second is all that is seen.
TEST(OrderProbeTest, ACubeAddedToItselfOfAnotherMaterial) {
  const std::vector<std::string> methods{"wyvill-trotman", "wyvill-trotman:parity", "regularized",
                                         "epsilon:1e-3", "wyvill-sharp"};
  const std::string text = "add() { material(\"a\") cube(2); material(\"b\") cube(2); }";
  for (const auto& number : numbers()) {
    EXPECT_EQ(outcomes(text, {{1, 1, 1}, {0, 0, -1}}, methods, number),
              (std::vector<std::uint32_t>{2, 2, 1, 1, 1}))
        << "from inside, in " << number.name;
    EXPECT_EQ(outcomes(text, kDown, methods, number), (std::vector<std::uint32_t>{4, 4, 1, 1, 1}))
        << "from outside, in " << number.name;
  }
}

// Of materials that are added, a later one covers: what is shown, one at a time, are the
// materials that no earlier event's covers. These are an ascending sequence that ends in the
// last material, and some order shows each: 2^(n-1) in all. Roth shows the first of the group.
TEST(OrderProbeTest, AllOrdersOfUpToFourLeaves) {
  for (const auto& number : numbers()) {
    for (int n = 1; n <= 4; ++n) {
      EXPECT_EQ(
          outcomes(same_half_spaces(n), kDown, {"wyvill-trotman", "regularized", "roth"}, number),
          (std::vector<std::uint32_t>{1U << (n - 1), 1, static_cast<std::uint32_t>(n)}))
          << n << " in " << number.name;
    }
  }
}

TEST(OrderProbeTest, OfMoreLeavesItTriesSomeOrdersTheSameEachTime) {
  const scene::Scene scene = scene_of(same_half_spaces(6));
  const std::vector<Method> methods = spelled({"wyvill-trotman", "regularized"});
  const auto tracer = method::make_tracer<float>(scene, {});
  tracer->find(kDown);
  std::vector<method::Report> reports(2);
  tracer->run(methods[0], reports[0]);
  tracer->run(methods[1], reports[1]);
  const auto tried = [&](std::uint32_t orders) {
    OrderProbe probe(scene, orders);
    const auto first = probe.outcomes(*tracer, methods, reports);
    EXPECT_EQ(probe.outcomes(*tracer, methods, reports), first);
    EXPECT_EQ(first[1], 1U);
    return first[0];
  };
  EXPECT_EQ(tried(0), 1U);
  const std::uint32_t some = tried(5);
  EXPECT_GE(some, 2U);
  EXPECT_LE(some, 6U);  // these and the scene's own
  EXPECT_EQ(tried(5), some);
  EXPECT_EQ(tried(4000), 32U);  // 2^5: of 720 orders none is likely to be left out
}

TEST(OrderProbeTest, EqualsBruteForceAndLeavesTheTracerAsItWas) {
  support::ClassTally tally{"rays", "two", "three", "four"};
  std::vector<std::uint64_t> sensitive(kMethods.size());
  const std::vector<Method> methods = spelled(kMethods);
  const auto tried = [&](const support::LawModel& model) {
    for (const auto& number : numbers()) {
      Bench bench(scene_of(model.text), number);
      for (const ExactRay& ray : model.rays) {
        bench.tracer->find(ray);
        const std::size_t tied = tied_leaves(*bench.tracer).size();
        if (tied == 0 || tied > 4) {
          continue;
        }
        const auto before = bench.tracer->crossings();
        const std::vector<method::CrossingId> crossings(before.begin(), before.end());
        const auto counted = bench.outcomes(methods, ray);
        const auto after = bench.tracer->crossings();
        ASSERT_EQ(after.size(), crossings.size());
        for (std::size_t i = 0; i < crossings.size(); ++i) {
          EXPECT_EQ(after[i].leaf, crossings[i].leaf) << model.name;
          EXPECT_EQ(after[i].index, crossings[i].index) << model.name;
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
          EXPECT_EQ(counted[m], outcomes_by_hand(bench, methods[m]))
              << kMethods[m] << " in " << number.name << ", " << model.name;
          sensitive[m] += counted[m] > 1 ? 1 : 0;
        }
        tally.add("rays");
        tally.add(tied == 2 ? "two" : tied == 3 ? "three" : "four");
      }
    }
  };
  for (std::uint64_t i = 0; i < 16; ++i) {
    tried(support::family_model(11, i, 6));
    tried(support::lattice_model(11, i, 6));
  }
  EXPECT_TRUE(tally.each_at_least(4)) << tally;
  EXPECT_EQ(sensitive[3], 0U);  // regularized: all at once
  EXPECT_GE(sensitive[4], 10U);
  EXPECT_GE(sensitive[1], 1U);
}

}  // namespace
}  // namespace lamina::census
