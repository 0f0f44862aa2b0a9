#include <fmt/format.h>

#include <cmath>

#include "experiments/all_experiments.hpp"
#include "experiments/near-tangent/grazing.hpp"

namespace lamina::experiments {

Aim grazing_aim(const std::string& solid, int k, double distance) {
  using Point = geometry::Vector3<double>;
  const bool ring = solid == "ring";
  const auto draw = [ring, k, distance](const scene::FamilyMember& member, const scene::Scene&,
                                        base::SeededStream& stream) {
    const Point normal = scene::random_direction(stream);
    const double across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    const Point surface =
        ring ? Point{normal.x / across, normal.y / across, 0} + 0.25 * normal : normal;
    const Point d = cross(normal, scene::random_direction(stream));
    const Point along = (1 / std::sqrt(dot(d, d))) * d;
    const double depth = std::pow(10.0, -k - stream.unit());
    const double below = stream.chance(0.5) ? depth : -depth;
    const Point nearest = surface - below * normal;
    return scene::ray_from(member.place(nearest - distance * along), member.place(nearest),
                           scene::Held::Double);
  };
  return {fmt::format("grazing/{}/{}/{}", solid, k, distance), draw};
}

namespace {

std::vector<Series> series(const Settings& settings) {
  const std::vector<std::string> solids{"ball", "ring"};
  const std::vector<double> distances{10, 1e3, 1e5};
  const std::vector<int> depths{4, 6, 8, 10, 12, 14, 16};
  const std::uint64_t rays = settings.rays / (solids.size() * distances.size() * depths.size());
  std::vector<Series> all;
  for (const std::string& solid : solids) {
    for (const double distance : distances) {
      for (const int k : depths) {
        all.push_back(family_series({solid, distance, fmt::format("1e-{}", k)}, "round:" + solid,
                                    grazing_aim(solid, k, distance), rays, settings));
      }
    }
  }
  return all;
}

}  // namespace

Experiment near_tangent() {
  return {.name = "near-tangent",
          .question = "Does the normal tell entering from leaving where a ray grazes a surface?",
          .source = "Wyvill and Trotman 1990, section 3.2",
          .labels = {{"solid", "solid", "ball: a unit sphere; ring: a torus of radii 1 and 1/4."},
                     {"distance", "distance", "From the eye to the surface."},
                     {"depth", "depth",
                      "How far below or above the tangent plane rays pass: from this to a tenth of "
                      "it."}},
          .default_rays = 21'000,
          .default_methods = "roth,regularized,wyvill-trotman,wyvill-trotman:parity",
          .default_numbers = "bin11,float,double,longdouble,bin113,bin237,exact",
          .series = series};
}

}  // namespace lamina::experiments
