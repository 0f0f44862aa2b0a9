#include "census/spawned_census.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "census/spawned_truth.hpp"

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
    for (std::size_t i = 0; i < task.spawns.size(); ++i) {
      spawned_.emplace_back(task.scene);
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
      begin(ray);
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
  // The truth's first interface of the primary ray: where all paths spawn first.
  void begin(const geometry::ExactRay& ray) {
    const auto& classes = truth_.classes();
    const auto first = std::find_if(classes.begin(), classes.end(),
                                    [](const TruthClass& cls) { return cls.is_interface(); });
    first_direction_.reset();
    first_ = first == classes.end() ? nullptr : &*first;
    if (first_ != nullptr) {
      start_ = method::start_on(task_.scene, ray, truth_.t(*first_));
      coincident_ = events_of(truth_, *first_);
      census_.with_coincidence += coincident_.size() > 1 ? 1 : 0;
    }
  }

  // Is the first interface of the primary ray at the truth's?
  [[nodiscard]] bool hits_first(const trace::RayPath& path) const {
    if (first_ == nullptr || report_.interfaces.empty()) {
      return false;
    }
    const std::uint32_t said = report_.interfaces.front().crossing;
    const auto& crossings = truth_.crossings_of(path.crossings()[said].leaf);
    const auto distance = [&](const TruthCrossing& crossing) {
      return std::abs(nearest_double(truth_.crossings()[crossing.crossing].t) - path.t(said));
    };
    const auto nearest =
        std::min_element(crossings.begin(), crossings.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    return nearest != crossings.end() && nearest->cls == first_ - truth_.classes().data();
  }

  // The same of a spawned ray, by its verdict.
  static bool hits_there(const Verdict& verdict) {
    return verdict[Artifact::FirstWrong] == 0 || verdict[Artifact::WrongInterface] > 0 ||
           verdict[Artifact::GhostSurface] > 0;
  }

  // Counts one path. Returns whether its last ray's first interface is wrong, if it is judged.
  std::optional<bool> follow(const geometry::ExactRay& ray, trace::RayPath& path,
                             const method::Method& method, Cell& cell) {
    path.start(ray);
    path.run(method, report_);
    if (!hits_first(path)) {
      ++cell.not_spawned;
      return std::nullopt;
    }
    method::ExactStart start = start_;
    const std::vector<trace::CoincidentEvent>* coincident = &coincident_;
    for (std::size_t i = 0; i < task_.spawns.size(); ++i) {
      const trace::Spawn& spawn = task_.spawns[i];
      const auto direction = path.spawn(method, spawn, *coincident);
      if (!direction) {
        ++cell.not_spawned;
        return std::nullopt;
      }
      SpawnedTruth& truth = spawned_[i];
      if (!find(i, start, *direction)) {
        ++cell.undecided;
        return std::nullopt;
      }
      path.run(method, report_);
      const double range =
          spawn.branch == trace::Branch::Shadow ? 1 : std::numeric_limits<double>::infinity();
      const Verdict verdict = judge_spawned(truth, path, report_, range);
      if (i + 1 == task_.spawns.size()) {
        cell.add(verdict);
        return verdict[Artifact::FirstWrong] > 0;
      }
      const auto& classes = truth.classes();
      const auto next = std::find_if(classes.begin(), classes.end(),
                                     [](const auto& cls) { return cls.is_interface(); });
      if (next == classes.end() || !hits_there(verdict)) {
        ++cell.not_spawned;
        return std::nullopt;
      }
      const auto at = static_cast<std::size_t>(next - classes.begin());
      start = truth.start_on(at);
      coincident = &truth.events_of(at);
    }
    return std::nullopt;
  }

  // The truth of the spawned ray at a depth. All methods of a number type mostly spawn the same
  // first ray.
  bool find(std::size_t depth, const method::ExactStart& start,
            const geometry::ExactPoint& direction) {
    if (depth > 0) {
      return spawned_[depth].find(start, direction);
    }
    if (first_direction_ != direction) {
      first_direction_ = direction;
      first_is_decided_ = spawned_[0].find(start, direction);
    }
    return first_is_decided_;
  }

  const Plan& plan_;
  const Task& task_;
  Census census_;
  Truth truth_;
  std::vector<std::unique_ptr<trace::RayPath>> paths_;  // by number type
  std::vector<SpawnedTruth> spawned_;                   // by depth
  const TruthClass* first_ = nullptr;
  method::ExactStart start_;
  std::vector<trace::CoincidentEvent> coincident_;
  std::vector<std::optional<bool>> wrong_;               // by method, of the path last followed
  std::optional<geometry::ExactPoint> first_direction_;  // of the first spawned ray found last
  bool first_is_decided_ = false;
  method::Report report_;
};

}  // namespace

Census run_spawned(const Plan& plan, const Task& task) { return SpawnedRun(plan, task).run(); }

}  // namespace lamina::census
