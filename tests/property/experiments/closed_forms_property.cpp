// What geometry says an epsilon does, against what the census counts.
#include <catch2/catch.hpp>
#include <cmath>

#include "census/statistics.hpp"
#include "experiments/experiment.hpp"
#include "number/all_numbers.hpp"
#include "trace/number_choice.hpp"

namespace lamina::experiments {
namespace {

using census::Artifact;

Settings settings(std::uint64_t rays) {
  Settings settings;
  settings.plan.methods = {method::parse_method("epsilon:1")};  // experiments set the tolerance
  settings.plan.numbers = {trace::number_choice<double>(), trace::number_choice<number::exact>()};
  settings.rays = rays;
  settings.seed = 4;
  settings.warn = [](const std::string&) {};
  return settings;
}

std::string text_of(const census::Label& label) { return std::get<std::string>(label); }

// W&T Figure 9, along the axis: between a sphere of radius 2 and one of 3/2 that touches it from
// inside the wall is sqrt(4 - rho^2) - 1/2 - sqrt(9/4 - rho^2) thick at the distance rho from the
// axis, rho^2 / 12 to first order. Where is it as thick as epsilon?
double hole_radius(double epsilon) {
  double low = 0;
  double high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double rho = (low + high) / 2;
    // The difference of the roots without cancellation.
    const double inner = std::sqrt(2.25 - rho * rho) + 0.5;
    const double outer = std::sqrt(4 - rho * rho);
    const double thickness = (4 - rho * rho - inner * inner) / (outer + inner);
    (thickness < epsilon ? low : high) = rho;
  }
  return low;
}

}  // namespace

// Rays go through a disc of twice the radius to first order.
TEST_CASE("The hole of Figure 9 has the radius sqrt(2 epsilon / kappa)") {
  for (const Series& series : find_experiment("thin-wall").series(settings(7 * 2000))) {
    const std::string epsilon = text_of(series.labels.at(0));
    const census::Census census =
        census::run_census(series.plan, series.tasks, series.task, [](auto, auto) { return true; });
    for (const census::Cell& cell : census.cells) {
      INFO(cell.method << " in " << cell.number);
      CHECK(cell.method == "epsilon:" + epsilon);
      const std::uint64_t lost = cell[Artifact::FirstWrong];
      const double exactly = hole_radius(std::stod(epsilon));
      const double expected = exactly * exactly / (4 * 12 * std::stod(epsilon));
      const census::Interval part = census::clopper_pearson(lost, cell.rays);
      // 14 intervals of 95 %: widened to about three standard errors.
      const double slack = (part.upper - part.lower) / 4;
      CHECK(part.lower - slack < expected);
      CHECK(expected < part.upper + slack);
      CHECK(cell[Artifact::EpsilonHole] == lost);
      CHECK(cell.caused[static_cast<std::size_t>(census::Cause::Model)] == lost);
    }
  }
}

TEST_CASE("A slab reappears at the angle arccos(g / epsilon)") {
  std::size_t angles = 0;
  for (const Series& series : find_experiment("epsilon-gap").series(settings(28 * 400))) {
    const std::string solid = text_of(series.labels.at(0));
    const double ratio = std::stod(text_of(series.labels.at(1)));
    const std::string angle = text_of(series.labels.at(2));
    const census::Census census =
        census::run_census(series.plan, series.tasks, series.task, [](auto, auto) { return true; });
    for (const census::Cell& cell : census.cells) {
      INFO(solid << " " << ratio << " " << angle << " in " << cell.number);
      const std::uint64_t lost = cell[solid == "gap" ? Artifact::GhostMaterial : Artifact::Void];
      if (angle == "any") {
        const census::Interval part = census::clopper_pearson(cell.rays - lost, cell.rays);
        const double slack = (part.upper - part.lower) / 4;
        CHECK(part.lower - slack < ratio);
        CHECK(ratio < part.upper + slack);
        ++angles;
      } else {
        const bool seen = std::stod(angle) > std::acos(std::min(1.0, ratio)) * 180 / M_PI ||
                          (ratio > 1 && angle == "0");
        CHECK(lost == (seen ? 0 : cell.rays));
        angles += angle == "0" ? 0 : 1;
      }
    }
  }
  CHECK(angles == 20);
}

}  // namespace lamina::experiments
