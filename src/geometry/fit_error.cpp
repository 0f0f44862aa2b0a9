#include "geometry/fit_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

using number::nearest_double;

struct Plane {
  double x = 0;
  double y = 0;
};

Plane operator+(const Plane& a, const Plane& b) { return {a.x + b.x, a.y + b.y}; }
Plane operator-(const Plane& a, const Plane& b) { return {a.x - b.x, a.y - b.y}; }
Plane operator*(double s, const Plane& a) { return {s * a.x, s * a.y}; }
double dot(const Plane& a, const Plane& b) { return a.x * b.x + a.y * b.y; }
double cross(const Plane& a, const Plane& b) { return a.x * b.y - a.y * b.x; }
double length(const Plane& a) { return std::hypot(a.x, a.y); }

struct Sample {
  Plane point;
  Plane tangent;  // of length one, along the curve
};

struct Segment {
  Sample from;
  Sample to;
};

Sample sample(const Plane& point, const Plane& tangent) {
  return {point, (1 / length(tangent)) * tangent};
}

double value_at(const std::vector<double>& ascending, double s) {
  double sum = 0;
  for (auto c = ascending.rbegin(); c != ascending.rend(); ++c) {
    sum = sum * s + *c;
  }
  return sum;
}

std::vector<double> rounded(const std::vector<number::Rational>& coefficients) {
  std::vector<double> result;
  for (const number::Rational& c : coefficients) {
    result.push_back(nearest_double(c));
  }
  return result;
}

std::vector<double> derivative(const std::vector<double>& c) {
  std::vector<double> result;
  for (std::size_t power = 1; power < c.size(); ++power) {
    result.push_back(static_cast<double>(power) * c[power]);
  }
  return result;
}

void add_level(std::vector<Segment>& segments, const Plane& from, const Plane& to) {
  const Plane step = to - from;
  if (length(step) > 0) {
    segments.push_back({sample(from, step), sample(to, step)});
  }
}

// Along a curve that `at` gives for 0 .. 1. A step without length, at a pole, has no tangent.
template <typename SampleAt>
void add_curve(std::vector<Segment>& segments, std::size_t samples, const SampleAt& at) {
  Sample last = at(0);
  for (std::size_t i = 1; i <= samples; ++i) {
    const Sample next = at(static_cast<double>(i) / static_cast<double>(samples));
    segments.push_back({last, next});
    last = next;
  }
}

std::vector<Segment> segments_of(const Contour& contour, std::size_t samples) {
  std::vector<Segment> segments;
  for (const ContourPiece& piece : contour.pieces()) {
    const std::vector<double> u = rounded(piece.u);
    const std::vector<double> v = rounded(piece.v);
    const std::vector<double> du = derivative(u);
    const std::vector<double> dv = derivative(v);
    add_curve(segments, samples, [&](double s) {
      return sample({value_at(u, s), value_at(v, s)}, {value_at(du, s), value_at(dv, s)});
    });
  }
  return segments;
}

void add(std::vector<Segment>& segments, const Conic& conic, std::size_t samples) {
  const double low = nearest_double(conic.y_low);
  const double high = nearest_double(conic.y_high);
  // About the lower end, where nothing cancels: a pole at either end has x = 0 exactly.
  const double at_low = nearest_double(conic.square_at(conic.y_low));
  const double at_high = nearest_double(conic.square_at(conic.y_high));
  const double slope = nearest_double(conic.slope_at(conic.y_low));
  const double slope_high = nearest_double(conic.slope_at(conic.y_high));
  const double alpha = nearest_double(conic.alpha);
  add_curve(segments, samples, [&](double s) {
    const double share = (1 - std::cos(std::numbers::pi * (conic.side > 0 ? s : 1 - s))) / 2;
    const double up = (high - low) * share;
    const double down = (high - low) * (1 - share);
    const double square = share < 0.5 ? at_low + up * (slope + alpha * up)
                                      : at_high - down * (slope_high - alpha * down);
    const double x = std::sqrt(std::max(square, 0.0));
    const Plane along{share < 0.5 ? slope + 2 * alpha * up : slope_high - 2 * alpha * down, 2 * x};
    // At the apex of a cone x and its square's slope are both zero: x' is the root of alpha.
    return sample(
        {x, low + up},
        conic.side *
            (length(along) > 0 ? along : Plane{(share < 0.5 ? 1 : -1) * std::sqrt(alpha), 1.0}));
  });
}

void add(std::vector<Segment>& segments, const Arc& arc, std::size_t samples) {
  const Plane centre{nearest_double(arc.major), nearest_double(arc.height)};
  const double radius = nearest_double(arc.minor);
  const double end = std::asin(
      std::clamp(nearest_double((ends_of(arc).last - arc.height) / arc.minor), -1.0, 1.0));
  const double start = std::asin(
      std::clamp(nearest_double((ends_of(arc).first - arc.height) / arc.minor), -1.0, 1.0));
  // Angles at the centre; asin gives those of the outer side.
  double from = start;
  double to = std::numbers::pi - end;
  if (arc.part == ArcPart::Inner) {
    from = std::numbers::pi - start;
  } else if ((arc.part == ArcPart::Above) != (arc.side > 0)) {
    std::swap(from, to);
  }
  if (arc.part == ArcPart::Below) {
    (arc.side > 0 ? from : to) -= 2 * std::numbers::pi;
  }
  const double turn = to > from ? 1 : -1;
  add_curve(segments, samples, [&](double s) {
    const double angle = from + s * (to - from);
    const Plane radial{std::cos(angle), std::sin(angle)};
    return sample(centre + radius * radial, turn * Plane{-radial.y, radial.x});
  });
}

std::vector<Segment> segments_of(const RevolvedProfile& profile, std::size_t samples) {
  std::vector<Segment> segments;
  for (const ProfilePiece& piece : profile.pieces()) {
    std::vector<Segment> next;
    std::visit([&](const auto& p) { add(next, p, samples); }, piece);
    if (!segments.empty()) {
      add_level(segments, segments.back().to.point, next.front().from.point);
    }
    segments.insert(segments.end(), next.begin(), next.end());
  }
  const Plane first = segments.front().from.point;
  const Plane last = segments.back().to.point;
  // A closed profile ends at the height where it begins.
  if (first.y == last.y) {
    add_level(segments, last, first);
  } else {
    add_level(segments, {0, first.y}, first);
    add_level(segments, last, {0, last.y});
  }
  return segments;
}

struct Nearest {
  double distance = INFINITY;
  Plane tangent;
};

Nearest nearest(const Plane& point, const std::vector<Segment>& segments) {
  Nearest result;
  for (const Segment& segment : segments) {
    const Plane step = segment.to.point - segment.from.point;
    const double square = dot(step, step);
    const double share =
        square > 0 ? std::clamp(dot(point - segment.from.point, step) / square, 0.0, 1.0) : 0.0;
    const double distance = length(point - (segment.from.point + share * step));
    if (distance < result.distance) {
      result = {distance, (1 - share) * segment.from.tangent + share * segment.to.tangent};
    }
  }
  return result;
}

// Both curves go round their solids in one direction if the orientation is 1.
double angle_between(const Plane& a, const Plane& b, int orientation) {
  return std::abs(std::atan2(orientation * cross(a, b), orientation * dot(a, b)));
}

}  // namespace

FitError fit_error(const RevolvedProfile& profile, const Contour& contour, std::size_t samples) {
  LAMINA_REQUIRE(samples > 0, "no samples");
  const std::vector<Segment> fit = segments_of(profile, samples);
  const std::vector<Segment> truth = segments_of(contour, samples);
  FitError error;
  const auto add_distances = [&](const Segment& segment, const std::vector<Segment>& other) {
    for (const Sample& at : {segment.from, segment.to}) {
      error.distance = std::max(error.distance, nearest(at.point, other).distance);
    }
  };
  const int orientation = contour.orientation();
  for (const Segment& segment : truth) {
    add_distances(segment, fit);
    const Plane tangent = nearest(0.5 * (segment.from.point + segment.to.point), fit).tangent;
    error.angle_rad =
        std::max(error.angle_rad,
                 angle_between(segment.from.tangent + segment.to.tangent, tangent, orientation));
  }
  for (const Segment& segment : fit) {
    add_distances(segment, truth);
  }
  return error;
}

}  // namespace lamina::geometry
