#include "census/census.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace lamina::census {
namespace {

Census empty_census(const Plan& plan) {
  Census census;
  for (const method::Method& method : plan.methods) {
    for (const method::NumberChoice& number : plan.numbers) {
      Cell cell;
      cell.method = method.name;
      cell.number = number.name;
      cell.significand_bits = number.significand_bits;
      census.cells.push_back(std::move(cell));
    }
  }
  return census;
}

// One number type of one scene.
struct Lane {
  std::unique_ptr<method::Tracer> tracer;
  Judge judge;
};

// Of the interfaces that the method missed, the number that it misses in exact arithmetic
// too: what an epsilon does wrong without any rounding.
class EpsilonHoles {
 public:
  explicit EpsilonHoles(const Task& task, const Truth& truth)
      : truth_(truth),
        tracer_(method::make_tracer<number::exact>(task.scene, {})),
        judge_(truth, *tracer_, task.scene.leaves.size()) {}

  std::uint32_t count(const method::Method& method, const geometry::ExactRay& ray,
                      const std::vector<bool>& reported) {
    tracer_->find(ray);
    tracer_->run(method, report_);
    judge_.match();
    static_cast<void>(judge_.judge(report_, 0));
    std::uint32_t holes = 0;
    for (std::size_t c = 0; c < reported.size(); ++c) {
      holes += truth_.classes()[c].is_interface() && !reported[c] && !judge_.reported_classes()[c]
                   ? 1
                   : 0;
    }
    return holes;
  }

 private:
  const Truth& truth_;
  std::unique_ptr<method::Tracer> tracer_;
  Judge judge_;
  method::Report report_;
};

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

Census run_task(const Plan& plan, const Task& task) {
  Census census = empty_census(plan);
  const std::size_t leaf_count = task.scene.leaves.size();
  Truth truth(task.scene);
  EpsilonHoles epsilon_holes(task, truth);
  std::vector<Lane> lanes;
  for (const method::NumberChoice& number : plan.numbers) {
    auto tracer = number.make_tracer(task.scene, plan.solvers);
    const method::Tracer& made = *tracer;
    lanes.push_back({std::move(tracer), Judge(truth, made, leaf_count)});
  }
  method::Report report;
  for (const geometry::ExactRay& ray : task.rays) {
    ++census.rays;
    truth.find(ray);
    if (truth.in_some_carrier()) {
      ++census.in_carrier;
      continue;
    }
    const auto& classes = truth.classes();
    census.with_coincidence += std::any_of(classes.begin(), classes.end(),
                                           [](const auto& cls) { return cls.leaves.size() > 1; })
                                   ? 1
                                   : 0;
    const double direction_length =
        std::sqrt(number::nearest_double(dot(ray.direction, ray.direction)));
    for (std::size_t n = 0; n < lanes.size(); ++n) {
      lanes[n].tracer->find(ray);
      lanes[n].judge.match();
      for (std::size_t m = 0; m < plan.methods.size(); ++m) {
        Cell& cell = census.cells[m * lanes.size() + n];
        lanes[n].tracer->run(plan.methods[m], report);
        Verdict verdict = lanes[n].judge.judge(report, direction_length);
        const bool missed = verdict[Artifact::MissedSolver] + verdict[Artifact::MissedLogic] +
                                verdict[Artifact::MissedRange] >
                            0;
        if (missed && plan.methods[m].grouping == method::Grouping::WithinEpsilon) {
          verdict[Artifact::EpsilonHole] =
              epsilon_holes.count(plan.methods[m], ray, lanes[n].judge.reported_classes());
        }
        cell.add(verdict);
        note_worst(cell, verdict, task, ray);
      }
    }
  }
  return census;
}

}  // namespace

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
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    with[a] += later.with[a];
  }
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
}

Census run_census(const Plan& plan, std::size_t task_count,
                  const std::function<Task(std::size_t)>& task, const Progress& progress) {
  std::optional<tbb::global_control> limit;
  if (plan.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, plan.threads);
  }
  // Batches bound the memory, and are where progress shows and a run can stop.
  constexpr std::size_t kBatch = 32;
  Census census = empty_census(plan);
  for (std::size_t first = 0; first < task_count; first += kBatch) {
    const std::size_t last = std::min(first + kBatch, task_count);
    std::vector<Census> parts(last - first);
    tbb::parallel_for(first, last,
                      [&](std::size_t i) { parts[i - first] = run_task(plan, task(i)); });
    for (const Census& part : parts) {
      census.merge(part);
    }
    if (!progress(last, task_count) && last < task_count) {
      census.interrupted = true;
      break;
    }
  }
  return census;
}

}  // namespace lamina::census
