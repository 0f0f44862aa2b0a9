#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

constexpr const char* kTolerance = "1e-4";

// At a point of z = 0, from above, `degrees` away from head-on; uniformly in all directions if
// there is no angle.
DrawRay at_an_angle(std::optional<double> degrees) {
  return [degrees](const scene::FamilyMember& member, const scene::Scene&,
                   base::SeededStream& stream) {
    constexpr double kDistance = 10;
    const double cosine = degrees ? std::cos(*degrees * M_PI / 180) : stream.unit();
    const double sine = std::sqrt(1 - cosine * cosine);
    const double phi = stream.uniform(0, 2 * M_PI);
    const double x = stream.uniform(-1, 1);
    const double y = stream.uniform(-1, 1);
    const geometry::Vector3<double> up{sine * std::cos(phi), sine * std::sin(phi), cosine};
    const geometry::Vector3<double> target{x, y, 0};
    return scene::ray_from(member.place(target + kDistance * up), member.place(target),
                           scene::Held::Float);
  };
}

// The rational `ratio` of the tolerance, as text.
std::string gap_text(const std::string& ratio) {
  return number::to_text(
      number::Rational(number::parse_rational(ratio) * number::parse_rational(kTolerance)));
}

std::vector<Series> series(const Settings& settings) {
  struct Kind {
    std::string solid;
    std::string ratio;
    std::string angle;
  };
  std::vector<Kind> kinds;
  for (const char* solid : {"gap", "slab"}) {
    for (const char* ratio : {"0.5", "0.75", "0.9", "0.99", "1.01", "1.1", "1.25", "1.5", "2"}) {
      kinds.push_back({solid, ratio, "0"});
    }
  }
  for (const char* angle : {"15", "30", "40", "45", "47", "47.5", "50", "60", "75", "any"}) {
    kinds.push_back({"slab", "0.68", angle});
  }
  std::vector<Series> all;
  for (const Kind& kind : kinds) {
    const std::optional<double> degrees =
        kind.angle == "any"
            ? std::nullopt
            : std::optional(number::nearest_double(number::parse_rational(kind.angle)));
    Series one = family_series(
        {kind.solid, kind.ratio, kind.angle}, kind.solid + ":" + gap_text(kind.ratio),
        {"angle/" + kind.angle, at_an_angle(degrees)}, settings.rays / kinds.size(), settings);
    one.plan.methods = with_epsilon(settings.plan.methods, kTolerance);
    all.push_back(std::move(one));
  }
  return all;
}

// What a head-on view, an angle, or all directions show of it if only gap / cos(angle) counts.
double visible_part(double ratio, const std::string& angle) {
  if (angle == "any") {
    return std::min(1.0, ratio);
  }
  const double degrees = number::nearest_double(number::parse_rational(angle));
  return ratio / std::cos(degrees * M_PI / 180) > 1 ? 1 : 0;
}

report::Table visible_table(const std::vector<report::LabelledCensus>& counted) {
  report::Table table{"visible",
                      "epsilon-gap: what is seen of the gap or the slab",
                      {{"solid", "solid", ""},
                       {"ratio", "g / epsilon", ""},
                       {"angle", "angle", "Degrees between the ray and head-on; any: uniform."},
                       {"closed_form", "closed form",
                        "Seen if the way through it, g / cos(angle), is longer than epsilon: from "
                        "arccos(g / epsilon) on, and from the part g / epsilon of all directions."},
                       {"method", "method", ""},
                       {"number", "number", ""},
                       {"seen", "seen", "Rays on which every medium is right."}},
                      {},
                      {}};
  for (const auto& [labels, census, options] : counted) {
    const auto text = [&l = labels](std::size_t i) { return std::get<std::string>(l[i]); };
    const double ratio = number::nearest_double(number::parse_rational(text(1)));
    for (const census::Cell& cell : census.cells) {
      if (!cell.method.starts_with("epsilon:")) {
        continue;
      }
      using census::Artifact;
      // The media are wrong exactly where the gap is lost: as material, or the slab as void.
      const std::uint64_t lost = cell[text(0) == "gap" ? Artifact::GhostMaterial : Artifact::Void];
      table.rows.push_back({text(0), text(1), text(2), visible_part(ratio, text(2)), cell.method,
                            cell.number, report::Rate{cell.rays - lost, cell.rays}});
    }
  }
  return table;
}

std::vector<report::Table> tables(const Experiment& experiment,
                                  const std::vector<report::LabelledCensus>& counted) {
  return {visible_table(counted), artifact_table(experiment, counted)};
}

}  // namespace

Experiment epsilon_gap() {
  return {
      .name = "epsilon-gap",
      .question = "When does an epsilon lose a gap, or a thin slab?",
      .source = "Wyvill and Trotman 1990, section 2: the second reason against error limits",
      .labels = {{"solid", "solid", "gap: two solids that are g apart; slab: one that is g thick."},
                 {"ratio", "g / epsilon", "Epsilon is 1e-4."},
                 {"angle", "angle", "Degrees between the ray and head-on; any: uniform."}},
      .default_rays = 56'000,
      .default_numbers = "float,double,exact",
      .series = series,
      .tables = tables};
}

}  // namespace lamina::experiments
