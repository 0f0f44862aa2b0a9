// What geometry says an epsilon does, against what the census counts.
#include <catch2/catch.hpp>
#include <cmath>

#include "census/statistics.hpp"
#include "experiments/experiment.hpp"
#include "number/all_numbers.hpp"

namespace lamina::experiments {
namespace {

using census::Artifact;

Settings settings(std::uint64_t rays) {
  Settings settings;
  settings.plan.methods = {method::parse_method("epsilon:1")};  // experiments set the tolerance
  settings.plan.numbers = {method::number_choice<double>(), method::number_choice<number::exact>()};
  settings.rays = rays;
  settings.seed = 4;
  settings.warn = [](const std::string&) {};
  return settings;
}

std::string text_of(const census::Label& label) { return std::get<std::string>(label); }

}  // namespace

// W&T Figure 9: the wall between a sphere of radius 2 and one of 3/2 that touches it from inside
// has the thickness rho^2/2 (2/3 - 1/2) at the distance rho from the point of contact, so it is
// lost within rho = sqrt(12 epsilon); rays go through a disc of twice that radius.
TEST_CASE("The hole of Figure 9 has the radius sqrt(2 epsilon / kappa)") {
  for (const Series& series : find_experiment("thin-wall").series(settings(7 * 2000))) {
    const std::string epsilon = text_of(series.labels.at(0));
    const census::Census census =
        census::run_census(series.plan, series.tasks, series.task, [](auto, auto) { return true; });
    for (const census::Cell& cell : census.cells) {
      INFO(cell.method << " in " << cell.number);
      CHECK(cell.method == "epsilon:" + epsilon);
      const std::uint64_t lost = cell[Artifact::FirstWrong];
      // The wall's third-order terms: at 1e-2 the hole is wider by a few percent of its radius.
      const double expected = epsilon == "1e-2" ? 0.253 : 0.25;
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
