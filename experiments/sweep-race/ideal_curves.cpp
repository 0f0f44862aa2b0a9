#include "experiments/sweep-race/ideal_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>

#include "base/contract.hpp"
#include "geometry/conic_spline.hpp"

namespace lamina::experiments {
namespace {

using geometry::PlanePoint;
using number::nearest_double;
using number::Rational;

// u^2 and its slope at a height.
struct Square {
  double value = 0;
  double slope = 0;
};

constexpr double kHeight = 4;

// A belly, a neck and a lip, closed at the top: X = 4 R^2 w (1 - w) n(w), w = v / H.
Square vase(double v) {
  const double w = v / kHeight;
  const double notch = 0.75 * std::exp(-std::pow((w - 0.7) / 0.15, 2));
  const double n = 1 - notch;
  const double n_slope = notch * 2 * (w - 0.7) / (0.15 * 0.15);
  const double scale = 4 * 1.2 * 1.2;
  return {scale * w * (1 - w) * n, scale * ((1 - 2 * w) * n + w * (1 - w) * n_slope) / kHeight};
}

// A foot, a stem and a bowl: X = v / (v + a) (s + F / (1 + (v/b)^4)) + B S(t), where S is the
// polynomial 10 t^3 - 15 t^4 + 6 t^5 of t = (v - c) / (H - c), so that the wall is upright at the
// rim.
Square glass_outside(double v) {
  constexpr double kA = 0.1, kStem = 0.03, kFoot = 0.9, kB = 0.35, kBowl = 1.2, kC = 1.2;
  const double pole = v / (v + kA);
  const double pole_slope = kA / ((v + kA) * (v + kA));
  const double power = std::pow(v / kB, 4);
  const double foot = kStem + kFoot / (1 + power);
  const double foot_slope = v > 0 ? -kFoot * 4 * power / v / ((1 + power) * (1 + power)) : 0;
  const double t = std::max(0.0, (v - kC) / (kHeight - kC));
  const double bowl = kBowl * t * t * t * (10 + t * (6 * t - 15));
  const double bowl_slope = kBowl * 30 * t * t * (1 - t) * (1 - t) / (kHeight - kC);
  return {pole * foot + bowl, pole_slope * foot + pole * foot_slope + bowl_slope};
}

// X = X_outside - K: the wall is the thicker the lower, 0.15 at the rim.
constexpr double kWall = 0.3;
Square glass_inside(double v) {
  const Square outside = glass_outside(v);
  return {outside.value - kWall, outside.slope};
}

// The point at that height of a profile that goes up (1) or down (-1).
CurvePoint point_at(Square (*square)(double), double v, int direction) {
  const auto [value, slope] = square(v);
  const double u = std::sqrt(std::max(value, 0.0));
  const double length = std::hypot(slope, 2 * u);
  return {u, v, direction * slope / length, direction * 2 * u / length};
}

double turn(const CurvePoint& a, const CurvePoint& b) {
  return std::abs(std::atan2(a.along_u * b.along_v - a.along_v * b.along_u,
                             a.along_u * b.along_u + a.along_v * b.along_v));
}

double distance(const CurvePoint& a, const CurvePoint& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

// So many points to a section: between points a step s apart, where the curve turns by a, a polygon
// is off by s a / 8. That is 4.0e-6 at most here: 1e-6 of the height.
constexpr int kDense = 1200;

void add_points(IdealCurve& curve, int last) {
  for (int i = 0; i <= last; ++i) {
    curve.points.push_back(curve.at(i));
  }
}

IdealCurve make_vase() {
  constexpr int kLast = 2 * kDense;
  IdealCurve curve{.name = "vase", .height = kHeight, .at = [](double place) -> CurvePoint {
                     if (place <= 0 || place >= kLast) {
                       return {0, place <= 0 ? 0 : kHeight, place <= 0 ? 1.0 : -1.0, 0};
                     }
                     // Even steps of an angle: dense at the poles, where u is a root.
                     const double angle = std::numbers::pi * place / kLast;
                     return point_at(vase, kHeight * (1 - std::cos(angle)) / 2, 1);
                   }};
  add_points(curve, kLast);
  return curve;
}

IdealCurve make_glass() {
  constexpr int kRim = kDense / 4;
  const double outer = point_at(glass_outside, kHeight, 1).u;
  const double inner = point_at(glass_inside, kHeight, -1).u;
  const IdealCurve::Rim rim{kDense, kDense + kRim, (outer + inner) / 2, (outer - inner) / 2};
  double low = 1;  // the height of the inner pole: the stem there is below it, the bowl above
  double high = kHeight;
  while (high - low > 1e-15 * kHeight) {
    const double middle = (low + high) / 2;
    (glass_inside(middle).value < 0 ? low : high) = middle;
  }
  constexpr int kLast = 2 * kDense + kRim;
  const auto at = [rim, bottom = high](double place) -> CurvePoint {
    if (place <= 0 || place >= kLast) {
      return {0, place <= 0 ? 0 : bottom, place <= 0 ? 1.0 : -1.0, 0};
    }
    if (place <= kDense) {
      const double q = place / kDense;
      return point_at(glass_outside, kHeight * q * q, 1);
    }
    if (place < kDense + kRim) {
      const double angle = std::numbers::pi * (place - kDense) / kRim;
      return {rim.major + rim.minor * std::cos(angle), kHeight + rim.minor * std::sin(angle),
              -std::sin(angle), std::cos(angle)};
    }
    const double q = (kLast - place) / kDense;
    return point_at(glass_inside, bottom + (kHeight - bottom) * q * q, -1);
  };
  IdealCurve curve{.name = "glass", .height = kHeight + rim.minor, .at = at, .rim = rim};
  add_points(curve, kLast);
  return curve;
}

// Where points go: at least as dense as the length and the turn of the curve ask for together, each
// with half of the points, and neighbouring steps of nearly one
// length, since the splines' parameter takes equal steps from point to point.
std::vector<double> places(const IdealCurve& curve, std::size_t steps) {
  const auto& p = curve.points;
  double length = 0;
  double turns = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    length += distance(p[i - 1], p[i]);
    turns += turn(p[i - 1], p[i]);
  }
  // By segment: the step that is asked for.
  std::vector<double> step(p.size() - 1);
  for (std::size_t i = 0; i < step.size(); ++i) {
    const double d = distance(p[i], p[i + 1]);
    step[i] = 2 * d / (d / length + turn(p[i], p[i + 1]) / turns) / static_cast<double>(steps);
  }
  constexpr double kGrowth = 0.25;  // of the step over the length: over one step, by about as much
  for (std::size_t i = 1; i < step.size(); ++i) {
    step[i] = std::min(step[i], step[i - 1] + kGrowth * distance(p[i - 1], p[i]));
  }
  for (std::size_t i = step.size() - 1; i > 0; --i) {
    step[i - 1] = std::min(step[i - 1], step[i] + kGrowth * distance(p[i], p[i + 1]));
  }
  std::vector<double> sums{0};
  for (std::size_t i = 0; i < step.size(); ++i) {
    sums.push_back(sums.back() + distance(p[i], p[i + 1]) / step[i]);
  }
  return sums;
}

// `steps` equal steps of the sums over the points first .. last: as many segments.
std::vector<CurvePoint> spread(const IdealCurve& curve, const std::vector<double>& sums,
                               std::size_t first, std::size_t last, std::size_t steps) {
  std::vector<CurvePoint> result;
  std::size_t at = first;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double sum = sums[first] + (sums[last] - sums[first]) * static_cast<double>(i) /
                                         static_cast<double>(steps);
    while (at < last && sums[at + 1] <= sum) {
      ++at;
    }
    const double width = at < last ? sums[at + 1] - sums[at] : 0;
    const double share = width > 0 ? std::clamp((sum - sums[at]) / width, 0.0, 1.0) : 0.0;
    result.push_back(
        curve.at(i == steps ? static_cast<double>(last) : static_cast<double>(at) + share));
  }
  return result;
}

// A number of a scene: nine decimals, and its text.
std::string text_of(double value) { return fmt::format("{:.9f}", value); }
Rational held(double value) { return number::parse_rational(text_of(value)); }

std::string text_of(const std::vector<PlanePoint>& points) {
  std::string text;
  for (const PlanePoint& p : points) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "[" : ", ", number::to_text(p.u),
                        number::to_text(p.v));
  }
  return text + "]";
}

std::vector<PlanePoint> held(const std::vector<CurvePoint>& points) {
  std::vector<PlanePoint> result;
  for (const CurvePoint& p : points) {
    result.push_back({held(p.u), held(p.v)});
  }
  return result;
}

// The control points of the uniform cubic B-spline that goes through the points, and is continued
// by its mirror image at both ends: (P[i-1] + 4 P[i] + P[i+1]) / 6 = Q[i].
std::vector<PlanePoint> control_points(const std::vector<CurvePoint>& q) {
  const std::size_t n = q.size() - 1;
  const auto solved = [n](const std::vector<double>& right, double mirror) {
    // `mirror` is what the neighbour beyond an end is, times the one before it.
    std::vector<double> upper(n + 1);
    std::vector<double> x(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      const double below = i == 0 ? 0 : i == n ? 1 + mirror : 1;
      const double above = i == n ? 0 : i == 0 ? 1 + mirror : 1;
      const double pivot = 4 - (i == 0 ? 0 : below * upper[i - 1]);
      upper[i] = above / pivot;
      x[i] = (6 * right[i] - (i == 0 ? 0 : below * x[i - 1])) / pivot;
    }
    for (std::size_t i = n; i > 0; --i) {
      x[i - 1] -= upper[i - 1] * x[i];
    }
    return x;
  };
  std::vector<double> u;
  std::vector<double> v;
  for (const CurvePoint& p : q) {
    u.push_back(p.u);
    v.push_back(p.v);
  }
  u = solved(u, -1);
  v = solved(v, 1);
  u.front() = u.back() = 0;
  std::vector<PlanePoint> result;
  for (std::size_t i = 0; i <= n; ++i) {
    result.push_back({held(u[i]), held(v[i])});
  }
  return result;
}

using Samples = std::vector<CurvePoint>;

CurvePoint sample(double u, double v, double along_u, double along_v) {
  const double length = std::hypot(along_u, along_v);
  return {u, v, along_u / length, along_v / length};
}

// Of a piece. Four times as many change distances by 5 % at most, normals by 2 %, and of the 48
// least fits one by one piece (observed 2026-11-23).
constexpr int kSamples = 16;

// As geometry::Contour makes its pieces of the points, but in double.
Samples samples_of_spline(const std::vector<PlanePoint>& points, bool b_spline) {
  std::vector<double> u;
  std::vector<double> v;
  const auto add = [&](const PlanePoint& p, int side) {
    u.push_back(side * nearest_double(p.u));
    v.push_back(nearest_double(p.v));
  };
  add(points[1], -1);
  for (const PlanePoint& p : points) {
    add(p, 1);
  }
  add(points[points.size() - 2], -1);
  const auto coefficients = [b_spline](const double* p) -> std::array<double, 4> {
    return b_spline
               ? std::array{(p[0] + 4 * p[1] + p[2]) / 6, (p[2] - p[0]) / 2,
                            (p[0] - 2 * p[1] + p[2]) / 2, (3 * (p[1] - p[2]) + p[3] - p[0]) / 6}
               : std::array{p[1], (p[2] - p[0]) / 2, (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3]) / 2,
                            (3 * (p[1] - p[2]) + p[3] - p[0]) / 2};
  };
  Samples samples;
  for (std::size_t piece = 0; piece + 3 < u.size(); ++piece) {
    const auto of_u = coefficients(&u[piece]);
    const auto of_v = coefficients(&v[piece]);
    for (int i = 0; i <= kSamples; ++i) {
      const double s = static_cast<double>(i) / kSamples;
      const auto at = [s](const auto& c) { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; };
      const auto slope = [s](const auto& c) { return (3 * c[3] * s + 2 * c[2]) * s + c[1]; };
      samples.push_back(sample(at(of_u), at(of_v), slope(of_u), slope(of_v)));
    }
  }
  return samples;
}

void add_samples(Samples& samples, const geometry::Conic& conic) {
  const double low = nearest_double(conic.y_low);
  const double height = nearest_double(conic.y_high - conic.y_low);
  const double at_low = nearest_double(conic.square_at(conic.y_low));
  const double at_high = nearest_double(conic.square_at(conic.y_high));
  const double slope_low = nearest_double(conic.slope_at(conic.y_low));
  const double slope_high = nearest_double(conic.slope_at(conic.y_high));
  const double alpha = nearest_double(conic.alpha);
  for (int i = 0; i <= kSamples; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / kSamples;
    const double share = (1 - std::cos(conic.side > 0 ? angle : std::numbers::pi - angle)) / 2;
    const double up = height * share;
    const double down = height * (1 - share);
    // About the nearer end: a pole has x = 0 exactly.
    const bool is_low = share < 0.5;
    const double square = is_low ? at_low + up * (slope_low + alpha * up)
                                 : at_high - down * (slope_high - alpha * down);
    const double slope = is_low ? slope_low + 2 * alpha * up : slope_high - 2 * alpha * down;
    const double x = std::sqrt(std::max(0.0, square));
    samples.push_back(sample(x, low + up, conic.side * slope, conic.side * 2 * x));
  }
}

// A whole upper half of the circle, as all arcs here are.
void add_samples(Samples& samples, const geometry::Arc& arc) {
  const double major = nearest_double(arc.major);
  const double minor = nearest_double(arc.minor);
  const double height = nearest_double(arc.height);
  for (int i = 0; i <= 8 * kSamples; ++i) {
    const double angle = std::numbers::pi * i / (8 * kSamples);
    samples.push_back({major + minor * std::cos(angle), height + minor * std::sin(angle),
                       -std::sin(angle), std::cos(angle)});
  }
}

Samples samples_of(const geometry::RevolvedProfile& profile) {
  Samples samples;
  for (const geometry::ProfilePiece& piece : profile.pieces()) {
    std::visit([&](const auto& p) { add_samples(samples, p); }, piece);
  }
  return samples;
}

Samples samples_of_polygon(const std::vector<CurvePoint>& points) {
  Samples samples;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const CurvePoint& a = points[i - 1];
    const CurvePoint& b = points[i];
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      samples.push_back(
          sample(a.u + share * (b.u - a.u), a.v + share * (b.v - a.v), b.u - a.u, b.v - a.v));
    }
  }
  return samples;
}

// Finds the nearest point of the polygon through samples that goes the same way there, which the
// other side of a wall does not. Runs of segments are left out by their boxes.
class NearestPoint {
 public:
  explicit NearestPoint(const Samples& samples) : samples_(samples) {
    for (std::size_t i = 0; i + 1 < samples.size(); i += kRun) {
      Box box{samples[i].u, samples[i].u, samples[i].v, samples[i].v};
      for (std::size_t k = i; k < std::min(i + kRun + 1, samples.size()); ++k) {
        box = {std::min(box.u_min, samples[k].u), std::max(box.u_max, samples[k].u),
               std::min(box.v_min, samples[k].v), std::max(box.v_max, samples[k].v)};
      }
      boxes_.push_back(box);
    }
  }

  // The distance, and the angle between the directions.
  [[nodiscard]] std::pair<double, double> operator()(const CurvePoint& p) {
    double best = std::numeric_limits<double>::infinity();
    double angle = std::numbers::pi;
    std::size_t best_box = last_box_;
    // First where the point before was nearest: that leaves few boxes to look into.
    for (std::size_t turn = 0; turn <= boxes_.size(); ++turn) {
      const std::size_t b = turn == 0 ? last_box_ : turn - 1;
      const Box& box = boxes_[b];
      const double u = std::max({box.u_min - p.u, p.u - box.u_max, 0.0});
      const double v = std::max({box.v_min - p.v, p.v - box.v_max, 0.0});
      if (u * u + v * v > best) {
        continue;
      }
      for (std::size_t i = b * kRun; i < std::min((b + 1) * kRun, samples_.size() - 1); ++i) {
        const CurvePoint& from = samples_[i];
        const CurvePoint& to = samples_[i + 1];
        const double step_u = to.u - from.u;
        const double step_v = to.v - from.v;
        const double square = step_u * step_u + step_v * step_v;
        const double share =
            square > 0
                ? std::clamp(((p.u - from.u) * step_u + (p.v - from.v) * step_v) / square, 0.0, 1.0)
                : 0.0;
        const double off_u = p.u - from.u - share * step_u;
        const double off_v = p.v - from.v - share * step_v;
        const double off = off_u * off_u + off_v * off_v;
        const double along_u = (1 - share) * from.along_u + share * to.along_u;
        const double along_v = (1 - share) * from.along_v + share * to.along_v;
        const double cosine = along_u * p.along_u + along_v * p.along_v;
        if (off < best && cosine > 0) {
          best = off;
          best_box = b;
          angle = std::abs(std::atan2(along_u * p.along_v - along_v * p.along_u, cosine));
        }
      }
    }
    last_box_ = best_box;
    return {std::sqrt(best), angle};
  }

 private:
  static constexpr std::size_t kRun = 16;
  struct Box {
    double u_min, u_max, v_min, v_max;
  };
  const Samples& samples_;
  std::vector<Box> boxes_;
  std::size_t last_box_ = 0;
};

void measure(const IdealCurve& curve, const Samples& samples, Fit& fit) {
  const auto add = [&](const Samples& from, const Samples& to) {
    NearestPoint nearest(to);
    for (const CurvePoint& p : from) {
      const auto [distance, angle] = nearest(p);
      fit.distance = std::max(fit.distance, distance / curve.height);
      fit.angle_rad = std::max(fit.angle_rad, angle);
    }
  };
  add(curve.points, samples);
  add(samples, curve.points);
}

Fit spline(const IdealCurve& curve, const std::vector<CurvePoint>& points, bool b_spline) {
  const std::vector<PlanePoint> given = b_spline ? control_points(points) : held(points);
  const geometry::ContourKind kind =
      b_spline ? geometry::ContourKind::BSpline : geometry::ContourKind::CatmullRom;
  Fit fit;
  fit.pieces = given.size() - 1;
  measure(curve, samples_of_spline(given, b_spline), fit);
  fit.text = fmt::format("rotational_sweep() contour({}, kind=\"{}\", closed=false);",
                         text_of(given), geometry::name_of(kind));
  return fit;
}

Fit conics(const IdealCurve& curve, std::size_t steps) {
  const std::vector<double> sums = places(curve, steps);
  std::vector<CurvePoint> points;
  std::vector<geometry::ArcAt> arcs;
  if (curve.rim) {
    // As many steps outside and inside as the measure gives each; the arc takes the place of the
    // points on it, and ends at both sides where the wall is upright.
    const auto& [first, last, major, minor] = *curve.rim;
    const double outside = sums[first];
    const double inside = sums.back() - sums[last];
    const auto of_outside = static_cast<std::size_t>(
        std::lround(static_cast<double>(steps) * outside / (outside + inside)));
    if (of_outside < 2 || steps - of_outside < 2) {
      throw base::InputError("too few points");
    }
    points = spread(curve, sums, 0, first, of_outside);
    points.back() = {major, curve.height, -1, 0};
    arcs.push_back({points.size(), held(minor), 0});
    const auto rest = spread(curve, sums, last, sums.size() - 1, steps - of_outside);
    points.insert(points.end(), rest.begin() + 1, rest.end());
  } else {
    points = spread(curve, sums, 0, sums.size() - 1, steps);
  }
  std::vector<PlanePoint> given = held(points);
  std::vector<geometry::SlopeAt> slopes;
  std::string slopes_text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& p = points[i];
    if (!arcs.empty() && arcs.front().point == i + 1) {
      continue;
    }
    // d(u^2)/dv; at a pole, where that is 0/0, from the next of the curve's points: u^2 over v is
    // straight there but for terms of the second order in its distance, some 1e-6.
    double slope = 0;
    if (p.u > 0) {
      slope = 2 * p.u * p.along_u / p.along_v;
    } else {
      const bool at_start = i == 0;
      const CurvePoint& next = curve.points[at_start ? 1 : curve.points.size() - 2];
      slope = next.u * next.u / (next.v - p.v);
    }
    slopes.push_back({i + 1, held(slope)});
    slopes_text +=
        fmt::format("{}[{}, {}]", slopes_text.empty() ? "" : ", ", i + 1, text_of(slope));
  }
  const geometry::RevolvedProfile profile = geometry::fit_conic_spline(given, arcs, slopes);
  Fit fit;
  fit.pieces = profile.pieces().size();
  measure(curve, samples_of(profile), fit);
  fit.text = fmt::format("conic_spline_sweep({}slopes=[{}]) contour({});",
                         arcs.empty() ? ""
                                      : fmt::format("arcs=[[{}, {}, 0]], ", arcs.front().point,
                                                    number::to_text(arcs.front().radius)),
                         slopes_text, text_of(given));
  fit.profile = profile;
  return fit;
}

Fit cones(const IdealCurve& curve, const std::vector<CurvePoint>& points) {
  Fit fit;
  fit.pieces = points.size() - 1;
  measure(curve, samples_of_polygon(points), fit);
  fit.text = fmt::format("cone_stack(pieces={}) contour({}, closed=false);", fit.pieces,
                         text_of(held(points)));
  return fit;
}

// Throws base::InputError where conics cannot have these points: a piece would cross another one,
// or the axis. Of the others, that is said when the scene is read.
Fit fit_of(const IdealCurve& curve, Representation representation, std::size_t steps) {
  if (representation == Representation::Conics) {
    return conics(curve, steps);
  }
  const std::vector<double> sums = places(curve, steps);
  const std::vector<CurvePoint> points = spread(curve, sums, 0, sums.size() - 1, steps);
  return representation == Representation::Cones
             ? cones(curve, points)
             : spline(curve, points, representation == Representation::BSpline);
}

}  // namespace

const std::vector<IdealCurve>& ideal_curves() {
  static const std::vector<IdealCurve> all{make_vase(), make_glass()};
  return all;
}

std::string_view name_of(Representation representation) {
  constexpr std::array<std::string_view, 4> kNames{"catmull_rom", "bspline", "conics", "cones"};
  return kNames[static_cast<std::size_t>(representation)];
}

const Fit& least_fit(const IdealCurve& curve, Representation representation, Measure measure,
                     double limit) {
  using Rung = std::optional<Fit>;
  static std::mutex guard;
  static std::map<std::tuple<std::string, Representation, std::size_t>, Rung> ladder;
  const std::lock_guard lock(guard);
  for (std::size_t steps = 4;; steps += std::max<std::size_t>(1, steps / 33)) {
    const auto [place, is_new] = ladder.try_emplace({curve.name, representation, steps});
    Rung& rung = place->second;
    try {
      if (is_new) {
        rung = fit_of(curve, representation, steps);
      }
      if (rung && (measure == Measure::Distance ? rung->distance : rung->angle_rad) <= limit) {
        if (!rung->scene) {
          rung->scene = std::make_shared<const scene::Scene>(scene::parse_scene(
              rung->text, fmt::format("{} of {} points", name_of(representation), steps + 1)));
        }
        return *rung;
      }
    } catch (const base::InputError&) {
      rung.reset();
    }
    constexpr std::size_t kMostSteps = 20'000;
    LAMINA_REQUIRE(steps < kMostSteps, "no fit is so good");
  }
}

}  // namespace lamina::experiments
