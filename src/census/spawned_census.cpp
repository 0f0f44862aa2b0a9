#include "census/spawned_census.hpp"

#include "census/path_truth.hpp"

namespace lamina::census {
namespace {

// One task, ray after ray, method after method.
class SpawnedRun {
 public:
  SpawnedRun(const Plan& plan, const Task& task)
      : plan_(plan),
        task_(task),
        census_(empty_census(plan)),
        truth_(task.scene),
        wrong_(plan.methods.size()) {
    for (const trace::NumberChoice& number : plan.numbers) {
      paths_.push_back(number.make_path ? number.make_path(task.scene, plan.solvers) : nullptr);
    }
  }

  Census run() {
    for (const geometry::ExactRay& ray : task_.rays) {
      ++census_.rays;
      truth_.start(ray);
      if (truth_.in_some_carrier()) {
        ++census_.in_carrier;
        continue;
      }
      census_.with_coincidence += truth_.first() != nullptr && truth_.first()->events > 1 ? 1 : 0;
      for (std::size_t n = 0; n < paths_.size(); ++n) {
        if (paths_[n] == nullptr) {
          continue;
        }
        for (std::size_t m = 0; m < plan_.methods.size(); ++m) {
          wrong_[m] = follow(ray, *paths_[n], plan_.methods[m],
                             census_.cells[m * plan_.numbers.size() + n]);
        }
        count_pairs(census_, n, wrong_);
      }
    }
    return std::move(census_);
  }

 private:
  // Counts one path. Returns whether its last ray's first interface is wrong, if it is judged.
  std::optional<bool> follow(const geometry::ExactRay& ray, trace::RayPath& path,
                             const method::Method& method, Cell& cell) {
    path.start(ray);
    path.run(method, report_);
    truth_.rewind();
    Verdict verdict = judge_first(truth_, path, report_);
    for (const trace::Spawn& spawn : task_.spawns) {
      const bool hits = truth_.first() != nullptr && spawns_at_truth(verdict);
      const auto direction = hits ? path.spawn(method, spawn) : std::nullopt;
      if (!direction) {
        ++cell.not_spawned;
        return std::nullopt;
      }
      if (!truth_.spawn(*direction)) {
        ++cell.undecided;
        return std::nullopt;
      }
      path.run(method, report_);
      verdict = judge_first(truth_, path, report_, range_of(spawn.branch));
    }
    cell.add(verdict);
    return verdict[Artifact::FirstWrong] > 0;
  }

  const Plan& plan_;
  const Task& task_;
  Census census_;
  PathTruth truth_;
  std::vector<std::unique_ptr<trace::RayPath>> paths_;  // by number type
  std::vector<std::optional<bool>> wrong_;              // by method, of the path last followed
  method::Report report_;
};

}  // namespace

Census run_spawned(const Plan& plan, const Task& task) { return SpawnedRun(plan, task).run(); }

}  // namespace lamina::census
