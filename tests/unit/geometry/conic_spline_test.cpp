#include "geometry/conic_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "number/rational.hpp"
#include "support/class_tally.hpp"
#include "support/glass.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;
using Points = std::vector<PlanePoint>;
using Arcs = std::vector<ArcAt>;
using Slopes = std::vector<SlopeAt>;

// An end of a piece: (y, x^2) and the direction there, up to a positive factor, of (x^2, y) as the
// profile goes.
struct End {
  Rational y;
  Rational square;
  Rational square_step;
  Rational y_step;
};

struct BothEnds {
  End first;
  End last;
};

Rational value(const Conic& c, const Rational& y) { return c.alpha * y * y + c.beta * y + c.gamma; }
Rational slope(const Conic& c, const Rational& y) { return c.alpha * y + c.alpha * y + c.beta; }

End end_of(const Conic& c, const Rational& y) {
  return {y, value(c, y), c.side * slope(c, y), c.side};
}

BothEnds both_ends(const Conic& c) {
  const End low = end_of(c, c.y_low);
  const End high = end_of(c, c.y_high);
  return c.side > 0 ? BothEnds{low, high} : BothEnds{high, low};
}

// The exact root of a square of a rational.
Rational root(const Rational& square) {
  const Rational result(sqrt(numerator(square)), sqrt(denominator(square)));
  EXPECT_EQ(result * result, square);
  return result;
}

// On the circle at that height, at the larger x or the smaller one.
End on_circle(const Arc& arc, const Rational& y, bool outer, bool counter_clockwise) {
  const Rational dy = y - arc.height;
  const Rational width = root(arc.minor * arc.minor - dy * dy);
  const Rational dx = outer ? width : Rational(-width);
  const Rational x = arc.major + dx;
  const int turn = counter_clockwise ? 1 : -1;
  return {y, x * x, turn * 2 * x * -dy, turn * dx};
}

BothEnds both_ends(const Arc& arc) {
  if (arc.part == ArcPart::Inner) {
    const End low = on_circle(arc, arc.y_low, false, arc.side < 0);
    const End high = on_circle(arc, arc.y_high, false, arc.side < 0);
    return arc.side > 0 ? BothEnds{low, high} : BothEnds{high, low};
  }
  const bool above = arc.part == ArcPart::Above;
  const bool turns_left = arc.side > 0;
  const Rational& y = above ? arc.y_low : arc.y_high;
  const bool outer_first = above == turns_left;
  return {on_circle(arc, y, outer_first, turns_left), on_circle(arc, y, !outer_first, turns_left)};
}

BothEnds both_ends(const ProfilePiece& piece) {
  return std::visit([](const auto& p) { return both_ends(p); }, piece);
}

void expect_smooth(const RevolvedProfile& profile) {
  for (std::size_t i = 1; i < profile.pieces().size(); ++i) {
    SCOPED_TRACE(i);
    const End a = both_ends(profile.pieces()[i - 1]).last;
    const End b = both_ends(profile.pieces()[i]).first;
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.square, b.square);
    EXPECT_EQ(a.square_step * b.y_step, b.square_step * a.y_step);
    EXPECT_GT(a.square_step * b.square_step + a.y_step * b.y_step, 0);
  }
}

std::size_t arc_count(const RevolvedProfile& profile) {
  return static_cast<std::size_t>(
      std::count_if(profile.pieces().begin(), profile.pieces().end(),
                    [](const ProfilePiece& piece) { return std::holds_alternative<Arc>(piece); }));
}

// Whether a point is an end of a piece, or the top or bottom of an arc.
bool goes_through(const RevolvedProfile& profile, const PlanePoint& point) {
  return std::any_of(
      profile.pieces().begin(), profile.pieces().end(), [&](const ProfilePiece& piece) {
        const Arc* arc = std::get_if<Arc>(&piece);
        if (arc != nullptr && arc->part != ArcPart::Inner) {
          const bool above = arc->part == ArcPart::Above;
          return point == PlanePoint{arc->major,
                                     above ? arc->height + arc->minor : arc->height - arc->minor};
        }
        const auto [first, last] = both_ends(piece);
        return (point.v == first.y && point.u * point.u == first.square) ||
               (point.v == last.y && point.u * point.u == last.square);
      });
}

std::vector<Conic> conics(const RevolvedProfile& profile) {
  std::vector<Conic> result;
  for (const ProfilePiece& piece : profile.pieces()) {
    result.push_back(std::get<Conic>(piece));
  }
  return result;
}

std::string message_of(const Points& points, const Arcs& arcs = {}, const Slopes& slopes = {}) {
  try {
    fit_conic_spline(points, arcs, slopes);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_message(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "says: " << message;
}

TEST(ConicSplineTest, MakesTheGlassOfTwentyFiveQuadricsAndOneTorus) {
  const RevolvedProfile glass = fit_conic_spline(glass_points(), glass_arcs());
  EXPECT_EQ(glass.pieces().size(), 26U);
  EXPECT_EQ(arc_count(glass), 1U);
  for (const PlanePoint& point : glass_points()) {
    EXPECT_TRUE(goes_through(glass, point)) << point.u << " " << point.v;
  }
  expect_smooth(glass);
}

// Radii and heights as they are written, in tenths.
Points tenths(const std::vector<std::array<int, 2>>& written) {
  Points points;
  for (const auto& [x, y] : written) {
    points.push_back({Rational(x, 10), Rational(y, 10)});
  }
  return points;
}

void expect_all(const RevolvedProfile& profile, const Rational& alpha, const Rational& beta,
                const Rational& gamma) {
  for (const Conic& c : conics(profile)) {
    EXPECT_EQ(c.alpha, alpha);
    EXPECT_EQ(c.beta, beta);
    EXPECT_EQ(c.gamma, gamma);
  }
}

TEST(ConicSplineTest, IsTheConicThatThePointsAreOn) {
  // The sphere of radius 25.
  expect_all(fit_conic_spline(Points{{7, -24}, {15, -20}, {20, -15}, {24, -7}}, {}), -1, 0, 625);
  // The cone x = 2y + 1.
  expect_all(fit_conic_spline(Points{{1, 0}, {3, 1}, {7, 3}, {9, 4}}, {}), 4, 4, 1);
  // The cylinder of radius 2.
  expect_all(fit_conic_spline(Points{{2, 0}, {2, 1}}, {}), 0, 0, 4);
}

TEST(ConicSplineTest, TakesSlopesThatAreGiven) {
  const Points sphere{{0, -25}, {7, -24}, {24, -7}, {24, 7}, {7, 24}, {0, 25}};
  Slopes slopes;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    slopes.push_back({i + 1, -2 * sphere[i].v});
  }
  const RevolvedProfile profile = fit_conic_spline(sphere, {}, slopes);
  EXPECT_EQ(profile.pieces().size(), 10U);
  expect_all(profile, -1, 0, 625);
}

TEST(ConicSplineTest, PutsTheKnotWhereTheTangentsMeet) {
  // In (y, X): through (1, 1) with slope 2, and through (3, 9) with slope 7. The secant has
  // slope 4.
  const RevolvedProfile profile =
      fit_conic_spline(Points{{1, 1}, {3, 3}}, {}, Slopes{{1, 2}, {2, 7}});
  const std::vector<Conic> pieces = conics(profile);
  ASSERT_EQ(pieces.size(), 2U);
  const Rational knot = pieces[0].y_high;
  EXPECT_EQ(1 + 2 * (knot - 1), 9 + 7 * (knot - 3));
  EXPECT_EQ(slope(pieces[0], knot), 4);
  expect_smooth(profile);
}

TEST(ConicSplineTest, HasTheSlopesOfItsArcs) {
  // The tangent of half the angle is 1/2, so its cosine is 3/5 and its sine 4/5.
  const RevolvedProfile profile =
      fit_conic_spline(tenths({{100, 0}, {90, 100}, {0, 50}}), Arcs{{2, 1, Rational(1) / 2}});
  ASSERT_EQ(profile.pieces().size(), 4U);
  const Arc arc = std::get<Arc>(profile.pieces()[2]);
  EXPECT_EQ(arc, (Arc{9, 1, 9, Rational(49) / 5, 10, ArcPart::Above, 1, 1}));
  // dx/dy = -4/3 on the outer side, where x = 9.6.
  const Conic before = std::get<Conic>(profile.pieces()[1]);
  EXPECT_EQ(value(before, before.y_high), Rational(48 * 48) / 25);
  EXPECT_EQ(slope(before, before.y_high), 2 * Rational(48) / 5 * -4 / 3);
  expect_smooth(profile);
}

TEST(ConicSplineTest, TouchesTheAxisWithAnArc) {
  // A drop with tips at both ends.
  const Points drop = tenths({{0, 0}, {10, 30}, {25, 50}, {12, 65}, {0, 100}});
  const Rational third = Rational(1) / 3;
  const RevolvedProfile profile = fit_conic_spline(drop, Arcs{{1, 2, third}, {5, 3, third}});
  EXPECT_EQ(profile.pieces().size(), 8U);
  ASSERT_EQ(arc_count(profile), 2U);
  // The cosine is 4/5, the sine 3/5.
  EXPECT_EQ(std::get<Arc>(profile.pieces().front()),
            (Arc{2, 2, 0, 0, Rational(6) / 5, ArcPart::Inner, 1, 1}));
  EXPECT_EQ(std::get<Arc>(profile.pieces().back()),
            (Arc{3, 3, 10, Rational(41) / 5, 10, ArcPart::Inner, 1, 4}));
  for (const PlanePoint& point : drop) {
    EXPECT_TRUE(goes_through(profile, point)) << point.u << " " << point.v;
  }
  expect_smooth(profile);
}

TEST(ConicSplineTest, IsSmoothThroughRandomTurns) {
  support::ClassTally reached({"tip above", "tip below", "one conic", "two conics"});
  for (std::uint64_t case_id = 0; case_id < 200; ++case_id) {
    base::SeededStream stream("geometry/conic_spline_turns", 0, case_id);
    const auto jitter = [&] { return Rational(stream.integer(-25, 25), 100); };
    // From outside in, two steps of height 3 each between turns, from a level below all of them.
    Points points;
    Arcs arcs;
    const std::int64_t chain_count = stream.integer(2, 5);
    for (std::int64_t chain = 0; chain < chain_count; ++chain) {
      for (int step = chain == 0 ? 0 : 1; step <= 2; ++step) {
        const int y = points.empty() ? -1 : 3 * (chain % 2 == 0 ? step : 2 - step);
        points.push_back({14 - 2 * chain - step + jitter(), y + jitter()});
      }
      if (chain + 1 < chain_count) {
        arcs.push_back({points.size(), Rational(stream.integer(10, 40), 100),
                        Rational(stream.integer(-10, 30), 100)});
        reached.add(chain % 2 == 0 ? "tip above" : "tip below");
      }
    }
    SCOPED_TRACE(case_id);
    try {
      const RevolvedProfile profile = fit_conic_spline(points, arcs);
      EXPECT_EQ(arc_count(profile), arcs.size());
      const bool regular = profile.pieces().size() == 2 * (points.size() - 1);
      reached.add(regular ? "one conic" : "two conics");
      EXPECT_LE(profile.pieces().size(), 2 * (points.size() - 1) + arcs.size());
      expect_smooth(profile);
      for (const PlanePoint& point : points) {
        EXPECT_TRUE(goes_through(profile, point)) << point.u << " " << point.v;
      }
    } catch (const base::InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_TRUE(reached.each_at_least(10)) << reached;
}

// At equal or unequal steps on a curve.
template <typename RadiusAt>
Points random_points(base::SeededStream& stream, const RadiusAt& radius_at) {
  Points points;
  Rational y = 1;
  for (std::int64_t i = stream.integer(2, 9); i >= 0; --i) {
    points.push_back({radius_at(y), y});
    y += Rational(stream.integer(1, 60), 20);
  }
  return points;
}

TEST(ConicSplineTest, RisesWhereThePointsRise) {
  for (std::uint64_t case_id = 0; case_id < 300; ++case_id) {
    base::SeededStream stream("geometry/conic_spline_rise", 0, case_id);
    Rational x = 0;
    const Points points = random_points(stream, [&](const Rational&) {
      x += Rational(stream.integer(1, 1000), stream.integer(1, 1000));
      return x;
    });
    SCOPED_TRACE(case_id);
    for (const Conic& c : conics(fit_conic_spline(points, {}))) {
      EXPECT_GE(slope(c, c.y_low), 0);  // linear in between
      EXPECT_GE(slope(c, c.y_high), 0);
    }
  }
}

TEST(ConicSplineTest, BendsAsThePointsBend) {
  for (std::uint64_t case_id = 0; case_id < 300; ++case_id) {
    base::SeededStream stream("geometry/conic_spline_bend", 0, case_id);
    const Rational a(stream.integer(0, 100), 10);
    SCOPED_TRACE(case_id);
    // The square of y (y + a) is convex for y > 0; that of y / (y + 1) concave for y > 1/2, since
    // its second derivative is (2 - 4y) / (y + 1)^4.
    const Points convex = random_points(stream, [&](const Rational& y) { return y * (y + a); });
    for (const Conic& c : conics(fit_conic_spline(convex, {}))) {
      EXPECT_GE(c.alpha, 0);
    }
    const Points concave =
        random_points(stream, [](const Rational& y) { return Rational(y / (y + 1)); });
    for (const Conic& c : conics(fit_conic_spline(concave, {}))) {
      EXPECT_LE(c.alpha, 0);
    }
  }
}

TEST(ConicSplineTest, RefusesPointsByTheirNumbers) {
  expect_message(message_of({{1, 0}}), "2 points or more, here are 1");
  expect_message(message_of({{1, 0}, {-1, 2}}), "point 2 of the profile has x = -1");
  expect_message(message_of({{1, 0}, {0, 2}, {1, 3}}), "point 2 of the profile has x = 0");
  expect_message(message_of({{1, 0}, {1, 2}, {1, 2}}), "point 3 of the profile repeats point 2");
  expect_message(message_of({{1, 0}, {1, 2}, {3, 2}}), "points 2 and 3 of the profile are both at");
}

TEST(ConicSplineTest, RefusesArcsByTheirPoints) {
  const Points cup = tenths({{30, 0}, {40, 20}, {40, 60}, {30, 20}, {0, 10}});
  const Rational r = Rational(1) / 2;
  EXPECT_EQ(message_of(cup, {{3, r, 0}}), "");
  expect_message(message_of(cup), "turns at point 3");
  expect_message(message_of(cup, {{3, r, 0}, {2, r, 0}}), "does not turn at point 2");
  expect_message(message_of(cup, {{3, r, 0}, {3, r, 0}}),
                 "point 3 of the profile has an arc twice");
  expect_message(message_of(cup, {{6, r, 0}}), "no point 6 for an arc");
  expect_message(message_of(cup, {{0, r, 0}}), "no point 0 for an arc");
  expect_message(message_of(cup, {{3, 0, 0}}), "point 3 of the profile has radius 0");
  expect_message(message_of(cup, {{3, 4, 0}}), "point 3 of the profile has radius 4");
  expect_message(message_of(cup, {{3, r, 1}}), "point 3 of the profile has half_angle 1");
  expect_message(message_of(cup, {{3, r, 0}, {1, r, 0}}), "point 1 of the profile is at its end");
  expect_message(message_of(cup, {{3, r, 0}, {5, r, 0}}), "point 5 of the profile, on the axis");
  expect_message(message_of(tenths({{30, 0}, {40, 58}, {40, 60}, {30, 20}}), {{3, r, 0}}),
                 "between points 2 and 3 of the profile reaches past");
  expect_message(message_of(tenths({{30, 0}, {40, 60}, {30, 58}}), {{2, r, 0}}),
                 "between points 2 and 3 of the profile reaches past");
  expect_message(message_of(tenths({{30, 0}, {40, 60}, {35, 30}}), {{2, r, 0}}),
                 "turns back on itself at point 2");
}

TEST(ConicSplineTest, RefusesSlopesByTheirPoints) {
  const Points cup = tenths({{30, 0}, {40, 20}, {40, 60}, {30, 20}, {0, 10}});
  const Arcs rim{{3, Rational(1) / 2, 0}};
  expect_message(message_of(cup, rim, {{3, 0}}), "point 3 of the profile has a slope and an arc");
  expect_message(message_of(cup, rim, {{2, 0}, {2, 0}}),
                 "point 2 of the profile has a slope twice");
  expect_message(message_of(cup, rim, {{9, 0}}), "no point 9 for a slope");
  expect_message(message_of(cup, rim, {{5, -1}}), "between points 4 and 5 the profile reaches");
  expect_message(message_of({{0, 0}, {0, 1}}), "between points 1 and 2 the profile reaches");
  expect_message(message_of({{1, 0}, {1, 1}}, {}, {{1, -9}, {2, 9}}),
                 "between points 1 and 2 the profile reaches");
}

TEST(ConicSplineTest, RefusesAProfileTheWrongWayRound) {
  Points points = glass_points();
  std::reverse(points.begin(), points.end());
  expect_message(message_of(points, {{5, Rational(1) / 10, 0}}), "wrong side");
}

}  // namespace
}  // namespace lamina::geometry
