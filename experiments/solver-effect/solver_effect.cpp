#include <fmt/format.h>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"
#include "experiments/near-tangent/grazing.hpp"

namespace lamina::experiments {
namespace {

// At a random point of the scene's bounding box, from `distance` away.
Aim aim_from(double distance) {
  return {fmt::format("from {:g}", distance),
          [distance](const scene::FamilyMember&, const scene::Scene& scene,
                     base::SeededStream& stream) {
            const auto target = scene::point_in(*scene.bounds, stream);
            return scene::ray_from(target + distance * scene::random_direction(stream), target,
                                   scene::Held::Float);
          }};
}

std::vector<poly::Solver> compared(const Settings& settings) {
  std::vector<poly::Solver> solvers = settings.solvers;
  if (solvers.empty()) {
    for (const poly::SolverInfo& info : poly::all_solvers()) {
      solvers.push_back(info.solver);
    }
  }
  std::erase_if(solvers, [](poly::Solver solver) { return !poly::fits(solver, 4); });
  return solvers;
}

std::vector<Series> series(const Settings& settings) {
  std::vector<Subject> subjects;
  for (const std::string solid : {"ring", "cut-ring"}) {
    for (const double distance : {3.0, 1e3, 1e6}) {
      subjects.push_back({solid, "round:" + solid, aim_from(distance)});
    }
    Aim grazing = grazing_aim("ring", 10, 3);
    grazing.name = "grazing 1e-10";
    subjects.push_back({solid, "round:" + solid, grazing});
  }
  const std::vector<poly::Solver> solvers = compared(settings);
  const std::vector<std::string> forms{"as given", "recentred"};
  const std::uint64_t rays = settings.rays / (subjects.size() * forms.size() * solvers.size());
  std::vector<Series> all;
  for (const Subject& subject : subjects) {
    for (const std::string& form : forms) {
      for (const poly::Solver solver : solvers) {
        const std::string name(poly::solver_info(solver).name);
        Series one = family_series({subject.label, subject.aim.name, form, name}, subject.family,
                                   subject.aim, rays, settings);
        one.plan.solvers.quartic = solver;
        one.plan.solvers.recentring =
            form == forms.back() ? poly::Recentring::Tori : poly::Recentring::None;
        all.push_back(std::move(one));
      }
    }
  }
  return all;
}

// Replayed with the solver of the row.
std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  std::vector<report::LabelledCensus> replayed = counted;
  for (report::LabelledCensus& row : replayed) {
    const bool recentred = std::get<std::string>(row.labels[2]) == "recentred";
    row.options += fmt::format(" --recentred {} --solver {}", recentred ? "tori" : "none",
                               std::get<std::string>(row.labels.back()));
  }
  return {artifact_table(experiment, replayed)};
}

}  // namespace

Experiment solver_effect() {
  return {
      .name = "solver-effect",
      .question = "What does a root finder's miscount do to what is seen?",
      .source = "van Wijk 1984, sections 5 and 7; Wyvill and Trotman 1990, section 3.3",
      .labels = {{"scene", "scene",
                  "ring: a torus; cut-ring: half of it, in the groove of a ball less the torus."},
                 {"rays", "rays",
                  "From so far away at the bounding box; or so deep below the tangent plane."},
                 {"form", "polynomial",
                  "recentred: at the ray's point that is nearest to the torus' centre."},
                 {"solver", "solver", "Of quartics; see `lamina list solvers`."}},
      .default_rays = 35'200,
      .default_methods = "roth,regularized,wyvill-trotman,wyvill-trotman:parity",
      .default_numbers = "float,double",
      .compares_solvers = true,
      .series = series,
      .tables = tables};
}

}  // namespace lamina::experiments
