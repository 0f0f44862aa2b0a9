#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/near-tangent/grazing.hpp"

namespace lamina::experiments {

Aim grazing_aim(int k, double distance) {
  const auto draw = [k, distance](const scene::FamilyMember& member, const scene::Scene&,
                                  base::SeededStream& stream) {
    const geometry::Vector3<double> d = scene::random_direction(stream);
    const geometry::Vector3<double> across = cross(d, scene::random_direction(stream));
    const double depth = std::pow(10.0, -k - stream.unit()) * (stream.chance(0.5) ? 1 : -1);
    const geometry::Vector3<double> nearest =
        ((1 - depth) / std::sqrt(dot(across, across))) * across;
    return scene::ray_from(member.place(nearest - distance * d), member.place(nearest),
                           scene::Held::Double);
  };
  return {fmt::format("grazing/{}/{}", k, distance), draw};
}

namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<double> distances{10, 1e3, 1e5};
  const std::vector<int> depths{4, 6, 8, 10, 12, 14, 16};
  std::vector<Series> all;
  for (const double distance : distances) {
    for (const int k : depths) {
      all.push_back(family_series({distance, fmt::format("1e-{}", k)}, "ball",
                                  grazing_aim(k, distance),
                                  settings.rays / (distances.size() * depths.size()), settings));
    }
  }
  return all;
}

}  // namespace

Experiment near_tangent() {
  return {.name = "near-tangent",
          .question = "Does a method survive rays that graze a sphere, where the normal tells "
                      "entering from leaving no more?",
          .source = "Wyvill and Trotman 1990, section 3.2",
          .labels = {{"distance", "distance", "From the eye to the unit sphere."},
                     {"depth", "depth",
                      "How far rays pass inside or outside of the surface: from this to a tenth "
                      "of it."}},
          .default_rays = 8'400,
          .default_methods = "roth,regularized,wyvill-trotman,wyvill-trotman:parity",
          .default_numbers = "double,longdouble,bin113,exact",
          .series = series};
}

}  // namespace lamina::experiments
