#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/family_series.hpp"

namespace lamina::experiments {
namespace {

// At an angle of about 2^-k to the axis of the cylinder, to the planes of the slab, to a line in
// the cone. The solids are not rotated, so that float holds the angle.
DrawRay nearly_along(const std::string& solid, int k) {
  return [solid, k](const scene::FamilyMember& member, const scene::Scene&,
                    base::SeededStream& stream) -> geometry::ExactRay {
    const double tilt = std::ldexp(stream.uniform(0.5, 1), -k);
    const double phi = stream.uniform(0, 2 * M_PI);
    const double x = stream.uniform(-0.6, 0.6);
    const double y = stream.uniform(-0.6, 0.6);
    const auto ray = [](const geometry::Vector3<double>& origin,
                        const geometry::Vector3<double>& direction) {
      const auto exact = [](const geometry::Vector3<double>& v) -> geometry::ExactPoint {
        using number::Rational;
        return {Rational(static_cast<float>(v.x)), Rational(static_cast<float>(v.y)),
                Rational(static_cast<float>(v.z))};
      };
      return geometry::ExactRay{exact(origin), exact(direction)};
    };
    if (solid == "cylinder") {
      return ray(member.place({x, y, -3}), {tilt * std::cos(phi), tilt * std::sin(phi), 1});
    }
    if (solid == "slab") {
      return ray(member.place({-3, y, x}), {1, std::sin(phi), tilt});
    }
    return ray(member.place({-3, y, 4 + x}), {1, tilt, -1});
  };
}

std::vector<Series> series(const Settings& settings) {
  const std::vector<int> powers{1, 4, 8, 12, 16, 20, 24, 28, 32, 40, 48, 56, 60};
  const std::vector<std::string> solids{"cylinder", "slab", "cone"};
  std::vector<Series> all;
  for (const std::string& solid : solids) {
    for (const int k : powers) {
      all.push_back(family_series({solid, std::uint64_t(k)}, "unclosed:" + solid,
                                  {fmt::format("start-state/{}", k), nearly_along(solid, k)},
                                  settings.rays / (solids.size() * powers.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment start_state() {
  return {.name = "start-state",
          .question =
              "Is a leaf's state before its first crossing right for rays nearly along "
              "the surface?",
          .source = "Wyvill and Trotman 1990, section 3.7: the reference point",
          .labels = {{"solid", "solid",
                      "Rays nearly along the axis of a cylinder, the planes of a slab, a line in a "
                      "cone."},
                     {"k", "k", "The angle is about 2^-k."}},
          .default_rays = 39'000,
          .default_methods =
              "regularized,wyvill-trotman,wyvill-trotman:reference:1e3,"
              "wyvill-trotman:reference:1e9",
          .default_numbers = "float,double,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
