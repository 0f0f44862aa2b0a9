#include "scene/sweep_families.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "base/contract.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::scene {

using base::SeededStream;
using geometry::ContourKind;
using geometry::PlanePoint;
using number::Rational;
using surface::Sweep;

namespace {

Sweep sweep_named(const std::string& text) {
  word(text, {"translational", "conic", "rotational"});
  return text == "translational" ? Sweep::Translational
         : text == "conic"       ? Sweep::Conic
                                 : Sweep::Rotational;
}

struct Spline {
  std::vector<PlanePoint> points;
  ContourKind kind;
};

// Around a point right of the axis, in coordinates that few floats hold: multiples of 1/100.
Spline random_spline(Sweep sweep, SeededStream& stream) {
  const auto hundredths = [](double x) { return Rational(std::lround(100 * x), 100); };
  for (;;) {
    const std::int64_t count = stream.integer(5, 9);
    Spline spline{{}, stream.chance(0.5) ? ContourKind::BSpline : ContourKind::CatmullRom};
    for (std::int64_t i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
      const double radius = stream.uniform(0.5, 1.5);
      spline.points.push_back(
          {2 + hundredths(radius * std::cos(angle)), hundredths(radius * std::sin(angle))});
    }
    try {
      surface::SweptSurface(
          sweep, std::make_shared<const geometry::Contour>(spline.points, spline.kind, true));
      return spline;
    } catch (const base::InputError&) {
      // It crosses itself, or the axis: draw another.
    }
  }
}

// With coordinates times these.
std::string text_of(Sweep sweep, const Spline& spline, int times_u, int times_v) {
  std::vector<std::string> points;
  for (const PlanePoint& p : spline.points) {
    points.push_back(
        fmt::format("[{}, {}]", number::to_text(times_u * p.u), number::to_text(times_v * p.v)));
  }
  return fmt::format("{}() contour([{}], kind=\"{}\");", name_of(sweep), fmt::join(points, ", "),
                     name_of(spline.kind));
}

std::string again(Sweep sweep, const Spline& spline, const std::string& how) {
  const bool turned = sweep == Sweep::Rotational;
  if (how == "mirrored") {
    return turned ? "mirror([0, 0, 1]) " + text_of(sweep, spline, 1, -1)
                  : "mirror([1, 0, 0]) " + text_of(sweep, spline, -1, 1);
  }
  if (how == "scaled") {
    return (turned ? "scale(1/3) " : "scale([1/3, 1/3, 1]) ") + text_of(sweep, spline, 3, 3);
  }
  return text_of(sweep, spline, 1, 1);
}

FamilyMember pair(const std::string& op, const Parameters& parameters, std::uint64_t seed,
                  std::uint64_t case_id) {
  const Sweep sweep = sweep_named(parameters[0]);
  const std::string& how = word(parameters[1], {"same", "mirrored", "scaled"});
  SeededStream stream("scene/sweep_" + op, seed, case_id);
  const Placement placement(stream);
  const Spline spline = random_spline(sweep, stream);
  return placed_member(placement,
                       fmt::format("{}() {{\n  material(\"a\") {}\n  material(\"b\") {}\n}}", op,
                                   text_of(sweep, spline, 1, 1), again(sweep, spline, how)));
}

}  // namespace

FamilyMember sweep_sum(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  return pair("add", parameters, seed, case_id);
}

FamilyMember sweep_difference(const Parameters& parameters, std::uint64_t seed,
                              std::uint64_t case_id) {
  return pair("difference", parameters, seed, case_id);
}

FamilyMember sweep_halves(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const Sweep sweep = sweep_named(parameters[0]);
  SeededStream stream("scene/sweep_halves", seed, case_id);
  const Placement placement(stream);
  const std::string text = text_of(sweep, random_spline(sweep, stream), 1, 1);
  // Turned, the contour goes around the height 0; else the sweep is between 0 and 1.
  const Length z = sweep == Sweep::Rotational ? Length{stream.integer(-2, 2), 7}
                                              : Length{stream.integer(2, 5), 7};
  FamilyMember member = placed_member(
      placement, fmt::format("add() {{\n"
                             "  intersection() {{\n    material(\"a\") {}\n"
                             "    material(\"a\") halfspace([0, 0, 1], {});\n  }}\n"
                             "  intersection() {{\n    material(\"b\") {}\n"
                             "    material(\"b\") halfspace([0, 0, -1], {});\n  }}\n}}",
                             text, z.text(), text, (-z).text()));
  const geometry::Vector3<double> corner = placement.apply({-4, -4, z.value()});
  member.patches.push_back({corner, placement.apply({4, -4, z.value()}) - corner,
                            placement.apply({-4, 4, z.value()}) - corner});
  return member;
}

FamilyMember jointed_glass(const Parameters& /*parameters*/, std::uint64_t seed,
                           std::uint64_t case_id) {
  // The control points but for the first, the rim and the last, where there is no joint across.
  constexpr std::array<std::array<double, 2>, 11> kJoints{{{3.4, 0.2},
                                                           {1.2, 0.6},
                                                           {0.5, 1.4},
                                                           {0.4, 4},
                                                           {0.5, 7},
                                                           {2.2, 8.2},
                                                           {3.3, 10},
                                                           {3.8, 12.5},
                                                           {3.55, 12.5},
                                                           {3, 10},
                                                           {1.9, 8.4}}};
  SeededStream stream("scene/jointed_glass", seed, case_id);
  const Placement placement(stream);
  FamilyMember member = placed_member(
      placement,
      "material(\"glass\") conic_spline_sweep(arcs=[[10, 0.1, 0]]) contour([[3.6, 0], [3.4, 0.2], "
      "[1.2, 0.6], [0.5, 1.4], [0.4, 4], [0.5, 7], [2.2, 8.2], [3.3, 10], [3.8, 12.5], [3.9, 16], "
      "[3.55, 12.5], [3, 10], [1.9, 8.4], [0, 7.6]]);");
  for (const auto& [radius, height] : kJoints) {
    // Around the wall, from inside of it.
    const geometry::Vector3<double> corner = placement.apply({0.8 * radius, 0, height});
    member.patches.push_back({corner, placement.apply({1.05 * radius, 0, height}) - corner,
                              placement.apply({0.8 * radius, 0.2 * radius, height}) - corner});
  }
  return member;
}

}  // namespace lamina::scene
