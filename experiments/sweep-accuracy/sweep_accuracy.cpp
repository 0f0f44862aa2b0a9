#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "census/solver_census.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/cell_summary.hpp"
#include "experiments/normal_angle.hpp"
#include "experiments/random_sweep.hpp"

namespace lamina::experiments {
namespace {

using census::ErrorCounts;
using census::RootCounts;
using geometry::ContourKind;
using number::Rational;
using surface::Sweep;
using surface::SweptSurface;

// The rays of one row of the tables.
struct Case {
  std::optional<Sweep> sweep;  // none: a sphere sweep
  ContourKind contour = ContourKind::Line;
  RayFamily rays;

  [[nodiscard]] std::string name() const { return sweep ? short_name(*sweep) : "sphere"; }
  // Has it equations of degree 3, or 1, in the contour's parameter, and searches?
  [[nodiscard]] bool is_plainest() const {
    return sweep == Sweep::Translational || sweep == Sweep::Conic;
  }
};

constexpr std::array kContours{ContourKind::Line, ContourKind::BSpline, ContourKind::CatmullRom};

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const Sweep sweep :
       {Sweep::Translational, Sweep::Conic, Sweep::Rotational, Sweep::GeneralisedConic}) {
    std::vector<RayFamily> families{{RayKind::From, 4},           {RayKind::From, 1e3},
                                    {RayKind::From, 1e6},         {RayKind::Joint, 0},
                                    {RayKind::Grazing, 1e-3},     {RayKind::Grazing, 1e-6},
                                    {RayKind::Grazing, 1e-10, 53}};
    // A ray along the axis crosses no translational sweep, and none of these minds a level one.
    if (sweep != Sweep::Translational) {
      families.push_back({RayKind::Along, 0});
    }
    for (const double across : {1e-4, 1e-8}) {
      families.push_back({RayKind::Along, across});
    }
    if (sweep != Sweep::Translational) {
      for (const double axial : {0.0, 1e-8, 1e-4}) {
        families.push_back({RayKind::Level, axial});
      }
    }
    for (const ContourKind contour : kContours) {
      for (const RayFamily& rays : families) {
        all.push_back({sweep, contour, rays});
      }
    }
  }
  for (const ContourKind contour : kContours) {
    for (const double distance : {4.0, 1e3, 1e6}) {
      all.push_back({std::nullopt, contour, {RayKind::From, distance}});
    }
    for (const auto& [depth, bits] :
         {std::pair(1e-3, 24), std::pair(1e-6, 24), std::pair(1e-10, 53)}) {
      all.push_back({std::nullopt, contour, {RayKind::Grazing, depth, bits}});
    }
  }
  return all;
}

// One way to find the contour's parameter in one number type.
struct Cell {
  RootCounts t;
  ErrorCounts s;      // of piece + s, in units of roundoff
  ErrorCounts angle;  // of the normals, where the piece is right
  std::uint64_t other_piece = 0;
  double seconds = 0;

  void merge(const Cell& other) {
    t.merge(other.t);
    s.merge(other.s);
    angle.merge(other.angle);
    other_piece += other.other_piece;
    seconds += other.seconds;
  }
};

// By number type, then by way, in the order of the lists.
using Cells = std::map<std::pair<std::size_t, std::size_t>, Cell>;

struct Way {
  std::string name;
  surface::SweepMethod method;
};

std::vector<Way> ways_of(const Settings& settings, const Case& of) {
  std::vector<Way> ways;
  if (of.sweep && of.contour == ContourKind::Line) {
    // Of the first or the second degree, which have no choice.
    ways.push_back({"equation", {}});
  } else {
    std::vector<poly::Solver> solvers = settings.solvers;
    if (solvers.empty()) {
      for (const poly::SolverInfo& info : poly::all_solvers()) {
        // What it leaves open a sweep takes for no root at all.
        if (info.solver != poly::Solver::Certified) {
          solvers.push_back(info.solver);
        }
      }
    }
    for (const poly::Solver solver : solvers) {
      if (poly::fits(solver, of.is_plainest() ? 3 : 6)) {
        Way way{std::string(poly::solver_info(solver).name), {}};
        way.method.solvers.cubic = solver;
        if (poly::fits(solver, 6)) {
          way.method.solvers.sextic = solver;
        }
        ways.push_back(std::move(way));
      }
    }
  }
  if (!of.is_plainest() && of.sweep != Sweep::Rotational) {
    return ways;  // the ray has no image that the contour could be searched for
  }
  for (const auto search : {poly::SweepSearch::Subdivision, poly::SweepSearch::StripTree}) {
    Way way{std::string(poly::name_of(search)), {}};
    way.method.solvers.search = search;
    ways.push_back(std::move(way));
  }
  return ways;
}

// A ray and its exact crossings.
struct Trial {
  struct Crossing {
    Rational place;  // piece + s
    std::uint32_t piece = 0;
    geometry::ExactPoint normal;
  };

  surface::AnySweep surface;
  std::optional<Rational> around;  // of a closed contour: the number of pieces
  geometry::ExactRay ray;
  std::vector<number::Root> roots;
  std::vector<Crossing> crossings;
};

// Point and foot are then off by less than 2^-200, t, below 2^30, included: no unit of 113 bits
// shows that, nor the angle in double.
constexpr int kBits = 256;

geometry::ExactPoint point_at(const geometry::ExactRay& ray, const number::Root& t) {
  return ray.origin + enclosure(t, kBits).lower * ray.direction;
}

void add_crossings(const SweptSurface& surface, const SweptSurface::Crossings& found,
                   Trial& trial) {
  for (const SweptSurface::Crossing& crossing : found.crossings) {
    const geometry::ExactPoint point = point_at(trial.ray, crossing.t);
    const SweptSurface::Foot foot = surface.foot_near(point);
    trial.roots.push_back(crossing.t);
    trial.crossings.push_back(
        {Rational(foot.piece) + foot.s, foot.piece, surface.normal_at(point, foot)});
  }
}

void add_crossings(const surface::SphereSweep& surface,
                   const surface::SphereSweep::Crossings& found, Trial& trial) {
  for (const number::Root& t : found.t) {
    const geometry::ExactPoint point = point_at(trial.ray, t);
    const surface::SphereSweep::Foot foot = surface.foot_near(point);
    trial.roots.push_back(t);
    trial.crossings.push_back(
        {Rational(foot.piece) + foot.u, foot.piece,
         point - geometry::point_at(surface.trajectory().pieces()[foot.piece], foot.u)});
  }
}

// Nothing for a ray that runs along the surface.
template <typename Surface, typename Curve>
std::optional<Trial> trial_at(base::SeededStream& stream, const Surface& surface,
                              const Curve& curve, const RayFamily& rays) {
  Trial trial{surface, {}, any_ray(stream, surface, rays), {}, {}};
  if (curve.closed()) {
    trial.around = static_cast<unsigned>(curve.pieces().size());
  }
  const auto exact = surface.crossings(trial.ray);
  if (exact.in_boundary) {
    return std::nullopt;
  }
  add_crossings(surface, exact, trial);
  return trial;
}

std::optional<Trial> draw(const Settings& settings, const Case& of, std::size_t task) {
  base::SeededStream stream(
      fmt::format("sweep-accuracy/{}/{}/{}/{}", of.name(), geometry::name_of(of.contour),
                  of.rays.name(), of.rays.parameter),
      settings.seed, task);
  if (of.sweep) {
    const SweptSurface surface = any_sweep(stream, *of.sweep, of.contour);
    return trial_at(stream, surface, surface.contour(), of.rays);
  }
  const surface::SphereSweep surface = any_sphere_sweep(stream, of.contour);
  return trial_at(stream, surface, surface.trajectory(), of.rays);
}

// Of piece + s, around a closed contour the short way.
Rational contour_distance(const Trial& trial, const surface::FoundCrossing& found,
                          const Trial::Crossing& exact) {
  const Rational distance = abs(Rational(found.piece) + found.s - exact.place);
  return trial.around && 2 * distance > *trial.around ? Rational(*trial.around - distance)
                                                      : distance;
}

void judge(const Trial& trial, const trace::NumberChoice& number,
           const std::vector<poly::KnownRoot>& known, const Way& way, Cell& cell) {
  const std::vector<surface::FoundCrossing> found =
      number.cross_sweep(trial.surface, trial.ray, way.method);
  poly::Solution solution;
  for (const surface::FoundCrossing& crossing : found) {
    solution.roots.push_back({crossing.t, 1});
  }
  const double units = std::ldexp(1.0, number.significand_bits);
  for (const census::RootPair& pair : census::judge(solution, known, cell.t)) {
    const surface::FoundCrossing& is = found[pair.found];
    const Trial::Crossing& should_be = trial.crossings[pair.exact];
    cell.s.add(number::nearest_double(contour_distance(trial, is, should_be)) * units);
    if (is.piece == should_be.piece) {
      cell.angle.add(angle_between(is.normal, should_be.normal));
    } else {
      ++cell.other_piece;
    }
  }
}

std::string record_of(const Settings& settings, const Case& of, std::size_t first,
                      std::size_t last) {
  const std::vector<Way> ways = ways_of(settings, of);
  const std::vector<trace::NumberChoice>& numbers = settings.plan.numbers;
  std::vector<std::optional<Trial>> trials(last - first);
  std::vector<Cells> of_task(last - first);
  tbb::task_arena arena(settings.plan.threads > 0 ? settings.plan.threads
                                                  : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(first, last, [&](std::size_t task) {
      std::optional<Trial>& trial = trials[task - first];
      trial = draw(settings, of, task);
      for (std::size_t n = 0; trial && n < numbers.size(); ++n) {
        if (numbers[n].significand_bits < of.rays.held_bits) {
          continue;
        }
        std::vector<poly::KnownRoot> known = poly::known(trial->roots, numbers[n].significand_bits);
        for (poly::KnownRoot& root : known) {
          root.multiplicity = 1;  // a crossing, whatever the eliminated polynomial has there
        }
        for (std::size_t w = 0; w < ways.size(); ++w) {
          judge(*trial, numbers[n], known, ways[w], of_task[task - first][{n, w}]);
        }
      }
    });
  });
  Cells cells;
  for (const Cells& of_one : of_task) {
    for (const auto& [key, cell] : of_one) {
      cells[key].merge(cell);
    }
  }
  std::vector<surface::AnySweep> surfaces;
  std::vector<geometry::ExactRay> rays;
  for (const std::optional<Trial>& trial : trials) {
    if (trial) {
      surfaces.push_back(trial->surface);
      rays.push_back(trial->ray);
    }
  }
  for (auto& [key, cell] : cells) {
    const Way& way = ways[key.second];
    if (way.method.solvers.cubic != poly::Solver::Exact) {  // which nobody takes to be fast
      cell.seconds = numbers[key.first].seconds_to_cross(surfaces, rays, way.method);
    }
  }
  auto record = nlohmann::json::array();
  for (const auto& [key, cell] : cells) {
    record.push_back({{"number", numbers[key.first].name},
                      {"solver", ways[key.second].name},
                      {"t", cell.t},
                      {"s", cell.s},
                      {"angle", cell.angle},
                      {"other_piece", cell.other_piece},
                      {"seconds", cell.seconds}});
  }
  return record.dump();
}

std::vector<Series> series(const Settings& settings) {
  Settings rounded = settings;
  std::erase_if(rounded.plan.numbers, [](const trace::NumberChoice& n) { return !n.cross_sweep; });
  const std::vector<Case> cases = all_cases();
  std::vector<Series> all;
  for (const Case& of : cases) {
    Series one;
    one.labels = {of.name(), std::string(geometry::name_of(of.contour)), of.rays.name(),
                  of.rays.parameter};
    one.plan = rounded.plan;
    one.tasks = settings.rays / cases.size();
    one.record = [rounded, of](std::size_t first, std::size_t last) {
      return record_of(rounded, of, first, last);
    };
    all.push_back(std::move(one));
  }
  return all;
}

void from_json(const nlohmann::json& json, Cell& cell) {
  json.at("t").get_to(cell.t);
  json.at("s").get_to(cell.s);
  json.at("angle").get_to(cell.angle);
  json.at("other_piece").get_to(cell.other_piece);
  json.at("seconds").get_to(cell.seconds);
}

using Summaries = std::vector<Summary<Cell>>;

const report::Column kSolver{"solver", "solver",
                             "Or another search for the contour's parameter. Polygons have "
                             "equations of degree 1 or 2."};

double largest_of(const ErrorCounts& errors) {
  return errors.size() == 0 ? std::numeric_limits<double>::quiet_NaN() : errors.largest();
}

report::Table accuracy_table(const Experiment& experiment, const Summaries& summaries) {
  report::Table table{
      "accuracy",
      experiment.name,
      cell_columns(
          experiment, kSolver,
          {{"rays", "rays", "Those that run along the surface are left out."},
           {"wrong_count", "wrong count", "Rays with another number of crossings."},
           {"wrong_parity", "wrong parity", "Odd in place of even, or the other way round."},
           {"missed", "missed", "Crossings, in all."},
           {"spurious", "spurious", "Crossings, in all."},
           {"largest_ulps", "max ulps", "Error of t, in units in the last place."},
           {"p99_ulps", "p99 ulps", "All quantiles to 19 %."},
           {"median_ulps", "median ulps", ""},
           {"largest_s", "max s", "Error of the contour's parameter, in units of roundoff 2^-p."},
           {"median_s", "median s", ""},
           {"other_piece", "other piece", "Crossings that are put on another piece, in all."},
           {"largest_angle", "max angle",
            "Of the normal, in radians, where the piece is the right one."},
           {"median_angle", "median angle", ""}}),
      {},
      {"Against the exact crossings. Rays and contours are numbers of 24 bits, those of grazing "
       "rays at 1e-10 of 53: every number type has the same."}};
  for (const Summary<Cell>& summary : summaries) {
    for (std::size_t i = 0; i < summary.cells.size(); ++i) {
      const Cell& cell = summary.cells[i].second;
      const RootCounts& t = cell.t;
      std::vector<report::Value> row = row_of(summary, i);
      row.insert(row.end(), {t.polynomials, report::Rate{t.wrong_count, t.polynomials},
                             report::Rate{t.wrong_parity, t.polynomials}, t.missed, t.spurious,
                             largest_of(t.ulps), t.ulps.quantile(0.99), t.ulps.quantile(0.5),
                             largest_of(cell.s), cell.s.quantile(0.5), cell.other_piece,
                             largest_of(cell.angle), cell.angle.quantile(0.5)});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

report::Table times_table(const Experiment& experiment, const Summaries& summaries) {
  report::Table table{
      "times",
      experiment.name + ": time",
      cell_columns(experiment, kSolver,
                   {{"ns", "ns a ray", "By the clock, one pass, one thread."},
                    {"relative", "relative", "To the fastest of this number type."}}),
      {},
      {}};
  table.on_request = true;
  add_times(table, summaries, [](const Cell& cell) {
    return cell.seconds == 0
               ? std::nullopt
               : std::optional(cell.seconds / static_cast<double>(cell.t.polynomials));
  });
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<LabelledRecords>& records) {
  const Summaries summaries = summaries_of<Cell>(records, "solver");
  return {accuracy_table(experiment, summaries), times_table(experiment, summaries)};
}

}  // namespace

Experiment sweep_accuracy() {
  return {.name = "sweep-accuracy",
          .question = "How many crossings of a ray with a sweep are wrong, and by how much?",
          .source = "van Wijk 1984, sections 3 to 5 and 7",
          .labels = {{"sweep", "sweep", ""},
                     {"contour", "contour", ""},
                     {"family", "rays", "How they lie to the surface."},
                     {"parameter", "parameter", ""}},
          .default_rays = 3'240,
          .default_methods = "",
          .default_numbers = "float,double,longdouble,bin113",
          .compares_solvers = true,
          .series = series,
          .record_tables = tables};
}

}  // namespace lamina::experiments
