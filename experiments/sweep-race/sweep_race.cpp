#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "census/truth.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/sweep-race/ideal_curves.hpp"
#include "experiments/sweep-race/profile_search.hpp"
#include "geometry/rounding.hpp"
#include "method/classify.hpp"
#include "scene/rays.hpp"

namespace lamina::experiments {
namespace {

using Rays = std::vector<geometry::Ray<double>>;

// Blocks of rays in a series. The interval of a median of 20 ratios goes from the 6th to the 15th.
constexpr std::size_t kBlocks = 20;
// Passes over a block, all entrants in turn; the least time counts, as all else is delay.
constexpr int kPasses = 3;
// Of a block's rays, so many are judged by the exact truth as well, which takes some ms a ray.
constexpr std::size_t kJudged = 20;

// What has to be as good as in the other representations.
struct Level {
  Measure measure;
  double limit;  // over the height, or in radians
};
constexpr std::array kLevels{Level{Measure::Distance, 1e-2}, Level{Measure::Distance, 1e-3},
                             Level{Measure::Distance, 1e-4}, Level{Measure::Angle, 0.1},
                             Level{Measure::Angle, 0.03},    Level{Measure::Angle, 0.01}};

// A representation and a way to trace it.
struct Entrant {
  Representation representation;
  std::string way;
  poly::Solvers solvers{};
};

std::vector<Entrant> entrants(const Settings& settings) {
  std::vector<poly::Solver> sextics = settings.solvers;
  if (sextics.empty()) {
    for (const poly::SolverInfo& info : poly::all_solvers()) {
      // `exact` takes some ms a ray, so that its time is that of exact arithmetic.
      if (info.solver != poly::Solver::Exact) {
        sextics.push_back(info.solver);
      }
    }
  }
  std::erase_if(sextics, [](poly::Solver solver) { return !poly::fits(solver, 6); });
  std::vector<Entrant> all;
  for (const Representation spline : {Representation::CatmullRom, Representation::BSpline}) {
    for (const poly::Solver solver : sextics) {
      all.push_back({spline, std::string(poly::solver_info(solver).name), {.sextic = solver}});
    }
    for (const auto search : {poly::SweepSearch::Subdivision, poly::SweepSearch::StripTree}) {
      all.push_back({spline, std::string(poly::name_of(search)), {.search = search}});
    }
  }
  all.push_back({Representation::Conics, "half-spaces"});
  all.push_back({Representation::Cones, "half-spaces"});
  return all;
}

// What has been found of an entrant: seconds by block, of the tracer and of the crossings alone.
// The latter only of those that no tracer has.
struct Found {
  std::string representation;
  std::string way;
  std::vector<double> whole{};
  std::vector<double> crossings{};
  std::uint64_t judged = 0;
  std::uint64_t first_wrong = 0;
  std::uint64_t wrong_count = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Found, representation, way, whole, crossings, judged,
                                   first_wrong, wrong_count)

struct FitSummary {
  std::string representation;
  std::uint64_t pieces = 0;
  std::uint64_t leaves = 0;
  double distance = 0;
  double angle_rad = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FitSummary, representation, pieces, leaves, distance, angle_rad)

// What one series has found.
struct Race {
  std::uint64_t rays = 0;  // of a block
  std::vector<FitSummary> fits{};
  std::vector<Found> found{};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Race, rays, fits, found)

// A way to run a block of rays, crossings alone or what is seen of them.
using Run = std::function<void(std::span<const geometry::Ray<double>>)>;

// Crossings and classification as a renderer has them: the buffers are kept.
class TracerRuns {
 public:
  TracerRuns(const scene::Scene& scene, const poly::Solvers& solvers)
      : scene_(scene), events_(scene, solvers), state_(scene.tree) {}

  void find(std::span<const geometry::Ray<double>> rays) {
    for (const auto& ray : rays) {
      events_.find(ray);
    }
  }
  void trace(std::span<const geometry::Ray<double>> rays) {
    for (const auto& ray : rays) {
      events_.find(ray);
      method::Classifier(scene_, events_, state_, report_, method::IgnoreEvents{})
          .run(method_, 0.0, 0.0);
    }
  }

 private:
  const scene::Scene& scene_;
  method::Method method_ = method::parse_method("regularized");
  method::RayEvents<double> events_;
  csg::RayState state_;
  method::Report report_;
};

// Of this thread alone: what else the machine does counts only by what it takes from the caches.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(const Run& run, const Rays& rays) {
  const double start = processor_seconds();
  run(rays);
  return processor_seconds() - start;
}

// The scenes of a level, by representation.
struct Scenes {
  std::array<const Fit*, kRepresentations.size()> fits{};

  Scenes(const IdealCurve& curve, const Level& level) {
    for (const Representation representation : kRepresentations) {
      const Fit& fit = least_fit(curve, representation, level.measure, level.limit);
      fits[static_cast<std::size_t>(representation)] = &fit;
    }
  }
  [[nodiscard]] const scene::Scene& operator[](Representation representation) const {
    return *fits[static_cast<std::size_t>(representation)]->scene;
  }
};

// Entrants, and then those that no tracer has: a spline's pieces in a list, and conics and arcs
// with rectangles and a tree of them.
class Field {
 public:
  Field(const Scenes& scenes, const std::vector<Entrant>& entrants) {
    for (const Entrant& entrant : entrants) {
      const auto& runs = tracers_.emplace_back(
          std::make_unique<TracerRuns>(scenes[entrant.representation], entrant.solvers));
      add(
          entrant, [&runs = *runs](auto rays) { runs.find(rays); },
          [&runs = *runs](auto rays) { runs.trace(rays); });
    }
    for (const Representation spline : {Representation::CatmullRom, Representation::BSpline}) {
      for (const bool each_piece : {false, true}) {
        for (const poly::Solver solver : {poly::Solver::Laguerre, poly::default_solver(6)}) {
          const auto sweep = std::make_shared<surface::RoundedSweep<double>>(
              *scenes[spline].leaves.front().surface.sweep,
              surface::AsPrinted{.each_piece = each_piece});
          const poly::Solvers solvers{.sextic = solver};
          add({spline,
               fmt::format("{} {}", poly::solver_info(solver).name, each_piece ? "list" : "tree"),
               solvers},
              [sweep, solvers,
               found = std::vector<surface::RoundedSweep<double>::Crossing>()](auto rays) mutable {
                for (const auto& ray : rays) {
                  sweep->find_crossings(ray, solvers, found);
                }
              },
              {});
        }
      }
    }
    const auto search = std::make_shared<ProfileSearch>(
        *scenes.fits[static_cast<std::size_t>(Representation::Conics)]->profile);
    add({Representation::Conics, "tree"},
        [search, found = std::vector<double>()](auto rays) mutable {
          for (const auto& ray : rays) {
            search->find_crossings(ray, {}, found);
          }
        },
        {});
  }

  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] const std::vector<Found>& names() const { return names_; }

  // The least of some passes over the rays, all members in turn.
  void run(const Rays& rays, std::vector<Found>& found) const {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      found[i].crossings.push_back(std::numeric_limits<double>::infinity());
      if (members_[i].trace) {
        found[i].whole.push_back(std::numeric_limits<double>::infinity());
      }
    }
    for (int pass = 0; pass < kPasses; ++pass) {
      for (std::size_t i = 0; i < members_.size(); ++i) {
        double& crossings = found[i].crossings.back();
        crossings = std::min(crossings, seconds_of(members_[i].find, rays));
        if (members_[i].trace) {
          double& whole = found[i].whole.back();
          whole = std::min(whole, seconds_of(members_[i].trace, rays));
        }
      }
    }
  }

 private:
  struct Member {
    Run find;
    Run trace;
  };

  void add(const Entrant& entrant, Run find, Run trace) {
    names_.push_back({std::string(name_of(entrant.representation)), entrant.way});
    members_.push_back({std::move(find), std::move(trace)});
  }

  std::vector<std::unique_ptr<TracerRuns>> tracers_;
  std::vector<Member> members_;
  std::vector<Found> names_;
};

// Around the ideal solid, a little wider than any fit.
scene::Bounds box_around(const IdealCurve& curve) {
  double radius = 0;
  for (const CurvePoint& p : curve.points) {
    radius = std::max(radius, p.u);
  }
  const number::Rational r(radius);
  return {{-r, -r, 0}, {r, r, number::Rational(curve.height)}};
}

std::vector<geometry::ExactRay> rays_of(const IdealCurve& curve, std::size_t count,
                                        std::uint64_t seed, std::size_t block) {
  base::SeededStream stream("sweep-race/" + curve.name, seed, block);
  return scene::uniform_rays(box_around(curve), count, stream);
}

Rays rounded(const std::vector<geometry::ExactRay>& exact) {
  Rays rays;
  for (const geometry::ExactRay& ray : exact) {
    rays.push_back(geometry::rounded<double>(ray));
  }
  return rays;
}

// Is the first interface the truth's? It is if the transitions are equal and no crossing of its
// leaf is nearer than one there. (census::Judge would measure its normal too, which takes most of
// the time in exact arithmetic.)
bool first_right(const census::Truth& truth, const method::Tracer& tracer,
                 const method::Report& report) {
  const auto& classes = truth.classes();
  const auto first = std::find_if(classes.begin(), classes.end(),
                                  [](const auto& cls) { return cls.is_interface(); });
  if (first == classes.end() || report.interfaces.empty()) {
    return first == classes.end() && report.interfaces.empty();
  }
  const method::Interface& seen = report.interfaces.front();
  if (seen.transition != first->effect.transition) {
    return false;
  }
  const double t = tracer.t(seen.crossing);
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const census::TruthCrossing& crossing :
       truth.crossings_of(tracer.crossings()[seen.crossing].leaf)) {
    // Its lower bound is a few ulps off at most.
    const double off = std::abs(truth.crossings()[crossing.crossing].t.lower() - t);
    if (off < least) {
      least = off;
      nearest = crossing.cls;
    }
  }
  return nearest == first - classes.begin();
}

// Is each leaf crossed as often as it should be?
bool counts_right(const census::Truth& truth, const method::Tracer& tracer, std::size_t leaves) {
  std::vector<std::size_t> counts(leaves);
  for (const method::CrossingId& crossing : tracer.crossings()) {
    ++counts[crossing.leaf];
  }
  for (csg::LeafIndex leaf = 0; leaf < leaves; ++leaf) {
    if (counts[leaf] != truth.crossings_of(leaf).size()) {
      return false;
    }
  }
  return true;
}

// What each entrant sees of some rays, against the truth of its own scene.
void judge(const Scenes& scenes, const std::vector<Entrant>& entrants,
           std::span<const geometry::ExactRay> rays, std::vector<Found>& found) {
  const method::Method method = method::parse_method("regularized");
  method::Report report;
  for (const Representation representation : kRepresentations) {
    const scene::Scene& scene = scenes[representation];
    census::Truth truth(scene);
    std::vector<std::pair<std::size_t, std::unique_ptr<method::Tracer>>> tracers;
    for (std::size_t i = 0; i < entrants.size(); ++i) {
      if (entrants[i].representation == representation) {
        tracers.emplace_back(i, method::make_tracer<double>(scene, entrants[i].solvers));
      }
    }
    for (const geometry::ExactRay& ray : rays) {
      truth.find(ray);
      if (truth.in_some_carrier()) {
        continue;
      }
      for (const auto& [place, tracer] : tracers) {
        tracer->find(ray);
        tracer->run(method, report);
        Found& of = found[place];
        ++of.judged;
        of.first_wrong += first_right(truth, *tracer, report) ? 0U : 1U;
        of.wrong_count += counts_right(truth, *tracer, scene.leaves.size()) ? 0U : 1U;
      }
    }
  }
}

std::string record_of(const Settings& settings, const IdealCurve& curve, const Level& level,
                      std::size_t rays_of_block, std::size_t first, std::size_t last) {
  const std::vector<Entrant> all = entrants(settings);
  const Scenes scenes(curve, level);
  const Field field(scenes, all);
  Race race{rays_of_block};
  for (const Representation representation : kRepresentations) {
    const Fit& fit = *scenes.fits[static_cast<std::size_t>(representation)];
    race.fits.push_back({std::string(name_of(representation)), fit.pieces,
                         scenes[representation].leaves.size(), fit.distance, fit.angle_rad});
  }
  race.found = field.names();

  // A few blocks together, since each time all scenes are rounded anew.
  constexpr std::size_t kTogether = 5;
  const std::size_t parts = (last - first + kTogether - 1) / kTogether;
  std::vector<std::vector<Found>> judged(parts, std::vector<Found>(all.size()));
  tbb::task_arena arena(settings.plan.threads > 0 ? settings.plan.threads
                                                  : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      std::vector<geometry::ExactRay> rays;
      const std::size_t begin = first + part * kTogether;
      for (std::size_t block = begin; block < std::min(begin + kTogether, last); ++block) {
        const auto more = rays_of(curve, std::min(kJudged, rays_of_block), settings.seed, block);
        rays.insert(rays.end(), more.begin(), more.end());
      }
      judge(scenes, all, rays, judged[part]);
    });
  });
  for (const std::vector<Found>& of_part : judged) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      race.found[i].judged += of_part[i].judged;
      race.found[i].first_wrong += of_part[i].first_wrong;
      race.found[i].wrong_count += of_part[i].wrong_count;
    }
  }
  // One thread, nothing beside it.
  for (std::size_t block = first; block < last; ++block) {
    field.run(rounded(rays_of(curve, rays_of_block, settings.seed, block)), race.found);
  }
  return nlohmann::json(race).dump();
}

std::string name_of(Measure measure) {
  return measure == Measure::Distance ? "distance" : "normal";
}

std::vector<Series> series(const Settings& settings) {
  std::vector<Series> all;
  const std::size_t of_series = settings.rays / (kLevels.size() * ideal_curves().size());
  const std::size_t of_block = std::max<std::size_t>(1, of_series / kBlocks);
  for (const IdealCurve& curve : ideal_curves()) {
    for (const Level& level : kLevels) {
      Series one;
      one.labels = {curve.name, name_of(level.measure), level.limit};
      one.plan = settings.plan;
      one.tasks = std::min(kBlocks, of_series);
      one.record = [settings, &curve, level, of_block](std::size_t first, std::size_t last) {
        return record_of(settings, curve, level, of_block, first, last);
      };
      all.push_back(std::move(one));
    }
  }
  return all;
}

Race race_of(const LabelledRecords& records) {
  Race race;
  for (const std::string& record : records.records) {
    const auto more = nlohmann::json::parse(record).get<Race>();
    if (race.found.empty()) {
      race = more;
      continue;
    }
    for (std::size_t i = 0; i < race.found.size(); ++i) {
      Found& into = race.found[i];
      const Found& from = more.found[i];
      into.whole.insert(into.whole.end(), from.whole.begin(), from.whole.end());
      into.crossings.insert(into.crossings.end(), from.crossings.begin(), from.crossings.end());
      into.judged += from.judged;
      into.first_wrong += from.first_wrong;
      into.wrong_count += from.wrong_count;
    }
  }
  return race;
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

struct Ratio {
  double median = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

// The median over blocks of the ratio of two times of one block, with an interval of 95 % at least
// whatever the ratios' distribution: the true median lies outside of the k-th smallest and greatest
// of n with the probability that fewer than k of n throws of a coin, or more than n - k, are heads.
Ratio ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ratios.push_back(a[i] / b[i]);
  }
  Ratio result{median(ratios)};
  std::sort(ratios.begin(), ratios.end());
  const boost::math::binomial_distribution<> heads(static_cast<double>(ratios.size()), 0.5);
  for (std::size_t k = 1; 2 * k <= ratios.size(); ++k) {
    if (2 * cdf(heads, static_cast<double>(k - 1)) > 0.05) {
      break;
    }
    result.low = ratios[k - 1];
    result.high = ratios[ratios.size() - k];
  }
  return result;
}

const Found& find(const Race& race, std::string_view representation, std::string_view way) {
  return *std::find_if(race.found.begin(), race.found.end(), [&](const Found& found) {
    return found.representation == representation && found.way == way;
  });
}

std::vector<report::Column> columns_of(const Experiment& experiment,
                                       const std::vector<report::Column>& more) {
  std::vector<report::Column> columns = experiment.labels;
  columns.insert(columns.end(), {{"representation", "as", ""}, {"way", "by", ""}});
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

std::vector<report::Value> row_of(const LabelledRecords& records, const Found& found) {
  std::vector<report::Value> row;
  for (const census::Label& label : records.labels) {
    row.push_back(report::value_of(label));
  }
  row.emplace_back(found.representation);
  row.emplace_back(found.way);
  return row;
}

void add(std::vector<report::Value>& row, const Ratio& ratio) {
  row.insert(row.end(), {ratio.median, ratio.low, ratio.high});
}

report::Table fit_table(const Experiment& experiment, const std::vector<LabelledRecords>& records) {
  report::Table table{"fits",
                      experiment.name + ": how many pieces it takes",
                      experiment.labels,
                      {},
                      {"Points at equal steps of one measure for all representations."}};
  table.columns.insert(
      table.columns.end(),
      {{"representation", "as",
        "catmull_rom, bspline: van Wijk's sweep; conics: Hashimoto and Suenaga; cones: Horiuchi."},
       {"pieces", "pieces", ""},
       {"leaves", "leaves", "Half-spaces of the scene."},
       {"distance", "max distance", "From one curve to the other, over the height."},
       {"angle_rad", "max angle", "Between the normals, in radians."}});
  for (const LabelledRecords& of_series : records) {
    for (const FitSummary& fit : race_of(of_series).fits) {
      std::vector<report::Value> row;
      for (const census::Label& label : of_series.labels) {
        row.push_back(report::value_of(label));
      }
      row.insert(row.end(),
                 {fit.representation, fit.pieces, fit.leaves, fit.distance, fit.angle_rad});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

report::Table race_table(const Experiment& experiment,
                         const std::vector<LabelledRecords>& records) {
  report::Table table{
      "race",
      experiment.name + ": the whole tracer",
      columns_of(experiment,
                 {{"ns", "ns a ray",
                   "The median of the blocks, in the time of one thread on its processor."},
                  {"to_conics", "time / conics'",
                   "The median over blocks of the ratio of the times in a block."},
                  {"to_conics_low", "from", "95 % interval of that median."},
                  {"to_conics_high", "to", ""},
                  {"to_fastest", "time / fastest", "Likewise, to the least of the column ns."},
                  {"to_fastest_low", "from", ""},
                  {"to_fastest_high", "to", ""},
                  {"first_wrong", "first wrong",
                   "Rays whose first interface is not that of the same solid in exact arithmetic."},
                  {"wrong_count", "wrong count",
                   "Rays that cross some leaf another number of times than in exact arithmetic."}}),
      {},
      {"`regularized` in `double`: crossings, sorted, and what is seen. Solvers are of sextics."}};
  for (const LabelledRecords& of_series : records) {
    const Race race = race_of(of_series);
    if (race.found.empty()) {
      continue;
    }
    const Found& conics = find(race, "conics", "half-spaces");
    const Found* fastest = &conics;
    for (const Found& found : race.found) {
      if (!found.whole.empty() && median(found.whole) < median(fastest->whole)) {
        fastest = &found;
      }
    }
    for (const Found& found : race.found) {
      if (found.whole.empty()) {
        continue;
      }
      std::vector<report::Value> row = row_of(of_series, found);
      row.emplace_back(1e9 * median(found.whole) / static_cast<double>(race.rays));
      add(row, ratio(found.whole, conics.whole));
      add(row, ratio(found.whole, fastest->whole));
      row.emplace_back(report::Rate{found.first_wrong, found.judged});
      row.emplace_back(report::Rate{found.wrong_count, found.judged});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

report::Table crossings_table(const Experiment& experiment,
                              const std::vector<LabelledRecords>& records) {
  report::Table table{
      "crossings",
      experiment.name + ": the crossings alone",
      columns_of(experiment,
                 {{"ns", "ns a ray",
                   "The median of the blocks, in the time of one thread on its processor."},
                  {"to_conics", "time / conics'",
                   "To that of conics by half-spaces: the median over blocks of the ratio."},
                  {"to_conics_low", "from", "95 % interval of that median."},
                  {"to_conics_high", "to", ""},
                  {"to_bounded", "time / bounded conics'",
                   "To that of conics by the tree of their rectangles."},
                  {"to_bounded_low", "from", ""},
                  {"to_bounded_high", "to", ""}}),
      {},
      {"tree, list: without the normals and the order along the ray; the rectangles of the pieces "
       "are in a tree, or tested one after the other, as van Wijk has them."}};
  table.on_request = true;
  for (const LabelledRecords& of_series : records) {
    const Race race = race_of(of_series);
    if (race.found.empty()) {
      continue;
    }
    for (const Found& found : race.found) {
      std::vector<report::Value> row = row_of(of_series, found);
      row.emplace_back(1e9 * median(found.crossings) / static_cast<double>(race.rays));
      add(row, ratio(found.crossings, find(race, "conics", "half-spaces").crossings));
      add(row, ratio(found.crossings, find(race, "conics", "tree").crossings));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<LabelledRecords>& records) {
  return {fit_table(experiment, records), race_table(experiment, records),
          crossings_table(experiment, records)};
}

}  // namespace

Experiment sweep_race() {
  return {.name = "sweep-race",
          .question =
              "Are quadrics and a torus twenty times faster than a swept cubic spline, "
              "where both are as good?",
          .source = "Hashimoto and Suenaga, section 4; van Wijk 1984, sections 5 and 7",
          .labels = {{"shape", "shape", "vase: a solid; glass: with a wall and a round rim."},
                     {"equal", "equal", "What is not above the limit, by as few points as can be."},
                     {"limit", "limit", "Distances over the height, normals in radians."}},
          .default_rays = 24'000,
          .default_methods = "",
          .default_numbers = "double",
          .compares_solvers = true,
          .series = series,
          .record_tables = tables};
}

}  // namespace lamina::experiments
