#include "census/census.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "census/order.hpp"
#include "census/spawned_census.hpp"
#include "trace/number_choice.hpp"

namespace lamina::census {

Census empty_census(const Plan& plan) {
  Census census;
  for (const method::Method& method : plan.methods) {
    for (const trace::NumberChoice& number : plan.numbers) {
      Cell cell;
      cell.method = method.name;
      cell.number = number.name;
      cell.significand_bits = number.significand_bits;
      census.cells.push_back(std::move(cell));
    }
  }
  for (const trace::NumberChoice& number : plan.numbers) {
    for (std::size_t a = 0; a < plan.methods.size(); ++a) {
      for (std::size_t b = a + 1; b < plan.methods.size(); ++b) {
        census.pairs.push_back({number.name, plan.methods[a].name, plan.methods[b].name});
      }
    }
  }
  return census;
}

namespace {

void note_worst(Cell& cell, const Verdict& verdict, const Task& task,
                const geometry::ExactRay& ray) {
  const auto kinds = static_cast<std::uint32_t>(
      std::count_if(verdict.count.begin(), verdict.count.end(), [](auto c) { return c > 0; }));
  if (kinds == 0 || (cell.worst && (kinds < cell.worst->artifacts ||
                                    (kinds == cell.worst->artifacts &&
                                     verdict.wrong_length <= cell.worst->wrong_length)))) {
    return;
  }
  cell.worst = WorstCase{task.scene.name, ray, kinds, verdict.wrong_length};
}

// Judges the rays of one task, one after the other.
class TaskRun {
 public:
  TaskRun(const Plan& plan, const Task& task)
      : plan_(plan),
        task_(task),
        census_(empty_census(plan)),
        truth_(task.scene),
        attribution_(task.scene, truth_, plan.methods, plan.numbers),
        orders_(task.scene, plan.random_orders),
        wrong_(plan.methods.size()),
        reports_(plan.methods.size()) {
    for (const trace::NumberChoice& number : plan.numbers) {
      auto tracer = number.make_tracer(task.scene, plan.solvers);
      const method::Tracer& made = *tracer;
      lanes_.push_back({std::move(tracer), Judge(truth_, made, task.scene.leaves.size())});
    }
  }

  Census run() {
    for (const geometry::ExactRay& ray : task_.rays) {
      ++census_.rays;
      truth_.find(ray);
      if (truth_.in_some_carrier()) {
        ++census_.in_carrier;
        continue;
      }
      const auto& classes = truth_.classes();
      census_.with_coincidence += std::any_of(classes.begin(), classes.end(),
                                              [](const auto& c) { return c.leaves.size() > 1; })
                                      ? 1
                                      : 0;
      attribution_.find(ray);
      for (std::size_t n = 0; n < lanes_.size(); ++n) {
        judge(ray, n);
      }
    }
    return std::move(census_);
  }

 private:
  // One number type of the scene.
  struct Lane {
    std::unique_ptr<method::Tracer> tracer;
    Judge judge;
  };

  void judge(const geometry::ExactRay& ray, std::size_t n) {
    Lane& lane = lanes_[n];
    const double direction_length =
        std::sqrt(number::nearest_double(dot(ray.direction, ray.direction)));
    lane.tracer->find(ray);
    lane.judge.match();
    for (std::size_t m = 0; m < plan_.methods.size(); ++m) {
      const method::Method& method = plan_.methods[m];
      lane.tracer->run(method, reports_[m]);
      Verdict verdict = lane.judge.judge(reports_[m], direction_length);
      if (verdict.missed() && method.grouping == method::Grouping::WithinEpsilon) {
        verdict[Artifact::EpsilonHole] =
            attribution_.missed_in_exact(m, lane.judge.reported_classes());
      }
      Cell& cell = cell_of(m, n);
      cell.add(verdict);
      wrong_[m] = verdict[Artifact::FirstWrong] > 0;
      if (*wrong_[m]) {
        ++cell.caused[static_cast<std::size_t>(attribution_.cause(m, n))];
      }
      note_worst(cell, verdict, task_, ray);
    }
    count_pairs(census_, n, wrong_);
    count_orders(*lane.tracer, n);
  }

  void count_orders(method::Tracer& tracer, std::size_t n) {
    const auto& outcomes = orders_.outcomes(tracer, plan_.methods, reports_);
    for (std::size_t m = 0; m < plan_.methods.size(); ++m) {
      Cell& cell = cell_of(m, n);
      cell.order_sensitive += outcomes[m] > 1 ? 1 : 0;
      cell.most_outcomes = std::max(cell.most_outcomes, outcomes[m]);
    }
  }

  Cell& cell_of(std::size_t m, std::size_t n) { return census_.cells[m * lanes_.size() + n]; }

  const Plan& plan_;
  const Task& task_;
  Census census_;
  Truth truth_;
  Attribution attribution_;
  OrderProbe orders_;
  std::vector<Lane> lanes_;
  std::vector<std::optional<bool>> wrong_;  // first interface, by method
  std::vector<method::Report> reports_;     // by method
};

}  // namespace

void count_pairs(Census& census, std::size_t number,
                 const std::vector<std::optional<bool>>& wrong) {
  auto pair = census.pairs.begin() +
              static_cast<std::ptrdiff_t>(number * wrong.size() * (wrong.size() - 1) / 2);
  for (std::size_t a = 0; a < wrong.size(); ++a) {
    for (std::size_t b = a + 1; b < wrong.size(); ++b, ++pair) {
      if (wrong[a] && wrong[b]) {
        pair->only_first_wrong += *wrong[a] && !*wrong[b] ? 1 : 0;
        pair->only_second_wrong += *wrong[b] && !*wrong[a] ? 1 : 0;
      }
    }
  }
}

void Cell::add(const Verdict& verdict) {
  ++rays;
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    with[a] += verdict.count[a] > 0 ? 1 : 0;
  }
  wrong_length += verdict.wrong_length;
  persistence = std::max(persistence, verdict.persistence);
  lamina_fronts += verdict.lamina_fronts;
  lamina_fronts_seen += verdict.lamina_fronts_seen;
  lamina_backs += verdict.lamina_backs;
  lamina_backs_seen += verdict.lamina_backs_seen;
  if (verdict.first_hit_measured) {
    largest.t_ulps = std::max(largest.t_ulps, verdict.first_hit.t_ulps);
    largest.point_rel = std::max(largest.point_rel, verdict.first_hit.point_rel);
    largest.normal_rad = std::max(largest.normal_rad, verdict.first_hit.normal_rad);
  }
}

void Cell::merge(const Cell& later) {
  rays += later.rays;
  not_spawned += later.not_spawned;
  undecided += later.undecided;
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    with[a] += later.with[a];
  }
  for (std::size_t c = 0; c < kCauseCount; ++c) {
    caused[c] += later.caused[c];
  }
  order_sensitive += later.order_sensitive;
  most_outcomes = std::max(most_outcomes, later.most_outcomes);
  wrong_length += later.wrong_length;
  persistence = std::max(persistence, later.persistence);
  lamina_fronts += later.lamina_fronts;
  lamina_fronts_seen += later.lamina_fronts_seen;
  lamina_backs += later.lamina_backs;
  lamina_backs_seen += later.lamina_backs_seen;
  largest.t_ulps = std::max(largest.t_ulps, later.largest.t_ulps);
  largest.point_rel = std::max(largest.point_rel, later.largest.point_rel);
  largest.normal_rad = std::max(largest.normal_rad, later.largest.normal_rad);
  if (later.worst && (!worst || later.worst->artifacts > worst->artifacts ||
                      (later.worst->artifacts == worst->artifacts &&
                       later.worst->wrong_length > worst->wrong_length))) {
    worst = later.worst;
  }
}

void Census::merge(const Census& later) {
  rays += later.rays;
  in_carrier += later.in_carrier;
  with_coincidence += later.with_coincidence;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    cells[c].merge(later.cells[c]);
  }
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    pairs[p].only_first_wrong += later.pairs[p].only_first_wrong;
    pairs[p].only_second_wrong += later.pairs[p].only_second_wrong;
  }
}

Census run_tasks(const Plan& plan, std::size_t first, std::size_t last, const TaskMaker& task) {
  std::optional<tbb::global_control> limit;
  if (plan.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, plan.threads);
  }
  std::vector<Census> parts(last - first);
  tbb::parallel_for(first, last, [&](std::size_t i) {
    const Task made = task(i);
    parts[i - first] = made.spawns.empty() ? TaskRun(plan, made).run() : run_spawned(plan, made);
  });
  Census census = empty_census(plan);
  for (const Census& part : parts) {
    census.merge(part);
  }
  return census;
}

Census run_census(const Plan& plan, std::size_t task_count, const TaskMaker& task,
                  const Progress& progress) {
  Census census = empty_census(plan);
  for (std::size_t first = 0; first < task_count; first += kTasksPerBlock) {
    const std::size_t last = std::min(first + kTasksPerBlock, task_count);
    census.merge(run_tasks(plan, first, last, task));
    if (!progress(last, task_count) && last < task_count) {
      census.interrupted = true;
      break;
    }
  }
  return census;
}

}  // namespace lamina::census
