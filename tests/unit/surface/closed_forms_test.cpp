// Sweeps of contours that are all but circles: what they are crossed at is as far from a cylinder,
// cone, sphere or torus as the contour is from its circle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/seeded_stream.hpp"
#include "surface/rounded_sweep.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {
namespace {

using base::SeededStream;
using geometry::Contour;
using geometry::ContourKind;
using geometry::PlanePoint;
using geometry::Ray;
using Point = geometry::Vector3<double>;

constexpr int kPoints = 16;

// Points on a circle from one angle to another, in whole turns; rounded to double, so that the
// contour is exact and its distance from the circle is what circle_error() finds.
std::shared_ptr<const Contour> circle(double centre_u, double radius, bool closed) {
  std::vector<PlanePoint> points;
  for (int i = 0; i < (closed ? kPoints : kPoints + 1); ++i) {
    // An open one goes up from the axis to the axis.
    const double angle = closed ? 2 * M_PI * i / kPoints : M_PI * i / kPoints - M_PI / 2;
    const bool on_axis = !closed && (i == 0 || i == kPoints);
    points.push_back({on_axis ? number::Rational(0) : centre_u + radius * std::cos(angle),
                      number::Rational(radius * std::sin(angle))});
  }
  return std::make_shared<const Contour>(std::move(points), ContourKind::CatmullRom, closed);
}

// The greatest |distance from the centre - radius| on the contour: the polynomial rho^2 - radius^2
// of each piece is between its least and greatest Bernstein coefficient, and |rho - radius| <=
// |rho^2 - radius^2| / radius.
double circle_error(const Contour& contour, double centre_u, double radius) {
  double largest = 0;
  for (const geometry::ContourPiece& piece : contour.pieces()) {
    std::array<double, 7> g{-radius * radius};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const auto shifted = [&](std::size_t k) {
          return number::nearest_double(piece.u[k]) - (k == 0 ? centre_u : 0);
        };
        g[i + j] += shifted(i) * shifted(j) +
                    number::nearest_double(piece.v[i]) * number::nearest_double(piece.v[j]);
      }
    }
    for (std::size_t i = 0; i <= 6; ++i) {
      double coefficient = 0;
      double ratio = 1;  // of binomials, (i over k) to (6 over k)
      for (std::size_t k = 0; k <= i; ++k) {
        coefficient += ratio * g[k];
        ratio *= static_cast<double>(i - k) / static_cast<double>(6 - k);
      }
      largest = std::max(largest, std::abs(coefficient));
    }
  }
  return largest / radius;
}

struct Form {
  Sweep sweep;
  std::shared_ptr<const Contour> contour;
  double centre_u;
  double radius;
  /// From the surface's centre, axis or circle.
  double (*distance)(const Point& p);
  /// How many crossings the surface with another radius has with a ray; -1 if that is not known.
  int (*count)(const Ray<double>& ray, double radius);
};

int quadratic_count(double a, double half_b, double c) {
  return half_b * half_b - a * c > 0 ? 2 : 0;
}

std::array<Form, 4> forms() {
  const auto unit = circle(0, 1, true);
  return {
      Form{Sweep::Translational, unit, 0, 1, [](const Point& p) { return std::hypot(p.x, p.y); },
           [](const Ray<double>& r, double radius) {
             const auto& [o, d] = r;
             return quadratic_count(d.x * d.x + d.y * d.y, d.x * o.x + d.y * o.y,
                                    o.x * o.x + o.y * o.y - radius * radius);
           }},
      Form{Sweep::Conic, unit, 0, 1,
           [](const Point& p) { return std::hypot(p.x, p.y) / std::abs(p.z); },
           [](const Ray<double>& r, double radius) {
             const auto& [o, d] = r;
             const double q = radius * radius;
             return quadratic_count(d.x * d.x + d.y * d.y - q * d.z * d.z,
                                    d.x * o.x + d.y * o.y - q * d.z * o.z,
                                    o.x * o.x + o.y * o.y - q * o.z * o.z);
           }},
      Form{Sweep::Rotational, circle(0, 1, false), 0, 1,
           [](const Point& p) { return std::sqrt(dot(p, p)); },
           [](const Ray<double>& r, double radius) {
             const auto& [o, d] = r;
             return quadratic_count(dot(d, d), dot(d, o), dot(o, o) - radius * radius);
           }},
      Form{Sweep::Rotational, circle(2, 0.5, true), 2, 0.5,
           [](const Point& p) { return std::hypot(std::hypot(p.x, p.y) - 2, p.z); },
           [](const Ray<double>&, double) { return -1; }}};
}

TEST(ClosedFormsTest, CrossingsAreAsFarOffAsTheContour) {
  constexpr int kRays = 400;
  for (const Form& form : forms()) {
    const SweptSurface exact(form.sweep, form.contour);
    const RoundedSweep<double> rounded(exact);
    const double error = circle_error(*form.contour, form.centre_u, form.radius);
    // Halfway between two of the points, with h = 2 pi / n, the spline is at cos(h / 2) + sin(h)
    // sin(h / 2) / 4 = 1 - 9/384 h^4 + ... times the radius. Dividing by the radius in place of
    // rho + radius doubles that, and the Bernstein coefficients are less than twice the values.
    EXPECT_LT(error, 4 * 9.0 / 384 * std::pow(2 * M_PI / kPoints, 4) * form.radius);
    SeededStream stream("closed-forms", 1, static_cast<std::uint64_t>(form.sweep));
    int crossings = 0;
    int counts = 0;
    for (int i = 0; i < kRays; ++i) {
      const auto any = [&stream] { return std::nearbyint(64 * stream.uniform(-2, 2)) / 64; };
      Ray<double> ray{{any(), any(), any()}, {any(), any(), any()}};
      ray.direction.x += ray.direction == Point{0, 0, 0} ? 1 : 0;
      ray.direction.z = i % 8 == 0 ? 0 : ray.direction.z;
      if (i % 8 == 1) {
        ray.direction = {0, 0, 1};
      }
      const auto at = [&ray](double t) { return ray.origin + t * ray.direction; };
      std::vector<RoundedSweep<double>::Crossing> found;
      rounded.find_crossings(ray, {}, found);
      const geometry::ExactRay same{{ray.origin.x, ray.origin.y, ray.origin.z},
                                    {ray.direction.x, ray.direction.y, ray.direction.z}};
      const SweptSurface::Crossings truth = exact.crossings(same);
      std::vector<double> all;
      for (const auto& crossing : truth.crossings) {
        all.push_back(nearest_double(crossing.t));
      }
      for (const auto& crossing : found) {
        all.push_back(crossing.t);
      }
      for (const double t : all) {
        // The point is off by 3 u (|o| + |t d|), here below 3e-15; in a cone that is divided by its
        // distance from the apex, from which rays of this grid pass at |o x d| / |d| >= 64^-2 / 3.5
        // or 0: 4e-11, and again as much for z. The crossing's t is off by what takes the surface's
        // equation 16 u of terms below 100 from zero, less than that.
        EXPECT_NEAR(form.distance(at(t)), form.radius, error + 1e-9) << t;
      }
      const int inner = form.count(ray, form.radius - error);
      if (inner >= 0 && inner == form.count(ray, form.radius + error)) {
        EXPECT_EQ(truth.crossings.size(), static_cast<std::size_t>(inner));
        EXPECT_EQ(found.size(), static_cast<std::size_t>(inner));
        ++counts;
      }
      crossings += static_cast<int>(truth.crossings.size());
    }
    EXPECT_GT(crossings, kRays / 4);
    EXPECT_TRUE(form.radius < 1 || counts > kRays / 2) << counts;
  }
}

}  // namespace
}  // namespace lamina::surface
