#include "geometry/contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "number/rational.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::vector<PlanePoint>;
using Coefficients = std::vector<Rational>;

constexpr std::array kKinds{ContourKind::Line, ContourKind::BSpline, ContourKind::CatmullRom};

const Rational kTiny = number::parse_rational("1e-30");
const Rational kAlmost = number::parse_rational("1/1048576");

Rational value(const Coefficients& c, const Rational& s) {
  Rational sum = 0;
  Rational power = 1;
  for (const Rational& coefficient : c) {
    sum += coefficient * power;
    power *= s;
  }
  return sum;
}

Coefficients derivative(const Coefficients& c) {
  Coefficients result;
  for (std::size_t power = 1; power < c.size(); ++power) {
    result.push_back(c[power] * static_cast<long>(power));
  }
  return result;
}

void expect_coefficients(const ContourPiece& piece, const Coefficients& u, const Coefficients& v) {
  EXPECT_EQ(piece.u, u);
  EXPECT_EQ(piece.v, v);
}

// What the contour's constructor, or its check against the axis, says; empty if it accepts.
std::string message_of(const Points& points, ContourKind kind, bool closed, bool axis = false) {
  try {
    const Contour contour(points, kind, closed);
    if (axis) {
      contour.require_right_of_axis();
    }
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_message(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "says: " << message;
}

// Radii in [1, 2] at equal angles, on a grid of 1/1000.
Points star(base::SeededStream& stream, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double radius = stream.uniform(1, 2);
    points.push_back({Rational(std::lround(1000 * radius * std::cos(angle))) / 1000,
                      Rational(std::lround(1000 * radius * std::sin(angle))) / 1000});
  }
  return points;
}

const Points kDiamond{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
const Points kHalfRing{{0, 0}, {1, 1}, {0, 2}};

TEST(ContourTest, LinePiecesGoFromPointToPoint) {
  const Contour contour({{1, 2}, {4, 0}, {3, 7}}, ContourKind::Line, true);
  ASSERT_EQ(contour.pieces().size(), 3);
  expect_coefficients(contour.pieces()[0], {1, 3}, {2, -2});
  expect_coefficients(contour.pieces()[1], {4, -1}, {0, 7});
  expect_coefficients(contour.pieces()[2], {3, -2}, {7, -5});
}

// The hand-made polynomials of the diamond's first piece; the others follow by quarter turns.
TEST(ContourTest, BSplinePiecesOfADiamond) {
  const Rational third = Rational(1) / 3;
  const Coefficients x{Rational(2) / 3, 0, -1, third};
  const Coefficients y{0, 1, 0, -third};
  const Coefficients minus_x{Rational(-2) / 3, 0, 1, -third};
  const Coefficients minus_y{0, -1, 0, third};
  const Contour contour(kDiamond, ContourKind::BSpline, true);
  ASSERT_EQ(contour.pieces().size(), 4);
  expect_coefficients(contour.pieces()[0], x, y);
  expect_coefficients(contour.pieces()[1], minus_y, x);
  expect_coefficients(contour.pieces()[2], minus_x, minus_y);
  expect_coefficients(contour.pieces()[3], y, minus_x);
}

TEST(ContourTest, CatmullRomPiecesOfADiamond) {
  const Contour contour(kDiamond, ContourKind::CatmullRom, true);
  ASSERT_EQ(contour.pieces().size(), 4);
  expect_coefficients(contour.pieces()[0], {1, 0, -2, 1}, {0, 1, 1, -1});
  expect_coefficients(contour.pieces()[1], {0, -1, -1, 1}, {1, 0, -2, 1});
  expect_coefficients(contour.pieces()[2], {-1, 0, 2, -1}, {0, -1, -1, 1});
  expect_coefficients(contour.pieces()[3], {0, 1, 1, -1}, {-1, 0, 2, -1});
}

TEST(ContourTest, OpenContoursAreContinuedByTheirMirrorImage) {
  const Rational third = Rational(1) / 3;
  const Contour line(kHalfRing, ContourKind::Line, false);
  ASSERT_EQ(line.pieces().size(), 2);
  expect_coefficients(line.pieces()[0], {0, 1}, {0, 1});
  expect_coefficients(line.pieces()[1], {1, -1}, {1, 1});

  const Contour b_spline(kHalfRing, ContourKind::BSpline, false);
  ASSERT_EQ(b_spline.pieces().size(), 2);
  expect_coefficients(b_spline.pieces()[0], {0, 1, 0, -third}, {third, 0, 1, -third});
  expect_coefficients(b_spline.pieces()[1], {Rational(2) / 3, 0, -1, third}, {1, 1, 0, -third});

  const Contour catmull_rom(kHalfRing, ContourKind::CatmullRom, false);
  ASSERT_EQ(catmull_rom.pieces().size(), 2);
  expect_coefficients(catmull_rom.pieces()[0], {0, 1, 1, -1}, {0, 0, 2, -1});
  expect_coefficients(catmull_rom.pieces()[1], {1, 0, -2, 1}, {1, 1, 1, -1});
}

void expect_smooth_joint(const Coefficients& before, const Coefficients& after, int order) {
  Coefficients left = before;
  Coefficients right = after;
  for (int k = 0; k <= order; ++k) {
    EXPECT_EQ(value(left, 1), value(right, 0)) << "derivative " << k;
    left = derivative(left);
    right = derivative(right);
  }
}

int smoothness(ContourKind kind) {
  switch (kind) {
    case ContourKind::Line:
      return 0;
    case ContourKind::BSpline:
      return 2;
    case ContourKind::CatmullRom:
      break;
  }
  return 1;
}

TEST(ContourTest, JointsAreAsSmoothAsTheKindPromises) {
  base::SeededStream stream("geometry/contour-joints", 1, 0);
  for (const ContourKind kind : kKinds) {
    const Points points = star(stream, 12);
    const Contour contour(points, kind, true);
    ASSERT_EQ(contour.pieces().size(), 12);
    const int order = smoothness(kind);
    for (std::size_t i = 0; i < 12; ++i) {
      const ContourPiece& piece = contour.pieces()[i];
      const ContourPiece& next = contour.pieces()[(i + 1) % 12];
      EXPECT_EQ(piece.u.size(), kind == ContourKind::Line ? 2 : 4);
      expect_smooth_joint(piece.u, next.u, order);
      expect_smooth_joint(piece.v, next.v, order);
      if (kind != ContourKind::BSpline) {
        EXPECT_EQ(piece.u[0], points[i].u);
        EXPECT_EQ(piece.v[0], points[i].v);
      }
    }
  }
}

// The circle of radius r = (2 + cos a) / 3, a = 360/n degrees, that a B-spline through the corners
// of a regular n-gon begins its pieces on: for n = 64 all of it is within 1e-5 of the circle.
TEST(ContourTest, ABSplineOfARegularPolygonIsAlmostACircle) {
  Points points;
  const double step = 2 * std::numbers::pi / 64;
  for (int i = 0; i < 64; ++i) {
    points.push_back({Rational(std::cos(step * i)), Rational(std::sin(step * i))});
  }
  const Contour contour(points, ContourKind::BSpline, true);
  const double radius = (2 + std::cos(step)) / 3;
  for (const ContourPiece& piece : contour.pieces()) {
    for (int k = 0; k < 8; ++k) {
      const double u = number::nearest_double(value(piece.u, Rational(k) / 8));
      const double v = number::nearest_double(value(piece.v, Rational(k) / 8));
      EXPECT_NEAR(std::hypot(u, v), radius, k == 0 ? 1e-15 : 1e-5);
    }
  }
}

// With |f''| <= 36 on a control box of size 1, a turning point is at most 4.5/n^2 beyond the
// nearest of n + 1 samples.
void expect_tight(const Coefficients& c, const Rational& low, const Rational& high,
                  const Rational& size) {
  const int n = 64;
  Rational sampled_low = value(c, 0);
  Rational sampled_high = sampled_low;
  for (int k = 1; k <= n; ++k) {
    const Rational sample = value(c, Rational(k) / n);
    sampled_low = std::min(sampled_low, sample);
    sampled_high = std::max(sampled_high, sample);
  }
  const Rational reach = size * 9 / (2 * n * n);
  EXPECT_LE(low, sampled_low);
  EXPECT_GE(high, sampled_high);
  EXPECT_LE(sampled_low - low, reach);
  EXPECT_LE(high - sampled_high, reach);
}

TEST(ContourTest, BoxesHoldTheirPiecesTightly) {
  base::SeededStream stream("geometry/contour-boxes", 1, 0);
  for (const ContourKind kind : kKinds) {
    const Contour contour(star(stream, 20), kind, true);
    ASSERT_EQ(contour.boxes().size(), 20);
    ASSERT_EQ(contour.control_boxes().size(), 20);
    for (std::size_t i = 0; i < 20; ++i) {
      const Rectangle& box = contour.boxes()[i];
      const Rectangle& outer = contour.control_boxes()[i];
      EXPECT_TRUE(outer.u_min <= box.u_min && box.u_max <= outer.u_max);
      EXPECT_TRUE(outer.v_min <= box.v_min && box.v_max <= outer.v_max);
      expect_tight(contour.pieces()[i].u, box.u_min, box.u_max, outer.u_max - outer.u_min);
      expect_tight(contour.pieces()[i].v, box.v_min, box.v_max, outer.v_max - outer.v_min);
    }
  }
}

// v(s) = s (1 - s) (2 - s) / 2 has its maximum 1 / (3 sqrt 3) at s = 1 - 1 / sqrt 3; its Bezier
// points are 0, 1/3, 1/6, 0.
TEST(ContourTest, AnIrrationalExtremumIsEnclosed) {
  const Contour contour({{0, 0}, {1, 0}, {2, -1}, {-1, -2}}, ContourKind::CatmullRom, true);
  ASSERT_EQ(contour.pieces()[0].v,
            (Coefficients{0, 1, Rational(-3) / 2, Rational(1) / 2}));  // the case at hand
  EXPECT_EQ(contour.control_boxes()[0].v_min, 0);
  EXPECT_EQ(contour.control_boxes()[0].v_max, Rational(1) / 3);
  const Rectangle& box = contour.boxes()[0];
  EXPECT_EQ(box.v_min, 0);
  const Rational excess = Rational(1) / (3 * (number::Integer(1) << 60));
  const Rational below = box.v_max - excess;
  EXPECT_GE(Rational(27 * box.v_max * box.v_max), 1);
  EXPECT_LE(Rational(27 * below * below), 1);
}

// u(s) = s^2 - s is smallest at 1/2, exactly.
TEST(ContourTest, ARationalExtremumIsExact) {
  const Contour contour({{2, 0}, {2, 1}, {0, 1}, {0, 0}}, ContourKind::CatmullRom, true);
  EXPECT_EQ(contour.boxes()[2].u_min, Rational(-1) / 4);
  EXPECT_EQ(contour.boxes()[2].u_max, 0);
  EXPECT_EQ(contour.control_boxes()[2].u_min, Rational(-1) / 3);
}

TEST(ContourTest, TooFewPoints) {
  for (const ContourKind kind : kKinds) {
    expect_message(message_of({{1, 0}, {2, 0}}, kind, true), "needs 3 points or more, here are 2");
    expect_message(message_of({{0, 0}}, kind, false), "needs 2 points or more, here are 1");
    expect_message(message_of({}, kind, false), "needs 2 points or more, here are 0");
    EXPECT_EQ(message_of({{0, 0}, {0, 1}}, kind, false), "");
  }
}

TEST(ContourTest, EqualNeighbours) {
  for (const ContourKind kind : kKinds) {
    expect_message(message_of({{1, 0}, {2, 0}, {2, 0}, {1, 3}}, kind, true),
                   "point 3 of the contour repeats point 2");
    expect_message(message_of({{0, 0}, {2, 0}, {0, 3}, {0, 3}}, kind, false),
                   "point 4 of the contour repeats point 3");
    expect_message(message_of({{1, 0}, {2, 0}, {1, 3}, {1, 0}}, kind, true),
                   "point 4 of the contour, its last one, repeats point 1: leave the last one out");
  }
}

TEST(ContourTest, OpenContoursBeginAndEndOnTheAxis) {
  for (const ContourKind kind : kKinds) {
    expect_message(message_of({{Rational(1) / 2, 0}, {1, 1}, {0, 2}}, kind, false),
                   "begins on the axis u = 0, but point 1 has u = 0.5");
    expect_message(message_of({{0, 0}, {1, 1}, {-kTiny, 2}}, kind, false),
                   "ends on the axis u = 0, but point 3 has u = ");
  }
}

TEST(ContourTest, SimplePolygons) {
  const auto accepts = [](const Points& points) {
    EXPECT_EQ(message_of(points, ContourKind::Line, true), "");
  };
  accepts({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  accepts({{0, 0}, {1, 0}, {1, 1}});
  accepts({{0, 0}, {1, 0}, {2, 0}, {2, 2}});  // a point on a side
  accepts({{0, 3}, {-1, 1}, {-3, 0}, {-1, -1}, {0, -3}, {1, -1}, {3, 0}, {1, 1}});
  accepts({{0, 0}, {4, 0}, {4, 4}, {2, kTiny}, {0, 4}});          // a corner just off a side
  accepts({{0, 0}, {1, 0}, {1 - kTiny, kTiny * kTiny}, {0, 1}});  // almost a spike
}

TEST(ContourTest, PolygonsThatCrossOrTouchThemselves) {
  const auto rejects = [](const Points& points, const std::string& part) {
    expect_message(message_of(points, ContourKind::Line, true), part);
  };
  rejects({{0, 0}, {2, 2}, {2, 0}, {0, 2}},
          "crosses or touches itself: the piece at point 1 meets the one at point 3;");
  rejects({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, "point 1 meets the one at point 3;");
  rejects({{0, 0}, {4, 0}, {4, 4}, {2, -kTiny}, {0, 4}}, "point 1 meets the one at point 3;");
  rejects({{0, 0}, {2, 1}, {2, -1}, {0, 0}, {-2, -1}, {-2, 1}}, "meets the one at");
  rejects({{0, 0}, {2, 0}, {1, 0}, {0, 2}}, "point 1 meets the one at point 2 beyond their common");
  rejects({{0, 0}, {1, 0}, {3, 3}, {2, 0}}, "point 1 meets the one at point 4 beyond their common");
  rejects({{0, 0}, {1, 0}, {2, 0}}, "beyond their common");
  expect_message(message_of({{0, 0}, {1, 1}, {0, 0}}, ContourKind::Line, false),
                 "point 1 meets the one at point 2 beyond their common");
}

TEST(ContourTest, FigureEights) {
  const Points eight{{2, 1}, {-2, -1}, {-2, 1}, {2, -1}};
  for (const ContourKind kind : kKinds) {
    expect_message(message_of(eight, kind, true), "point 1 meets the one at point 3;");
  }
}

// Waists: a curve with a local minimum over u = 0 and its mirror image below.
Points waist(const Rational& v) {
  return {{2, 1}, {0, v}, {-2, 1}, {-2, -1}, {0, Rational(-v)}, {2, -1}};
}

TEST(ContourTest, CurvesThatTouchThemselves) {
  const auto message = [](ContourKind kind, const Rational& v) {
    return message_of(waist(v), kind, true);
  };
  EXPECT_EQ(message(ContourKind::CatmullRom, kAlmost), "");
  expect_message(message(ContourKind::CatmullRom, 0), "crosses or touches itself");
  expect_message(message(ContourKind::CatmullRom, -kAlmost), "crosses or touches itself");
  // The B-spline is at (1 + 4 v + 1) / 6 over u = 0.
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(message(ContourKind::BSpline, kAlmost - half), "");
  expect_message(message(ContourKind::BSpline, -half), "crosses or touches itself");
  expect_message(message(ContourKind::BSpline, -half - kAlmost), "crosses or touches itself");
}

// A Catmull-Rom piece from (0, 0) to (1, 0), symmetric about u = 1/2, with the derivatives
// (m, 10) and (m, -10) at its ends. u(s) has the derivative (3 - m) / 2 at s = 1/2: there is a loop
// for m > 3 and a cusp for m = 3.
Points horns(const Rational& m) { return {{1 - 2 * m, -20}, {0, 0}, {1, 0}, {2 * m, -20}}; }

TEST(ContourTest, LoopsAndCuspsOfOnePiece) {
  EXPECT_EQ(message_of(horns(1), ContourKind::CatmullRom, true), "");
  EXPECT_EQ(message_of(horns(3 - kAlmost), ContourKind::CatmullRom, true), "");
  for (const Rational& m : {Rational(3), Rational(3 + kAlmost), Rational(10)}) {
    expect_message(message_of(horns(m), ContourKind::CatmullRom, true),
                   "crosses or touches itself: the piece at point 2 has a loop or a cusp");
  }
}

// A zero derivative at a joint: a corner of less than 180 degrees, or a spike.
TEST(ContourTest, SharpJointsOfACatmullRomSpline) {
  EXPECT_EQ(message_of({{0, 0}, {1, 1}, {1, 2}, {0, 3}}, ContourKind::CatmullRom, false), "");
  for (const ContourKind kind : kKinds) {
    expect_message(message_of({{0, 0}, {1, 1}, {0, 0}}, kind, false), "crosses or touches itself");
  }
}

TEST(ContourTest, StarsOfFiftyPointsAreAccepted) {
  for (std::uint64_t i = 0; i < 5; ++i) {
    base::SeededStream stream("geometry/contour-star", 1, i);
    const Points points = star(stream, 50);
    for (const ContourKind kind : kKinds) {
      EXPECT_EQ(message_of(points, kind, true), "") << "star " << i;
    }
  }
}

// The contour as a polygon of doubles, 100 to each piece, made from the basis functions.
struct Sample {
  double u;
  double v;
};

double basis_sum(ContourKind kind, const std::array<double, 4>& p, double s) {
  if (kind == ContourKind::Line) {
    return (1 - s) * p[1] + s * p[2];
  }
  if (kind == ContourKind::BSpline) {
    return (std::pow(1 - s, 3) * p[0] + (3 * s * s * s - 6 * s * s + 4) * p[1] +
            (-3 * s * s * s + 3 * s * s + 3 * s + 1) * p[2] + s * s * s * p[3]) /
           6;
  }
  // Hermite's basis with the derivatives of Catmull and Rom
  return (1 + 2 * s) * (1 - s) * (1 - s) * p[1] + s * (1 - s) * (1 - s) * (p[2] - p[0]) / 2 +
         s * s * (3 - 2 * s) * p[2] - s * s * (1 - s) * (p[3] - p[1]) / 2;
}

std::vector<Sample> sampled(const std::vector<Sample>& points, ContourKind kind) {
  const std::size_t n = points.size();
  const int steps = kind == ContourKind::Line ? 1 : 100;
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < n; ++i) {
    const Sample& a = points[(i + n - 1) % n];
    const Sample& b = points[i];
    const Sample& c = points[(i + 1) % n];
    const Sample& d = points[(i + 2) % n];
    for (int k = 0; k < steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      samples.push_back(
          {basis_sum(kind, {a.u, b.u, c.u, d.u}, s), basis_sum(kind, {a.v, b.v, c.v, d.v}, s)});
    }
  }
  return samples;
}

double turn(const Sample& a, const Sample& b, const Sample& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

bool crosses_itself(const std::vector<Sample>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      const Sample& a = polygon[i];
      const Sample& b = polygon[i + 1];
      const Sample& c = polygon[j];
      const Sample& d = polygon[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) {
        return true;
      }
    }
  }
  return false;
}

// Random points on a coarse circle, so that both answers are frequent. They are irregular enough
// that no curve comes within the samples' distance of touching itself.
TEST(ContourTest, AgreesWithASampledPolygonOnCrossings) {
  int accepted = 0;
  int rejected = 0;
  for (std::uint64_t i = 0; i < 150; ++i) {
    base::SeededStream stream("geometry/contour-crossings", 1, i);
    std::vector<Sample> rough;
    Points exact;
    for (int k = 0; k < 7; ++k) {
      const double angle = 2 * std::numbers::pi * (k + stream.uniform(-1, 1)) / 7;
      const double radius = stream.uniform(1, 5);
      rough.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      exact.push_back({Rational(rough.back().u), Rational(rough.back().v)});
    }
    for (const ContourKind kind : kKinds) {
      const bool crosses = crosses_itself(sampled(rough, kind));
      const std::string message = message_of(exact, kind, true);
      EXPECT_EQ(!message.empty(), crosses)
          << "case " << i << " kind " << static_cast<int>(kind) << ": " << message;
      ++(crosses ? rejected : accepted);
    }
  }
  EXPECT_GE(accepted, 50);
  EXPECT_GE(rejected, 50);
}

TEST(ContourTest, RightOfTheAxis) {
  for (const ContourKind kind : kKinds) {
    EXPECT_EQ(message_of({{2, 0}, {4, 0}, {4, 2}, {2, 2}}, kind, true, true), "");
    EXPECT_EQ(message_of({{0, -1}, {1, -1}, {1, 1}, {0, 1}}, kind, false, true), "");
    EXPECT_EQ(message_of({{0, 0}, {0, 1}}, kind, false, true), "");
    expect_message(message_of(kDiamond, kind, true, true),
                   "crosses the axis u = 0 near point 2, between it and point 3");
  }
  const Points touching{{1, 0}, {3, 0}, {0, 2}};
  EXPECT_EQ(message_of(touching, ContourKind::Line, true, true), "");
  const Points crossing{{1, 0}, {3, 0}, {-kTiny, 2}};
  expect_message(message_of(crossing, ContourKind::Line, true, true),
                 "crosses the axis u = 0 near point 2, between it and point 3");
  expect_message(message_of({{-1, 0}, {1, 2}, {2, 1}}, ContourKind::Line, true, true),
                 "near point 1,");
}

// Between its points at u = d the Catmull-Rom spline is at d - s + s^2, down to d - 1/4. A B-spline
// stays right of its points.
TEST(ContourTest, OvershootingLeftOfTheAxis) {
  const auto message = [](ContourKind kind, const Rational& d) {
    return message_of({{d + 2, 0}, {d + 2, 1}, {d, 1}, {d, 0}}, kind, true, true);
  };
  const Rational quarter = Rational(1) / 4;
  EXPECT_EQ(message(ContourKind::CatmullRom, quarter), "");
  EXPECT_EQ(message(ContourKind::BSpline, 0), "");
  EXPECT_EQ(message(ContourKind::Line, 0), "");
  for (const Rational& d : {Rational(quarter - kTiny), Rational(0)}) {
    expect_message(message(ContourKind::CatmullRom, d), "crosses the axis u = 0 near point 3");
  }
}

}  // namespace
}  // namespace lamina::geometry
