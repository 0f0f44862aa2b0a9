#include <fmt/format.h>

#include <cmath>

#include "census/statistics.hpp"
#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

constexpr double kCurvature = 1 / 1.5 - 1 / 2.0;  // of one surface against the other

double tolerance_of(const std::string& text) {
  return number::nearest_double(number::parse_rational(text));
}

// Where the wall is as thin as epsilon: thickness is kappa rho^2 / 2 at the distance rho.
double hole_radius(double epsilon) { return std::sqrt(2 * epsilon / kCurvature); }

double disc_radius(double epsilon) { return 2 * hole_radius(epsilon); }

// Along the axis, through a disc around the point where the spheres touch.
DrawRay along_the_axis(double radius) {
  return [radius](const scene::FamilyMember& member, const scene::Scene&,
                  base::SeededStream& stream) {
    const double rho = radius * std::sqrt(stream.unit());
    const double phi = stream.uniform(0, 2 * M_PI);
    const double x = rho * std::cos(phi);
    const double y = rho * std::sin(phi);
    return scene::ray_from(member.place({x, y, 10}), member.place({x, y, 2}), scene::Held::Double);
  };
}

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> tolerances{"1e-2", "1e-3",  "1e-4", "1e-6",
                                            "1e-8", "1e-10", "1e-12"};
  std::vector<Series> all;
  for (const std::string& tolerance : tolerances) {
    const DrawRay draw = along_the_axis(disc_radius(tolerance_of(tolerance)));
    Series one = family_series({tolerance}, "thin-wall", {"thin-wall/" + tolerance, draw},
                               settings.rays / tolerances.size(), settings);
    one.plan.methods = with_epsilon(settings.plan.methods, tolerance);
    all.push_back(std::move(one));
  }
  return all;
}

// The rays are uniform in a disc, so the part of them that is lost gives the hole's radius.
report::Table hole_table(const std::vector<report::LabelledCensus>& counted) {
  report::Table table{
      "holes",
      "thin-wall: radius of the hole",
      {{"epsilon", "epsilon", "A length."},
       {"number", "number", ""},
       {"closed_form", "closed form",
        "sqrt(2 epsilon / kappa), kappa = 1/6 the curvature of one surface against the other."},
       {"measured", "measured",
        "From the part of the rays that the method loses, which go uniformly through a disc of "
        "twice that radius."},
       {"lower", "lower", "95 % bounds of it."},
       {"upper", "upper", ""}},
      {},
      {}};
  for (const auto& [labels, census, options] : counted) {
    const std::string& tolerance = std::get<std::string>(labels[0]);
    for (const census::Cell& cell : census.cells) {
      if (!cell.method.starts_with("epsilon:")) {
        continue;
      }
      const std::uint64_t lost = cell[census::Artifact::FirstWrong];
      const census::Interval part = census::clopper_pearson(lost, cell.rays);
      const double disc = disc_radius(tolerance_of(tolerance));
      const double measured =
          disc * std::sqrt(static_cast<double>(lost) / static_cast<double>(cell.rays));
      table.rows.push_back({tolerance, cell.number, hole_radius(tolerance_of(tolerance)), measured,
                            disc * std::sqrt(part.lower), disc * std::sqrt(part.upper)});
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  return {hole_table(counted), artifact_table(experiment, counted)};
}

}  // namespace

Experiment thin_wall() {
  return {
      .name = "thin-wall",
      .question = "How large a hole does an epsilon make in a wall that thins to a point?",
      .source = "Wyvill and Trotman 1990, section 2, Figure 9",
      .labels = {{"epsilon", "epsilon",
                  "Of the method epsilon, and for all methods where the rays go: along the axis "
                  "through a disc of twice the radius of its hole."}},
      .default_rays = 70'000,
      .default_numbers = "double,bin113,exact",
      .series = series,
      .tables = tables};
}

}  // namespace lamina::experiments
