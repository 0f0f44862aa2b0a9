// Profiles in closed form, and what stands for them: splines, conics with an arc, cones.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/revolved_profile.hpp"
#include "scene/scene.hpp"

namespace lamina::experiments {

/// A point of a profile and its direction there, of length one.
struct CurvePoint {
  double u = 0;
  double v = 0;
  double along_u = 0;
  double along_v = 0;
};

/// A smooth profile from the axis to the axis that goes round its solid with the solid on its left.
struct IdealCurve {
  std::string name;
  double height = 0;
  std::function<CurvePoint(double)> at;  ///< in closed form, for 0 .. points.size() - 1
  /// Those at whole numbers: so dense that the polygon through them is off by 1e-6 of the height at
  /// most.
  std::vector<CurvePoint> points{};
  /// A half circle at the top. What is before point `first` is outside, after `last` inside.
  struct Rim {
    std::size_t first = 0;
    std::size_t last = 0;
    double major = 0;
    double minor = 0;
  };
  std::optional<Rim> rim{};
};

/// `vase`, a solid, and `glass`, which has a wall with a round rim.
const std::vector<IdealCurve>& ideal_curves();

enum class Representation : std::uint8_t {
  CatmullRom,  ///< a rotational sweep of the spline through the points (van Wijk)
  BSpline,     ///< likewise, of that B-spline which goes through the points
  Conics,      ///< Hashimoto and Suenaga
  Cones,       ///< Horiuchi
};
inline constexpr std::array kRepresentations{Representation::CatmullRom, Representation::BSpline,
                                             Representation::Conics, Representation::Cones};
std::string_view name_of(Representation representation);

struct Fit {
  std::size_t pieces = 0;
  double distance = 0;   ///< the greatest from a point of one curve to the other, over the height
  double angle_rad = 0;  ///< the greatest between the normals at a point of one curve and at the
                         ///< nearest of the other that has its side of the wall
  std::string text;      ///< in the scene language
  std::shared_ptr<const scene::Scene> scene;         ///< of this text
  std::optional<geometry::RevolvedProfile> profile;  ///< of conics alone
};

enum class Measure : std::uint8_t { Distance, Angle };

/// Returns the fit with the fewest points whose error is not above `limit`, of a ladder of numbers
/// of points whose steps are one point, or 3 %. The points are at equal steps of one measure for
/// all representations. Kept: the second call costs nothing.
const Fit& least_fit(const IdealCurve& curve, Representation representation, Measure measure,
                     double limit);

}  // namespace lamina::experiments
