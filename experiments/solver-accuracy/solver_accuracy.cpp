#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "census/solver_census.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/cell_summary.hpp"
#include "experiments/solver-accuracy/polynomials.hpp"

namespace lamina::experiments {
namespace {

using census::ErrorCounts;
using census::RootCounts;
using number::Rational;
using poly::KnownRoot;

// A root that was found, for the pictures.
struct Sample {
  double condition = 0;   // of the exact root: sum |c_i t^i| / |t p'(t)|
  double separation = 0;  // from the next exact root, relative to it
  double ulps = 0;
};

// One solver in one number type.
struct Cell {
  RootCounts held;             // against the exact roots of the coefficients as they are held
  RootCounts ideal;            // against those of the ideal polynomial
  ErrorCounts backward;        // |p(t)| / (u sum |c_i t^i|) at the roots found
  ErrorCounts condition;       // the error of a root relative to u times its condition number
  std::uint64_t not_held = 0;  // polynomials beyond the number type's range
  double seconds = 0;
  std::vector<Sample> samples;

  void merge(const Cell& other) {
    held.merge(other.held);
    ideal.merge(other.ideal);
    backward.merge(other.backward);
    condition.merge(other.condition);
    not_held += other.not_held;
    seconds += other.seconds;
    samples.insert(samples.end(), other.samples.begin(), other.samples.end());
  }
};

// By number type, then by solver, in the order of the lists; the scene solvers come last.
using Cells = std::map<std::pair<std::size_t, std::size_t>, Cell>;

nlohmann::json to_record(const Settings& settings, const std::vector<std::string>& solvers,
                         const Cells& cells) {
  auto record = nlohmann::json::array();
  for (const auto& [key, cell] : cells) {
    auto samples = nlohmann::json::array();
    for (const Sample& s : cell.samples) {
      samples.push_back({s.condition, s.separation, s.ulps});
    }
    record.push_back({{"number", settings.plan.numbers[key.first].name},
                      {"solver", solvers[key.second]},
                      {"held", cell.held},
                      {"ideal", cell.ideal},
                      {"backward", cell.backward},
                      {"condition", cell.condition},
                      {"not_held", cell.not_held},
                      {"seconds", cell.seconds},
                      {"samples", samples}});
  }
  return record;
}

// p(t) and the sums that errors are measured by, exact.
struct Evaluated {
  Rational value = 0;
  Rational terms = 0;          // sum |c_i t^i|
  Rational slope_times_t = 0;  // t p'(t)
};

Evaluated evaluate(const std::vector<Rational>& ascending, const Rational& t) {
  Evaluated at;
  Rational power = 1;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const Rational term = ascending[i] * power;
    at.value += term;
    at.terms += abs(term);
    at.slope_times_t += static_cast<unsigned>(i) * term;
    power *= t;
  }
  return at;
}

double ratio(const Rational& a, const Rational& b) {
  return b == 0 ? (a == 0 ? 0 : std::numeric_limits<double>::infinity())
                : number::nearest_double(abs(a / b));
}

// Distance from the next root relative to the root; 1 where there is none.
double separation(const std::vector<KnownRoot>& roots, std::size_t i) {
  double least = 1;
  for (const std::size_t other : {i - 1, i + 1}) {
    if (other < roots.size()) {
      least = std::min(least, ratio(roots[i].t - roots[other].t, roots[i].t));
    }
  }
  return least;
}

// What one polynomial adds to the cells of one number type.
class Trial {
 public:
  Trial(const Problem& problem, const trace::NumberChoice& number, HeldPolynomial held,
        const std::vector<number::Root>& ideal_roots)
      : number_(number), held_(std::move(held)), range_(problem.range) {
    if (range_.low) {
      *range_.low -= held_.shift;
      *range_.high -= held_.shift;
    }
    const bool is_zero = std::all_of(held_.ascending.begin(), held_.ascending.end(),
                                     [](const Rational& c) { return c == 0; });
    if (!is_zero) {
      truth_ = poly::known(poly::exact_roots(held_.ascending, range_), number.significand_bits);
    }
    ideal_ = poly::known(ideal_roots, number.significand_bits);
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const Evaluated at = evaluate(held_.ascending, truth_[i].t);
      conditions_.push_back(ratio(at.terms, at.slope_times_t));
    }
  }

  [[nodiscard]] const HeldPolynomial& held() const { return held_; }
  [[nodiscard]] const poly::ExactRange& range() const { return range_; }

  void run(poly::Solver solver, bool with_samples, Cell& cell) const {
    poly::Solution solution = number_.solve(held_.ascending, range_, solver);
    const double units = std::ldexp(1.0, number_.significand_bits);
    for (const census::RootPair& pair : judge(solution, truth_, cell.held)) {
      const double condition = conditions_[pair.exact];
      const bool simple = truth_[pair.exact].multiplicity == 1 && truth_[pair.exact].t != 0;
      if (simple) {
        cell.condition.add(pair.ulps / condition);
      }
      if (with_samples && simple) {
        cell.samples.push_back({condition, separation(truth_, pair.exact), pair.ulps});
      }
    }
    for (poly::Solution::Root& root : solution.roots) {
      const Evaluated at = evaluate(held_.ascending, root.t);
      cell.backward.add(ratio(at.value, at.terms) * units);
      root.t += held_.shift;
    }
    judge(solution, ideal_, cell.ideal);
  }

 private:
  const trace::NumberChoice& number_;
  HeldPolynomial held_;
  poly::ExactRange range_;
  std::vector<KnownRoot> truth_;
  std::vector<KnownRoot> ideal_;
  std::vector<double> conditions_;
};

std::vector<poly::Solver> chosen_solvers(const Settings& settings) {
  if (!settings.solvers.empty()) {
    return settings.solvers;
  }
  std::vector<poly::Solver> all;
  for (const poly::SolverInfo& info : poly::all_solvers()) {
    all.push_back(info.solver);
  }
  return all;
}

std::string record_of(const Settings& settings, const PolynomialFamily& family, std::size_t first,
                      std::size_t last) {
  const std::vector<poly::Solver> solvers = chosen_solvers(settings);
  constexpr std::size_t kMostSampled = 100;
  std::vector<Cells> of_task(last - first);
  std::vector<std::vector<std::optional<Trial>>> trials(last - first);
  tbb::task_arena arena(settings.plan.threads > 0 ? settings.plan.threads
                                                  : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(first, last, [&](std::size_t task) {
      base::SeededStream stream(
          fmt::format("polynomials/{}/{}/{}", family.name, family.parameter, family.degree),
          settings.seed, task);
      const Problem problem = family.draw(stream);
      const auto ideal = poly::exact_roots(problem.ideal, problem.range);
      for (std::size_t n = 0; n < settings.plan.numbers.size(); ++n) {
        const trace::NumberChoice& number = settings.plan.numbers[n];
        auto held = problem.hold(number.name);
        auto& trial = trials[task - first].emplace_back();
        if (held) {
          trial.emplace(problem, number, std::move(*held), ideal);
        }
        for (std::size_t s = 0; s < solvers.size(); ++s) {
          if (!poly::fits(solvers[s], family.degree)) {
            continue;
          }
          Cell& cell = of_task[task - first][{n, s}];
          if (trial) {
            trial->run(solvers[s], number.name == "double" && task < kMostSampled, cell);
          } else {
            ++cell.not_held;
          }
        }
        for (std::size_t s = 0; s < family.scene_solvers.size(); ++s) {
          const auto solution = problem.from_scene(family.scene_solvers[s], number.name);
          if (solution) {
            judge(*solution, poly::known(ideal, number.significand_bits),
                  of_task[task - first][{n, solvers.size() + s}].ideal);
          }
        }
      }
    });
  });
  Cells cells;
  for (std::size_t n = 0; n < settings.plan.numbers.size(); ++n) {
    std::vector<std::vector<Rational>> polynomials;
    std::vector<poly::ExactRange> ranges;
    for (const auto& of_one : trials) {
      if (of_one[n]) {
        polynomials.push_back(of_one[n]->held().ascending);
        ranges.push_back(of_one[n]->range());
      }
    }
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      if (poly::fits(solvers[s], family.degree)) {
        cells[{n, s}].seconds =
            settings.plan.numbers[n].seconds_to_solve(polynomials, ranges, solvers[s]);
      }
    }
  }
  for (const Cells& of_one : of_task) {
    for (const auto& [key, cell] : of_one) {
      cells[key].merge(cell);
    }
  }
  std::vector<std::string> names;
  for (const poly::Solver solver : solvers) {
    names.emplace_back(poly::solver_info(solver).name);
  }
  names.insert(names.end(), family.scene_solvers.begin(), family.scene_solvers.end());
  return to_record(settings, names, cells).dump();
}

std::vector<Series> series(const Settings& settings) {
  Settings rounded = settings;
  std::erase_if(rounded.plan.numbers, [](const trace::NumberChoice& n) { return !n.solve; });
  const auto& families = polynomial_families();
  std::vector<Series> all;
  for (const PolynomialFamily& family : families) {
    Series one;
    one.labels = {std::uint64_t(family.degree), family.name, family.parameter};
    one.plan = rounded.plan;
    one.tasks = settings.rays / families.size();
    one.record = [rounded, family](std::size_t first, std::size_t last) {
      return record_of(rounded, family, first, last);
    };
    all.push_back(std::move(one));
  }
  return all;
}

void from_json(const nlohmann::json& json, Cell& cell) {
  json.at("held").get_to(cell.held);
  json.at("ideal").get_to(cell.ideal);
  json.at("backward").get_to(cell.backward);
  json.at("condition").get_to(cell.condition);
  json.at("not_held").get_to(cell.not_held);
  json.at("seconds").get_to(cell.seconds);
  for (const auto& s : json.at("samples")) {
    const auto number = [&s](std::size_t i) {
      return s[i].is_null() ? std::numeric_limits<double>::infinity() : s[i].get<double>();
    };
    cell.samples.push_back({number(0), number(1), number(2)});
  }
}

using Summaries = std::vector<Summary<Cell>>;

const report::Column kSolver{"solver", "solver", ""};

report::Table accuracy_table(const Experiment& experiment, const Summaries& summaries, bool ideal) {
  report::Table table{
      ideal ? "ideal" : "accuracy",
      experiment.name + (ideal ? ": against the ideal polynomial" : ""),
      cell_columns(
          experiment, kSolver,
          {{"polynomials", "polynomials", ""},
           {"wrong_count", "wrong count",
            "Polynomials with another number of roots, each as often "
            "as it is multiple."},
           {"wrong_parity", "wrong parity", "Odd in place of even, or the other way round."},
           {"missed", "missed", "Roots, in all."},
           {"spurious", "spurious", "Roots, in all."},
           {"undecided", "undecided", "Polynomials that a certified solver leaves open."},
           {"largest_ulps", "max ulps", "Error of a root, in units in the last place."},
           {"p99_ulps", "p99 ulps", "All quantiles to 19 %."},
           {"median_ulps", "median ulps", ""},
           {"largest_bits", "max bits", "log2(1 + max ulps): the bits that are lost."}}),
      {},
      {}};
  if (ideal) {
    table.on_request = true;
    table.notes = {
        "The roots of the polynomial as it is meant, before its coefficients are "
        "rounded, or computed from a ray and a surface.",
        "haines, pbrt: ray and sphere by formulas of their own. certified-from-scene: intervals "
        "of doubles from the ray and the surface on; undecided where they cannot tell."};
  } else {
    table.columns.insert(
        table.columns.end(),
        {{"conditioned", "max ulps/condition",
          "Error in ulps divided by the root's condition number, sum |c_i t^i| / |t p'(t)|; "
          "simple roots."},
         {"backward", "max backward error",
          "|p(t)| / sum |c_i t^i| at the roots found, in units of roundoff."},
         {"not_held", "not held", "Polynomials beyond the range of the number type."}});
    table.notes = {"Against the exact roots of the coefficients as the number type holds them."};
  }
  for (const Summary<Cell>& summary : summaries) {
    for (std::size_t i = 0; i < summary.cells.size(); ++i) {
      const Cell& cell = summary.cells[i].second;
      const RootCounts& counts = ideal ? cell.ideal : cell.held;
      if (counts.polynomials + cell.not_held == 0) {
        continue;  // a scene solver: nothing is held
      }
      std::vector<report::Value> row = row_of(summary, i);
      const double largest = counts.ulps.size() == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                     : counts.ulps.largest();
      row.insert(row.end(),
                 {counts.polynomials, report::Rate{counts.wrong_count, counts.polynomials},
                  report::Rate{counts.wrong_parity, counts.polynomials}, counts.missed,
                  counts.spurious, report::Rate{counts.undecided, counts.polynomials}, largest,
                  counts.ulps.quantile(0.99), counts.ulps.quantile(0.5), std::log2(1 + largest)});
      if (!ideal) {
        row.insert(row.end(),
                   {cell.condition.quantile(1), cell.backward.quantile(1), cell.not_held});
      }
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
                   {{"ns", "ns a polynomial", "By the clock, one pass, one thread."},
                    {"relative", "relative", "To the fastest that fits, of this number type."}}),
      {},
      {}};
  table.on_request = true;
  add_times(table, summaries, [](const Cell& cell) {
    return cell.held.polynomials == 0
               ? std::nullopt
               : std::optional(cell.seconds / static_cast<double>(cell.held.polynomials));
  });
  return table;
}

report::Table samples_table(const Experiment& experiment, const Summaries& summaries) {
  report::Table table{"samples",
                      experiment.name + ": single roots in double",
                      cell_columns(experiment, kSolver,
                                   {{"condition", "condition", "sum |c_i t^i| / |t p'(t)|"},
                                    {"separation", "separation",
                                     "From the next exact root, relative to the root; 1 at most."},
                                    {"ulps", "ulps", "Error."}}),
                      {},
                      {"The simple roots of the first 100 polynomials of each family."}};
  table.on_request = true;
  for (const Summary<Cell>& summary : summaries) {
    for (std::size_t i = 0; i < summary.cells.size(); ++i) {
      for (const Sample& sample : summary.cells[i].second.samples) {
        std::vector<report::Value> row = row_of(summary, i);
        row.insert(row.end(), {sample.condition, sample.separation, sample.ulps});
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<LabelledRecords>& records) {
  const Summaries summaries = summaries_of<Cell>(records, "solver");
  return {accuracy_table(experiment, summaries, false), accuracy_table(experiment, summaries, true),
          times_table(experiment, summaries), samples_table(experiment, summaries)};
}

}  // namespace

Experiment solver_accuracy() {
  return {.name = "solver-accuracy",
          .question = "How many roots does a root finder get wrong, and by how much?",
          .source = "van Wijk 1984, sections 5 and 7",
          .labels = {{"degree", "degree", ""},
                     {"family", "family", "How the polynomials are made."},
                     {"parameter", "parameter", ""}},
          .default_rays = 10'000,
          .default_methods = "",
          .default_numbers = "float,double,longdouble,bin113",
          .compares_solvers = true,
          .series = series,
          .record_tables = tables};
}

}  // namespace lamina::experiments
