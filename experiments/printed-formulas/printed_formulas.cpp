#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "census/solver_census.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/cell_summary.hpp"
#include "experiments/normal_angle.hpp"
#include "experiments/printed-formulas/capped_sweep.hpp"
#include "experiments/printed-formulas/printed_tests.hpp"
#include "experiments/random_sweep.hpp"

namespace lamina::experiments {
namespace {

using base::SeededStream;
using census::ErrorCounts;
using geometry::ContourKind;
using geometry::ExactRay;
using geometry::PlanePoint;
using number::Rational;
using surface::Sweep;
using surface::SweepMethod;
using surface::SweptSurface;

// What one way does in one number type.
struct Tally {
  std::map<std::string, std::uint64_t> counts;
  std::map<std::string, ErrorCounts> errors;

  void merge(const Tally& other) {
    for (const auto& [name, count] : other.counts) {
      counts[name] += count;
    }
    for (const auto& [name, of_name] : other.errors) {
      errors[name].merge(of_name);
    }
  }
};

// By number type, then by way, in the order of the lists; what no number type has a part in is that
// of the first.
using Tallies = std::map<std::pair<std::size_t, std::size_t>, Tally>;

struct Way {
  std::string name;
  SweepMethod method{};
};

// A row of one of the tables, but for number type and way.
struct Case {
  std::string formula;
  std::string sweep;
  std::string subject;  // contour or rays
  double parameter = 0;
  bool in_numbers = true;
  std::vector<Way> ways;
  std::function<void(const Settings&, const Case&, SeededStream&, Tallies&)> measure;
};

// --- Normals of conic sweeps --------------------------------------------------------------------

// The points of an ellipse; as a B-spline's, those of a circle give one that is all but round.
std::vector<PlanePoint> polygon(int count, double u_radius, double v_radius, double u_centre) {
  std::vector<PlanePoint> points;
  for (int i = 0; i < count; ++i) {
    // A square has its sides parallel to the axes.
    const double angle = 2 * std::numbers::pi * (i + 0.5) / count;
    const auto on_grid = [](double x) {
      constexpr int kDenominator = 1 << 20;
      return Rational(static_cast<std::int64_t>(std::lround(x * kDenominator)), kDenominator);
    };
    points.push_back(
        {on_grid(u_centre + u_radius * std::cos(angle)), on_grid(v_radius * std::sin(angle))});
  }
  return points;
}

SweptSurface conic(std::vector<PlanePoint> points, ContourKind kind) {
  return {Sweep::Conic, std::make_shared<const geometry::Contour>(std::move(points), kind, true)};
}

void measure_normals(const Settings& settings, const Case& of,
                     const std::optional<SweptSurface>& given, SeededStream& stream,
                     Tallies& tallies) {
  const SweptSurface surface =
      given ? *given : any_sweep(stream, Sweep::Conic, ContourKind::BSpline);
  const ExactRay ray = any_ray(stream, surface, {RayKind::From, 4});
  for (std::size_t n = 0; n < settings.plan.numbers.size(); ++n) {
    const trace::NumberChoice& number = settings.plan.numbers[n];
    const auto right = number.cross_sweep(surface, ray, {});
    const auto printed = number.cross_sweep(surface, ray, of.ways.front().method);
    Tally& tally = tallies[{n, 0}];
    tally.counts["rays"] += 1;
    for (std::size_t i = 0; i < right.size(); ++i) {
      const double degrees =
          angle_between(right[i].normal, printed[i].normal) * 180 / std::numbers::pi;
      tally.counts["normals"] += 1;
      tally.errors["angle"].add(degrees);
    }
  }
}

std::vector<Case> normal_cases() {
  const std::vector<std::pair<std::string, std::optional<SweptSurface>>> contours{
      {"circle", conic(polygon(16, 1, 1, 0), ContourKind::BSpline)},
      {"ellipse 2:1", conic(polygon(16, 1, 0.5, 0), ContourKind::BSpline)},
      {"ellipse 8:1", conic(polygon(16, 1, 0.125, 0), ContourKind::BSpline)},
      {"square", conic(polygon(4, 1, 1, 0), ContourKind::Line)},
      {"square, B-spline", conic(polygon(4, 1, 1, 0), ContourKind::BSpline)},
      {"circle, off by 1/2 radius", conic(polygon(16, 1, 1, 0.5), ContourKind::BSpline)},
      {"circle, off by 2 radii", conic(polygon(16, 1, 1, 2), ContourKind::BSpline)},
      {"random, B-spline", std::nullopt}};
  std::vector<Case> cases;
  for (const auto& [name, surface] : contours) {
    Way printed{"printed"};
    printed.method.printed.conic_normal = true;
    cases.push_back({"normal",
                     "conic",
                     name,
                     0,
                     true,
                     {printed},
                     [given = surface](const Settings& settings, const Case& of,
                                       SeededStream& stream, Tallies& tallies) {
                       measure_normals(settings, of, given, stream, tallies);
                     }});
  }
  return cases;
}

// --- Very small values ---------------------------------------------------------------------------

std::vector<poly::KnownRoot> known(const std::vector<SolidCrossing>& crossings, int bits) {
  std::vector<number::Root> roots;
  for (const SolidCrossing& crossing : crossings) {
    roots.push_back(crossing.t);
  }
  std::vector<poly::KnownRoot> all = poly::known(roots, bits);
  for (poly::KnownRoot& root : all) {
    root.multiplicity = 1;  // a crossing, whatever the eliminated polynomial has there
  }
  return all;
}

void measure_small_values(const Settings& settings, const Case& of, Sweep sweep,
                          const RayFamily& family, SeededStream& stream, Tallies& tallies) {
  const SweptSurface surface = any_sweep(stream, sweep, ContourKind::BSpline);
  const ExactRay ray = any_ray(stream, surface, family);
  const auto exact = solid_crossings(surface, ray);
  if (!exact) {
    return;
  }
  for (std::size_t n = 0; n < settings.plan.numbers.size(); ++n) {
    const trace::NumberChoice& number = settings.plan.numbers[n];
    const std::vector<poly::KnownRoot> truth = known(*exact, number.significand_bits);
    for (std::size_t w = 0; w < of.ways.size(); ++w) {
      poly::Solution solution;
      for (const auto& crossing : number.cross_sweep(surface, ray, of.ways[w].method)) {
        solution.roots.push_back({crossing.t, 1});
      }
      census::RootCounts counts;
      Tally& tally = tallies[{n, w}];
      for (const census::RootPair& pair : census::judge(solution, truth, counts)) {
        tally.errors["distance"].add(
            number::nearest_double(abs(solution.roots[pair.found].t - truth[pair.exact].t)));
      }
      tally.counts["rays"] += counts.polynomials;
      tally.counts["wrong_count"] += counts.wrong_count;
      tally.counts["wrong_parity"] += counts.wrong_parity;
      tally.counts["missed"] += counts.missed;
      tally.counts["spurious"] += counts.spurious;
      tally.errors["ulps"].merge(counts.ulps);
    }
  }
}

std::vector<Case> small_value_cases() {
  std::vector<Way> ways{{"own equations"}};
  ways.front().method.caps = SweepMethod::Caps::HalfSpaces;
  ways.push_back({"array"});
  ways.back().method.caps = SweepMethod::Caps::Parity;
  const std::vector<Way> exact_ways = ways;
  std::vector<Way> printed_ways{ways.front()};
  for (const double value : {1e-3, 1e-6, 1e-9, 1e-12}) {
    Way way{fmt::format("printed, {:.0e}", value)};
    way.method.caps = SweepMethod::Caps::Parity;
    way.method.printed.small_value = value;
    printed_ways.push_back(way);
  }
  std::vector<Case> cases;
  for (const Sweep sweep : {Sweep::Translational, Sweep::Conic, Sweep::Rotational}) {
    for (const RayKind kind : {RayKind::Along, RayKind::Level}) {
      if (sweep == Sweep::Conic && kind == RayKind::Along) {
        continue;  // as any other ray
      }
      for (const double parameter : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
        const RayFamily family{kind, parameter};
        cases.push_back({"small value", short_name(sweep), family.name(), parameter, true,
                         parameter == 0 ? printed_ways : exact_ways,
                         [sweep, family](const Settings& settings, const Case& of,
                                         SeededStream& stream, Tallies& tallies) {
                           measure_small_values(settings, of, sweep, family, stream, tallies);
                         }});
      }
    }
  }
  return cases;
}

// --- Rectangle test and equation 8 ---------------------------------------------------------------

void measure_rectangles(Sweep sweep, ContourKind kind, SeededStream& stream, Tallies& tallies) {
  const SweptSurface surface = any_sweep(stream, sweep, kind);
  const ExactRay ray = any_ray(stream, surface, {RayKind::From, 4});
  const SweptSurface::Crossings exact = surface.crossings(ray);
  const RayLine line = ray_line(sweep, ray);
  if (exact.in_boundary || line.is_level()) {
    return;
  }
  const auto boxes = surface.contour().boxes();
  for (const bool printed : {true, false}) {
    Tally& tally = tallies[{0, printed ? 0 : 1}];
    tally.counts["rays"] += 1;
    tally.counts["falling"] += line.falls() ? 1 : 0;
    std::set<std::uint32_t> crossed;
    std::uint64_t lost = 0;
    for (const SweptSurface::Crossing& crossing : exact.crossings) {
      crossed.insert(crossing.piece);
      lost += rules_out(line, boxes[crossing.piece], printed) ? 1 : 0;
    }
    for (const std::uint32_t piece : crossed) {
      tally.counts["pieces_lost"] += rules_out(line, boxes[piece], printed) ? 1 : 0;
    }
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      tally.counts["needless"] += !rules_out(line, boxes[i], printed) && !crossed.contains(i);
    }
    tally.counts["pieces_crossed"] += crossed.size();
    tally.counts["wrong_count"] += lost > 0 ? 1 : 0;
    tally.counts["wrong_parity"] += lost % 2;
  }
}

void measure_equation_8(ContourKind kind, SeededStream& stream, Tallies& tallies) {
  const SweptSurface surface = any_sweep(stream, Sweep::Rotational, kind);
  const ExactRay ray = any_ray(stream, surface, {RayKind::From, 4});
  const SweptSurface::Crossings exact = surface.crossings(ray);
  if (exact.in_boundary || ray.direction.z.is_zero()) {
    return;
  }
  std::vector<number::Root> roots;
  for (const SweptSurface::Crossing& crossing : exact.crossings) {
    roots.push_back(crossing.t);
  }
  std::vector<poly::KnownRoot> truth = poly::known(roots, 53);
  for (poly::KnownRoot& root : truth) {
    root.multiplicity = 1;
  }
  for (const bool printed : {true, false}) {
    poly::Solution solution;
    for (const Rational& t : rotational_crossings(surface, ray, printed)) {
      solution.roots.push_back({t, 1});
    }
    census::RootCounts counts;
    Tally& tally = tallies[{0, printed ? 0 : 1}];
    for (const census::RootPair& pair : census::judge(solution, truth, counts)) {
      tally.errors["distance"].add(
          number::nearest_double(abs(solution.roots[pair.found].t - truth[pair.exact].t)));
    }
    tally.counts["rays"] += 1;
    tally.counts["hits"] += truth.empty() ? 0 : 1;
    tally.counts["wrong_count"] += counts.wrong_count;
    tally.counts["wrong_parity"] += counts.wrong_parity;
  }
}

std::vector<Case> exact_cases() {
  std::vector<Case> cases;
  const std::vector<Way> ways{{"printed"}, {"right"}};
  for (const ContourKind kind : {ContourKind::Line, ContourKind::BSpline}) {
    const std::string contour(geometry::name_of(kind));
    for (const Sweep sweep : {Sweep::Translational, Sweep::Conic}) {
      cases.push_back(
          {"rectangle", short_name(sweep), contour, 0, false, ways,
           [sweep, kind](const Settings&, const Case&, SeededStream& stream, Tallies& tallies) {
             measure_rectangles(sweep, kind, stream, tallies);
           }});
    }
    cases.push_back({"equation 8", "rotational", contour, 0, false, ways,
                     [kind](const Settings&, const Case&, SeededStream& stream, Tallies& tallies) {
                       measure_equation_8(kind, stream, tallies);
                     }});
  }
  return cases;
}

// --- Caps by counting ----------------------------------------------------------------------------

// Where an ascending list enters and leaves, by turns; what is entered last and not left has no
// end.
std::vector<std::pair<double, double>> spans(const std::vector<double>& t) {
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < t.size(); i += 2) {
    all.emplace_back(t[i], i + 1 < t.size() ? t[i + 1] : std::numeric_limits<double>::infinity());
  }
  return all;
}

// The length of a's spans that b's do not cover.
double uncovered(const std::vector<double>& a, const std::vector<double>& b) {
  double length = 0;
  for (const auto& [from, to] : spans(a)) {
    length += to - from;
    for (const auto& [low, high] : spans(b)) {
      length -= std::max(0.0, std::min(to, high) - std::max(from, low));
    }
  }
  return length;
}

void measure_caps(const Settings& settings, const Case& of, Sweep sweep, bool with_loss,
                  SeededStream& stream, Tallies& tallies) {
  const SweptSurface surface = any_sweep(stream, sweep, ContourKind::BSpline);
  const ExactRay ray = any_ray(stream, surface, {RayKind::From, 4});
  const std::uint64_t lost = stream.bits();
  const auto exact = solid_crossings(surface, ray);
  // Without a crossing of the surface nothing can be lost.
  if (!exact || surface.crossings(ray).crossings.empty()) {
    return;
  }
  std::vector<double> truth;
  for (const SolidCrossing& crossing : *exact) {
    truth.push_back(nearest_double(crossing.t));
  }
  for (std::size_t n = 0; n < settings.plan.numbers.size(); ++n) {
    for (std::size_t w = 0; w < of.ways.size(); ++w) {
      SweepMethod method = of.ways[w].method;
      if (with_loss) {
        method.lost = lost;
      }
      std::vector<double> found;
      for (const auto& crossing : settings.plan.numbers[n].cross_sweep(surface, ray, method)) {
        found.push_back(number::nearest_double(crossing.t));
      }
      // Rounding moves a t that is below 8, by a slope below 1000, not as far, even in float: 8 *
      // 1000 * 2^-24 is 1/2097. What is farther off is another crossing.
      constexpr double kOther = 1.0 / 1024;
      const auto is_other = [](double a, double b) { return std::abs(a - b) > kOther; };
      Tally& tally = tallies[{n, w}];
      tally.counts["rays"] += 1;
      tally.counts["wrong_count"] += found.size() == truth.size() ? 0 : 1;
      tally.counts["wrong_parity"] += found.size() % 2 == truth.size() % 2 ? 0 : 1;
      const bool first_wrong = found.empty() != truth.empty() ||
                               (!found.empty() && is_other(found.front(), truth.front()));
      tally.counts["wrong_first"] += first_wrong ? 1 : 0;
      tally.counts["ghost"] += uncovered(found, truth) > kOther ? 1 : 0;
      tally.counts["void"] += uncovered(truth, found) > kOther ? 1 : 0;
    }
  }
}

std::vector<Case> cap_cases() {
  std::vector<Way> ways{{"array"}, {"half-spaces"}};
  ways[0].method.caps = SweepMethod::Caps::Parity;
  ways[1].method.caps = SweepMethod::Caps::HalfSpaces;
  std::vector<Case> cases;
  for (const Sweep sweep : {Sweep::Translational, Sweep::Conic}) {
    for (const bool with_loss : {false, true}) {
      cases.push_back({"caps", short_name(sweep), with_loss ? "one lost" : "none lost", 0, true,
                       ways,
                       [sweep, with_loss](const Settings& settings, const Case& of,
                                          SeededStream& stream, Tallies& tallies) {
                         measure_caps(settings, of, sweep, with_loss, stream, tallies);
                       }});
    }
  }
  return cases;
}

// --- Series and tables ---------------------------------------------------------------------------

std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (auto cases : {normal_cases(), small_value_cases(), exact_cases(), cap_cases()}) {
    std::move(cases.begin(), cases.end(), std::back_inserter(all));
  }
  return all;
}

std::string record_of(const Settings& settings, const Case& of, std::size_t first,
                      std::size_t last) {
  std::vector<Tallies> of_task(last - first);
  tbb::task_arena arena(settings.plan.threads > 0 ? settings.plan.threads
                                                  : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(first, last, [&](std::size_t task) {
      // Rays with and without a loss, as those by all ways, are the same.
      const std::string subject = of.formula == "caps" ? "caps" : of.subject;
      SeededStream stream(
          fmt::format("printed-formulas/{}/{}/{}/{}", of.formula, of.sweep, subject, of.parameter),
          settings.seed, task);
      of.measure(settings, of, stream, of_task[task - first]);
    });
  });
  Tallies tallies;
  for (const Tallies& of_one : of_task) {
    for (const auto& [key, tally] : of_one) {
      tallies[key].merge(tally);
    }
  }
  auto record = nlohmann::json::array();
  for (const auto& [key, tally] : tallies) {
    record.push_back({{"number", of.in_numbers ? settings.plan.numbers[key.first].name : "exact"},
                      {"way", of.ways[key.second].name},
                      {"counts", tally.counts},
                      {"errors", tally.errors}});
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
    one.labels = {of.formula, of.sweep, of.subject, of.parameter};
    one.plan = rounded.plan;
    one.tasks = settings.rays / cases.size();
    one.record = [rounded, of](std::size_t first, std::size_t last) {
      return record_of(rounded, of, first, last);
    };
    all.push_back(std::move(one));
  }
  return all;
}

void from_json(const nlohmann::json& json, Tally& tally) {
  json.at("counts").get_to(tally.counts);
  json.at("errors").get_to(tally.errors);
}

using Summaries = std::vector<Summary<Tally>>;

// A column and what it has of a tally.
struct Measured {
  report::Column column;
  std::function<report::Value(const Tally&)> value;
};

template <typename Map>
typename Map::mapped_type in(const Map& map, const std::string& name) {
  const auto found = map.find(name);
  return found == map.end() ? typename Map::mapped_type{} : found->second;
}

Measured rate(report::Column column, const std::string& of = "rays") {
  const std::string name = column.name;
  return {std::move(column), [name, of](const Tally& t) -> report::Value {
            return report::Rate{in(t.counts, name), in(t.counts, of)};
          }};
}

Measured count(report::Column column) {
  const std::string name = column.name;
  return {std::move(column),
          [name](const Tally& t) -> report::Value { return in(t.counts, name); }};
}

// The largest for part 1.
Measured error(report::Column column, const std::string& name, double part) {
  return {std::move(column), [name, part](const Tally& t) -> report::Value {
            const ErrorCounts errors = in(t.errors, name);
            return part < 1 || errors.size() == 0 ? errors.quantile(part) : errors.largest();
          }};
}

report::Table table_of(const Experiment& experiment, const Summaries& summaries,
                       const std::string& name, const std::string& formula,
                       const std::string& title, const std::vector<Measured>& measured) {
  std::vector<report::Column> columns;
  for (const Measured& m : measured) {
    columns.push_back(m.column);
  }
  report::Table table{name,
                      experiment.name + ": " + title,
                      cell_columns(experiment, {"way", "way", ""}, columns),
                      {},
                      {}};
  for (const Summary<Tally>& summary : summaries) {
    if (std::get<std::string>(summary.labels.front()) != formula) {
      continue;
    }
    for (std::size_t i = 0; i < summary.cells.size(); ++i) {
      std::vector<report::Value> row = row_of(summary, i);
      for (const Measured& m : measured) {
        row.push_back(m.value(summary.cells[i].second));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<LabelledRecords>& records) {
  const Summaries summaries = summaries_of<Tally>(records, "way");
  const report::Column rays{"rays", "rays", ""};
  const report::Column wrong_count{"wrong_count", "wrong count",
                                   "Rays with another number of crossings."};
  const report::Column wrong_parity{"wrong_parity", "wrong parity",
                                    "Odd in place of even, or the other way round."};
  report::Table normals = table_of(
      experiment, summaries, "normals", "normal", "the normal of a conic sweep",
      {count(rays), count({"normals", "normals", ""}),
       error({"largest_angle", "max angle", "Between printed and right normal, in degrees."},
             "angle", 1),
       error({"p99_angle", "p99 angle", "All quantiles to 19 %."}, "angle", 0.99),
       error({"median_angle", "median angle", ""}, "angle", 0.5)});
  report::Table small_values = table_of(
      experiment, summaries, "small-values", "small value", "very small values",
      {count(rays), rate(wrong_count), rate(wrong_parity),
       count({"missed", "missed", "Crossings, in all."}),
       count({"spurious", "spurious", "Crossings, in all."}),
       error({"largest_ulps", "max ulps", "Error of t, in units in the last place."}, "ulps", 1),
       error({"p99_ulps", "p99 ulps", "All quantiles to 19 %."}, "ulps", 0.99),
       error({"median_ulps", "median ulps", ""}, "ulps", 0.5),
       error({"largest_distance", "max distance",
              "Error of t, whose unit is the ray's direction; sweeps are some 2 wide."},
             "distance", 1)});
  small_values.notes = {
      "Translational and conic sweeps with their caps. A parameter of 0: exactly along the axis, "
      "or "
      "level; printed: with this very small value in place of the zero. Others are that near, and "
      "are left as they are by either way."};
  report::Table rectangles = table_of(
      experiment, summaries, "rectangles", "rectangle", "the rectangle test",
      {count(rays),
       count({"falling", "falling", "Rays with d_x d_y < 0, or what has its place in equation 6."}),
       count({"pieces_crossed", "pieces crossed", ""}),
       rate({"pieces_lost", "pieces lost", "Those of them that the test rules out."},
            "pieces_crossed"),
       rate(wrong_count), rate(wrong_parity),
       count({"needless", "needless", "Pieces that are not crossed and not ruled out."})});
  report::Table equation_8 = table_of(
      experiment, summaries, "equation-8", "equation 8", "equation 8",
      {count(rays), count({"hits", "hits", "Rays that cross the sweep."}), rate(wrong_count),
       rate(wrong_parity),
       error({"median_distance", "median distance", "Error of t; the directions have length 1."},
             "distance", 0.5),
       error({"largest_distance", "max distance", ""}, "distance", 1)});
  report::Table caps = table_of(
      experiment, summaries, "caps", "caps", "caps by counting",
      {count({"rays", "rays", "Those that cross the swept surface."}), rate(wrong_count),
       rate(wrong_parity),
       rate({"wrong_first", "wrong first", "Rays that see another crossing first, or none."}),
       rate({"ghost", "ghost", "Rays that are inside by mistake somewhere."}),
       rate({"void", "void", "Rays that are outside by mistake somewhere."})});
  return {normals, small_values, rectangles, equation_8, caps};
}

}  // namespace

Experiment printed_formulas() {
  return {.name = "printed-formulas",
          .question = "What do the formulas cost that van Wijk's paper has wrong in print?",
          .source = "van Wijk 1984, sections 3 to 5",
          .labels = {{"formula", "formula", ""},
                     {"sweep", "sweep", ""},
                     {"subject", "contour or rays", ""},
                     {"parameter", "parameter", "How near rays are to the axis, or to level."}},
          .default_rays = 21'500,
          .default_methods = "",
          .default_numbers = "float,double,longdouble,bin113",
          .series = series,
          .record_tables = tables};
}

}  // namespace lamina::experiments
