#include "experiments/sweep-race/profile_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.hpp"

namespace lamina::experiments {
namespace {

using number::nearest_double;

// As RoundedSweep has it.
surface::RayImage<double> image_of(const geometry::Ray<double>& ray) {
  const auto& [o, d] = ray;
  surface::RayImage<double> e;
  e.vv = e.most_vv = d.x * d.x + d.y * d.y;
  e.v = 2 * (d.z * (d.x * o.x + d.y * o.y) - o.z * e.vv);
  e.most_v =
      2 * (std::abs(d.z) * (std::abs(d.x * o.x) + std::abs(d.y * o.y)) + std::abs(o.z) * e.vv);
  const double x = d.x * o.z - d.z * o.x;
  const double y = d.y * o.z - d.z * o.y;
  const double most_x = std::abs(d.x * o.z) + std::abs(d.z * o.x);
  const double most_y = std::abs(d.y * o.z) + std::abs(d.z * o.y);
  e.constant = x * x + y * y;
  e.most_constant = most_x * most_x + most_y * most_y;
  e.uu = -(d.z * d.z);
  e.most_uu = d.z * d.z;
  return e;
}

}  // namespace

ProfileSearch::ProfileSearch(const geometry::RevolvedProfile& profile) {
  for (const geometry::ProfilePiece& piece : profile.pieces()) {
    if (const auto* conic = std::get_if<geometry::Conic>(&piece)) {
      const double low = nearest_double(conic->y_low);
      const double high = nearest_double(conic->y_high);
      // x^2 is least and greatest at an end, or where it turns.
      double least =
          nearest_double(std::min(conic->square_at(conic->y_low), conic->square_at(conic->y_high)));
      double most =
          nearest_double(std::max(conic->square_at(conic->y_low), conic->square_at(conic->y_high)));
      if (conic->slope_at(conic->y_low) * conic->slope_at(conic->y_high) < 0) {
        const double turn = nearest_double(conic->square_at(-conic->beta / (2 * conic->alpha)));
        least = std::min(least, turn);
        most = std::max(most, turn);
      }
      pieces_.emplace_back(RoundedConic{nearest_double(conic->alpha),
                                        nearest_double(conic->beta),
                                        nearest_double(conic->gamma),
                                        {low, high}});
      boxes_.push_back({std::sqrt(std::max(least, 0.0)), std::sqrt(most), low, high});
    } else {
      const auto& arc = *std::get_if<geometry::Arc>(&piece);
      LAMINA_REQUIRE(arc.part == geometry::ArcPart::Above, "an arc that is no rim");
      const double major = nearest_double(arc.major);
      const double minor = nearest_double(arc.minor);
      const double height = nearest_double(arc.height);
      const double low = nearest_double(arc.y_low);
      pieces_.emplace_back(RoundedArc{
          surface::RoundedSurface<double>(surface::torus(arc.major, arc.minor)), height, low});
      boxes_.push_back({major - minor, major + minor, low, height + minor});
    }
  }
  tree_ = surface::BoxTree<double>(boxes_);
}

void ProfileSearch::find_crossings(const geometry::Ray<double>& ray, const poly::Solvers& solvers,
                                   std::vector<double>& crossings) const {
  LAMINA_REQUIRE(ray.direction.z != 0 && (ray.direction.x != 0 || ray.direction.y != 0),
                 "a level or an upright ray");
  crossings.clear();
  const surface::RayImage<double> e = image_of(ray);
  tree_.visit_pieces(
      [&e](const surface::PlaneBox<double>& box) { return e.over(box).exclude_zero(3); },
      [&](std::uint32_t i) {
        if (e.over(boxes_[i]).exclude_zero()) {
          return true;
        }
        if (const auto* conic = std::get_if<RoundedConic>(&pieces_[i])) {
          const std::array<double, 3> c{e.constant + e.uu * conic->gamma, e.v + e.uu * conic->beta,
                                        e.vv + e.uu * conic->alpha};
          const auto roots =
              poly::real_roots(std::span<const double>(c), conic->heights, solvers.quadratic);
          for (int k = 0; k < roots.count; ++k) {
            crossings.push_back((roots.t[k] - ray.origin.z) / ray.direction.z);
          }
          return true;
        }
        const auto& arc = *std::get_if<RoundedArc>(&pieces_[i]);
        geometry::Ray<double> local = ray;
        local.origin.z -= arc.height;
        const auto found = arc.torus.crossings(local, solvers);
        for (int k = 0; k < found.roots.count; ++k) {
          if (ray.origin.z + found.roots.t[k] * ray.direction.z >= arc.low) {
            crossings.push_back(found.roots.t[k]);
          }
        }
        return true;
      });
}

}  // namespace lamina::experiments
