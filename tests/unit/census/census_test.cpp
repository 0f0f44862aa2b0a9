#include "census/census.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/families.hpp"
#include "scene/rays.hpp"
#include "support/equal_census.hpp"
#include "support/scenes.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {
namespace {

constexpr std::uint64_t kSeed = 5;

Plan plan(int threads) {
  Plan plan;
  for (const char* method :
       {"roth", "wyvill-sharp", "epsilon:1e-3", "regularized", "wyvill-trotman"}) {
    plan.methods.push_back(method::parse_method(method));
  }
  plan.numbers = {trace::number_choice<float>(), trace::number_choice<number::exact>()};
  plan.threads = threads;
  return plan;
}

// Rays at the patches of one member of a family, a part of them.
Task task_of(std::uint64_t case_id, std::uint64_t first, std::uint64_t last) {
  Task task;
  task.scene = scene::open_scene(scene::family_spelling("coincident-faces", kSeed, case_id));
  const scene::FamilyMember member = scene::coincident_faces(kSeed, case_id);
  const auto& patch = member.patches.front();
  for (std::uint64_t i = first; i < last; ++i) {
    base::SeededStream stream("census_test", case_id, i);
    const double u = stream.unit();
    const double v = stream.unit();
    task.rays.push_back(scene::ray_through(patch.corner + u * patch.side1 + v * patch.side2,
                                           distance_outside(*task.scene.bounds), stream));
  }
  return task;
}

Census run(
    const Plan& plan, std::size_t tasks,
    const std::function<Task(std::size_t)>& task = [](std::size_t i) {
      return task_of(i, 0, 12);
    }) {
  return run_census(plan, tasks, task, [](auto, auto) { return true; });
}

TEST(CensusTest, IsBitIdenticalForAnyNumberOfThreads) {
  constexpr std::size_t kTasks = kTasksPerBlock + 8;
  const auto task = [](std::size_t i) { return task_of(i, 0, 2); };
  const Census one = run(plan(1), kTasks, task);
  std::uint64_t wrong = 0;
  for (const int threads : {2, 3, 0}) {
    const Census other = run(plan(threads), kTasks, task);
    EXPECT_EQ(one.rays, other.rays);
    EXPECT_EQ(one.in_carrier, other.in_carrier);
    EXPECT_EQ(one.with_coincidence, other.with_coincidence);
    ASSERT_EQ(one.cells.size(), other.cells.size());
    for (std::size_t c = 0; c < one.cells.size(); ++c) {
      support::expect_equal_counts(one.cells[c], other.cells[c]);
      EXPECT_EQ(one.cells[c].wrong_length, other.cells[c].wrong_length);
      wrong += one.cells[c][Artifact::FirstWrong];
    }
  }
  EXPECT_GT(wrong, 100U);  // there is something to count
}

// Only the sum of lengths depends on how it is put together, in its last bits.
TEST(CensusTest, DoesNotDependOnHowRaysAreCutIntoTasks) {
  const Census whole = run(plan(1), 6);
  const Census parts =
      run(plan(1), 36, [](std::size_t i) { return task_of(i / 6, 2 * (i % 6), 2 * (i % 6) + 2); });
  EXPECT_EQ(whole.rays, parts.rays);
  EXPECT_EQ(whole.in_carrier, parts.in_carrier);
  EXPECT_EQ(whole.with_coincidence, parts.with_coincidence);
  for (std::size_t c = 0; c < whole.cells.size(); ++c) {
    support::expect_equal_counts(whole.cells[c], parts.cells[c]);
    EXPECT_NEAR(whole.cells[c].wrong_length, parts.cells[c].wrong_length,
                1e-12 * whole.cells[c].wrong_length);
  }
}

TEST(CensusTest, CountsEveryRayInEveryCell) {
  const Plan all = plan(1);
  const Census census = run(all, 3);
  EXPECT_EQ(census.rays, 36U);
  ASSERT_EQ(census.cells.size(), all.methods.size() * all.numbers.size());
  for (std::size_t c = 0; c < census.cells.size(); ++c) {
    EXPECT_EQ(census.cells[c].method, all.methods[c / all.numbers.size()].name);
    EXPECT_EQ(census.cells[c].number, all.numbers[c % all.numbers.size()].name);
    EXPECT_EQ(census.cells[c].significand_bits,
              all.numbers[c % all.numbers.size()].significand_bits);
    EXPECT_EQ(census.cells[c].rays + census.in_carrier, census.rays);
  }
}

// What is wrong with one method only accounts for the difference of what is wrong with each.
TEST(CensusTest, PairsAddUpToTheDifferenceOfTheirCells) {
  const Plan all = plan(1);
  const Census census = run(all, 8);
  const std::size_t methods = all.methods.size();
  ASSERT_EQ(census.pairs.size(), all.numbers.size() * methods * (methods - 1) / 2);
  const auto wrong = [&census](const std::string& method, const std::string& number) {
    for (const Cell& cell : census.cells) {
      if (cell.method == method && cell.number == number) {
        return static_cast<std::int64_t>(cell[Artifact::FirstWrong]);
      }
    }
    return std::int64_t{-1};
  };
  std::uint64_t differing = 0;
  for (const Pair& pair : census.pairs) {
    SCOPED_TRACE(pair.number + " " + pair.first + " " + pair.second);
    EXPECT_NE(pair.first, pair.second);
    EXPECT_EQ(static_cast<std::int64_t>(pair.only_first_wrong) -
                  static_cast<std::int64_t>(pair.only_second_wrong),
              wrong(pair.first, pair.number) - wrong(pair.second, pair.number));
    EXPECT_LE(pair.only_first_wrong + pair.only_second_wrong, census.rays - census.in_carrier);
    differing += pair.only_first_wrong + pair.only_second_wrong;
  }
  EXPECT_GE(differing, 20U);
}

TEST(CensusTest, BlocksOfTasksAddUpToTheWhole) {
  const Plan all = plan(1);
  const auto task = [](std::size_t i) { return task_of(i, 0, 6); };
  const Census whole = run(all, 6, task);
  Census sum = empty_census(all);
  sum.merge(run_tasks(all, 0, 2, task));
  sum.merge(run_tasks(all, 2, 5, task));
  sum.merge(run_tasks(all, 5, 6, task));
  EXPECT_EQ(sum.rays, 36U);
  EXPECT_EQ(sum.in_carrier, whole.in_carrier);
  EXPECT_EQ(sum.with_coincidence, whole.with_coincidence);
  for (std::size_t c = 0; c < whole.cells.size(); ++c) {
    support::expect_equal_counts(sum.cells[c], whole.cells[c]);
  }
  ASSERT_EQ(sum.pairs.size(), whole.pairs.size());
  for (std::size_t p = 0; p < whole.pairs.size(); ++p) {
    EXPECT_EQ(sum.pairs[p].only_first_wrong, whole.pairs[p].only_first_wrong);
    EXPECT_EQ(sum.pairs[p].only_second_wrong, whole.pairs[p].only_second_wrong);
  }
}

TEST(CensusTest, TheWorstCaseReplays) {
  const Plan all = plan(0);
  const Census census = run(all, 12);
  std::size_t replayed = 0;
  for (std::size_t c = 0; c < census.cells.size(); ++c) {
    const Cell& cell = census.cells[c];
    if (!cell.worst) {
      continue;
    }
    SCOPED_TRACE(cell.method + " " + cell.number);
    const WorstCase& worst = *cell.worst;
    Plan alone;
    alone.methods = {all.methods[c / all.numbers.size()]};
    alone.numbers = {all.numbers[c % all.numbers.size()]};
    const Census again = run(alone, 1, [&worst](std::size_t) {
      return Task{scene::open_scene(worst.scene), {worst.ray}};
    });
    ASSERT_TRUE(again.cells[0].worst);
    EXPECT_EQ(again.cells[0].worst->artifacts, worst.artifacts);
    EXPECT_EQ(again.cells[0].worst->wrong_length, worst.wrong_length);
    std::uint32_t kinds = 0;
    for (const std::uint64_t rays : again.cells[0].with) {
      kinds += static_cast<std::uint32_t>(rays);
    }
    EXPECT_EQ(kinds, worst.artifacts);
    ++replayed;
  }
  EXPECT_GE(replayed, 5U);
}

TEST(CensusTest, RaysInACarrierAreCountedApart) {
  const Census census = run(plan(1), 1, [](std::size_t) {
    // The second ray lies in the cube's face.
    return Task{support::scene_of("cube(2);"), {{{1, 1, 5}, {0, 0, -1}}, {{-1, 1, 2}, {1, 0, 0}}}};
  });
  EXPECT_EQ(census.rays, 2U);
  EXPECT_EQ(census.in_carrier, 1U);
  EXPECT_EQ(census.with_coincidence, 0U);
  for (const Cell& cell : census.cells) {
    EXPECT_EQ(cell.rays, 1U);
  }
}

TEST(CensusTest, CoincidenceBehindTheStartIsNotCounted) {
  const auto with_coincidence = [](const geometry::ExactRay& ray) {
    return run(plan(1), 1,
               [&ray](std::size_t) {
                 return Task{support::scene_of("add() { cube(2); cube(2); }"), {ray}};
               })
        .with_coincidence;
  };
  EXPECT_EQ(with_coincidence({{1, 1, 5}, {0, 0, -1}}), 1U);
  EXPECT_EQ(with_coincidence({{1, 1, 5}, {0, 0, 1}}), 0U);
}

// A slab of 1/2 within an epsilon of 1: missed with no rounding at all. One of 3 is not.
TEST(CensusTest, EpsilonHolesAreMissesOfExactArithmetic) {
  Plan only;
  only.methods = {method::parse_method("epsilon:1")};
  only.numbers = {trace::number_choice<double>(), trace::number_choice<number::exact>()};
  const Census census = run(only, 1, [](std::size_t) {
    return Task{support::scene_of("cube([9, 9, 1/2]); translate([0, 0, 10]) cube([9, 9, 3]);"),
                {{{1, 2, -5}, {0, 0, 2}}}};
  });
  for (const Cell& cell : census.cells) {
    EXPECT_EQ(cell[Artifact::EpsilonHole], 1U) << cell.number;
    EXPECT_EQ(cell[Artifact::MissedLogic], 1U) << cell.number;
    EXPECT_EQ(cell[Artifact::FirstWrong], 1U) << cell.number;
    EXPECT_EQ(cell.wrong_length, 0.5) << cell.number;
  }
}

TEST(CensusTest, StopsBetweenBlocksAndKeepsWhatIsDone) {
  Plan only;
  only.methods = {method::regularized()};
  only.numbers = {trace::number_choice<float>()};
  const auto task = [](std::size_t i) { return task_of(i % 3, 0, 1); };
  std::uint64_t done = 0;
  const Census stopped = run_census(only, 200, task, [&done](std::uint64_t d, std::uint64_t total) {
    EXPECT_EQ(total, 200U);
    done = d;
    return false;
  });
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(done, kTasksPerBlock);
  EXPECT_EQ(stopped.rays, done);
  // Refusing to go on after the last task stops nothing.
  EXPECT_FALSE(run_census(only, 2, task, [](auto, auto) { return false; }).interrupted);
}

TEST(CellTest, MergeAddsCountsAndKeepsTheWorst) {
  Verdict slight;
  slight[Artifact::Void] = 2;
  slight.wrong_length = 1;
  slight.persistence = 3;
  slight.lamina_fronts = 2;
  slight.lamina_fronts_seen = 1;
  slight.first_hit_measured = true;
  slight.first_hit = {5, 0.1, 0.2};
  Cell a;
  a.add(slight);
  a.worst = WorstCase{"one", {}, 1, 1};
  Cell b;
  b.add(Verdict{});
  b.add(slight);
  b.worst = WorstCase{"two", {}, 1, 2};
  a.merge(b);
  EXPECT_EQ(a.rays, 3U);
  EXPECT_EQ(a[Artifact::Void], 2U);  // rays, not voids
  EXPECT_EQ(a.wrong_length, 2);
  EXPECT_EQ(a.persistence, 3U);
  EXPECT_EQ(a.lamina_fronts, 4U);
  EXPECT_EQ(a.lamina_fronts_seen, 2U);
  EXPECT_EQ(a.largest.t_ulps, 5);
  EXPECT_EQ(a.worst->scene, "two");
  Cell equal;
  equal.worst = WorstCase{"three", {}, 1, 2};
  a.merge(equal);
  EXPECT_EQ(a.worst->scene, "two");  // the first of equals
}

}  // namespace
}  // namespace lamina::census
