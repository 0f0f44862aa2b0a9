#include "scene/stress_families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contract.hpp"
#include "scene/placement.hpp"

namespace lamina::scene {
namespace {

using base::SeededStream;
using number::Rational;
using Point = geometry::Vector3<double>;

constexpr const char* kHalfWidth = "50";  // of what is wide

// The half-spaces of a solid around the origin, each equation times `factor`.
std::string from_equations(const std::string& solid, const Length& radius, int factor) {
  const Rational r(radius.numerator, radius.denominator);
  const auto n = [factor](const Rational& value) {
    return number::to_text(Rational(value * factor));
  };
  const auto diagonal = [&](const Rational& x, const Rational& y, const Rational& z,
                            const Rational& w) {
    return fmt::format("quadric([[{}, 0, 0, 0], [0, {}, 0, 0], [0, 0, {}, 0], [0, 0, 0, {}]]); ",
                       n(x), n(y), n(z), n(w));
  };
  const auto plane = [&](int x, int y, int z) {
    return fmt::format("halfspace([{}, {}, {}], {}); ", n(x), n(y), n(z), n(r));
  };
  const std::string caps = plane(0, 0, 1) + plane(0, 0, -1);
  if (solid == "sphere") {
    return diagonal(1, 1, 1, -r * r);
  }
  if (solid == "box") {
    return "intersection() { " + caps + plane(1, 0, 0) + plane(-1, 0, 0) + plane(0, 1, 0) +
           plane(0, -1, 0) + "}";
  }
  // The cone has its apex in the lower cap plane's middle: x^2 + y^2 <= ((z + r) / 2)^2.
  const std::string side = solid == "cylinder"
                               ? diagonal(1, 1, 0, -r * r)
                               : fmt::format(
                                     "quadric([[{0}, 0, 0, 0], [0, {0}, 0, 0], [0, 0, {1}, {2}], "
                                     "[0, 0, {2}, {3}]]); ",
                                     n(4), n(-1), n(-r), n(-r * r));
  return "intersection() { " + side + caps + "}";
}

// A solid around the origin, with lengths times `factor`.
class RandomSolid {
 public:
  RandomSolid(std::string solid, SeededStream& stream) : solid_(std::move(solid)) {
    for (Length& length : lengths_) {
      length = random_length(stream, 1, 3);
    }
  }

  [[nodiscard]] std::string text(std::int64_t factor) const {
    const auto length = [&](std::size_t i) { return (lengths_[i] * factor).text(); };
    if (solid_ == "box") {
      return fmt::format("cube([{}, {}, {}], center=true);", length(0), length(1), length(2));
    }
    if (solid_ == "cylinder") {
      return fmt::format("cylinder(h={}, r={}, center=true);", length(0), length(1));
    }
    if (solid_ == "cone") {
      return fmt::format("cylinder(h={}, r1={}, r2={}, center=true);", length(0), length(1),
                         (lengths_[1] * factor / 4).text());
    }
    if (solid_ == "sphere") {
      return fmt::format("sphere({});", length(0));
    }
    return fmt::format("torus({}, {});", length(0), (lengths_[0] * factor / 4).text());
  }

 private:
  std::string solid_;
  std::array<Length, 3> lengths_;
};

std::string wide(const Rational& from, const Rational& height) {
  return fmt::format("translate([-{0}, -{0}, {1}]) cube([100, 100, {2}]);", kHalfWidth,
                     number::to_text(from), number::to_text(height));
}

}  // namespace

FamilyMember self_sum(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& solid = word(parameters[0], {"box", "cylinder", "cone", "sphere", "torus"});
  const std::string& second = word(parameters[1], {"same", "scaled"});
  SeededStream stream("scene/self-sum/" + solid, seed, case_id);
  const Placement placement(stream);
  const RandomSolid random(solid, stream);
  return placed_member(
      placement, fmt::format("add() {{\n  material(\"first\") {}\n  material(\"second\") {}\n}}",
                             random.text(1),
                             second == "same" ? random.text(1) : "scale(1/3) " + random.text(3)));
}

FamilyMember self_difference(const Parameters& parameters, std::uint64_t seed,
                             std::uint64_t case_id) {
  const std::string& solid = word(parameters[0], {"box", "cylinder", "cone", "sphere"});
  const std::string& equation = word(parameters[1], {"same", "scaled"});
  SeededStream stream("scene/self-difference/" + solid, seed, case_id);
  const Placement placement(stream);
  const Length radius = random_length(stream, 1, 3);
  return placed_member(
      placement, fmt::format("difference() {{\n  {}\n  {}\n}}", from_equations(solid, radius, 1),
                             from_equations(solid, radius, equation == "same" ? 1 : 3)));
}

FamilyMember touching_stack(const Parameters& parameters, std::uint64_t seed,
                            std::uint64_t case_id) {
  constexpr std::int64_t kMost = 100'000;
  const std::int64_t cubes = whole(parameters[0], 1, kMost);
  SeededStream stream("scene/touching-stack", seed, case_id);
  const Placement placement(stream);
  std::string text = "add() {\n";
  for (std::int64_t i = 0; i < cubes; ++i) {
    text += fmt::format("  material(\"{}\") translate([0, 0, {}]) cube(1);\n",
                        i % 2 == 0 ? "even" : "odd", i);
  }
  return placed_member(placement, text + "}");
}

FamilyMember thin_wall(const Parameters&, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/thin-wall", seed, case_id);
  return placed_member(Placement(stream),
                       "difference() {\n  sphere(2);\n  translate([0, 0, 1/2]) sphere(3/2);\n}");
}

namespace {

// n.p <= offset for n = (1, 2, 3), or n.p >= offset, the equation times a random small integer.
std::string below_plane(const Rational& offset, SeededStream& stream, int sign = 1) {
  const std::int64_t factor = sign * stream.integer(1, 9);
  return fmt::format("halfspace([{}, {}, {}], {});", factor, 2 * factor, 3 * factor,
                     number::to_text(Rational(factor * offset)));
}

const Rational kTop = 7;  // the plane n.p = 7, around (1/2, 1, 3/2)

FamilyMember on_the_plane(std::string text) {
  // Sides along the plane of length 2.
  const double a = 2 / std::sqrt(5.0);
  const double b = 2 / std::sqrt(70.0);
  const Point side1{2 * a, -a, 0};
  const Point side2{3 * b, 6 * b, -5 * b};
  const Point middle{0.5, 1, 1.5};
  return {std::move(text),
          {{middle - 0.5 * side1 - 0.5 * side2, side1, side2}},
          [](const Point& p) { return p; }};
}

}  // namespace

FamilyMember cleared_face(const Parameters&, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/cleared-face", seed, case_id);
  // In units of n.p, which are 1 / sqrt(14) long: the slab is 1.6 to 2.7 thick, the ball in it has
  // radius 1/4.
  const Length depth{stream.integer(42, 70), 7};
  const Length up = depth / 28;  // of the ball's middle, along n
  const std::string a = below_plane(kTop, stream);
  const std::string b_floor = below_plane(kTop, stream, -1);
  const std::string b_roof =
      below_plane(kTop + Rational(depth.numerator, depth.denominator), stream);
  return on_the_plane(fmt::format(
      "difference() {{\n  add() {{\n    material(\"A\") {}\n    material(\"C\") translate([{}, {}, "
      "{}]) sphere(1/4);\n  }}\n  material(\"B\") intersection() {{ {} {} }}\n}}\n",
      a, (Length{1, 2} + up).text(), (Length{1, 1} + up * 2).text(), (Length{3, 2} + up * 3).text(),
      b_floor, b_roof));
}

// The i-th of so many slabs whose tops lie in the plane; all depths differ.
std::string slab_below(std::int64_t i, std::int64_t count, SeededStream& stream) {
  const Length depth{count * stream.integer(2, 12) + i, 7};
  const std::string top = below_plane(kTop, stream);
  const std::string bottom =
      below_plane(kTop - Rational(depth.numerator, depth.denominator), stream, -1);
  return fmt::format("intersection() {{ {} {} }}", top, bottom);
}

FamilyMember glass_stack(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/glass-stack", seed, case_id);
  const std::int64_t count = whole(parameters[0], 1, 20);
  std::string slabs;
  for (std::int64_t i = 0; i < count; ++i) {
    slabs += fmt::format("  material(\"glass{}\", color=[0.9, 0.9, 0.9, 1/2]) {}\n", i + 1,
                         slab_below(i, count, stream));
  }
  return on_the_plane("add() {\n" + slabs + "}\n");
}

FamilyMember same_medium(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& shape = word(parameters[0], {"left", "right", "flat"});
  const std::int64_t count = whole(parameters[1], 2, 12);
  SeededStream stream("scene/same-medium", seed, case_id);
  std::vector<std::string> slabs;
  for (std::int64_t i = 0; i < count; ++i) {
    slabs.push_back(
        fmt::format("material(\"{}\") {}\n", i % 2 == 0 ? "a" : "b", slab_below(i, count, stream)));
  }
  if (shape == "flat") {
    return on_the_plane(fmt::format("add() {{\n{}}}\n", fmt::join(slabs, "")));
  }
  if (shape == "left") {
    std::string sum = slabs[0];
    for (std::size_t i = 1; i < slabs.size(); ++i) {
      sum = fmt::format("add() {{\n{}{}}}\n", sum, slabs[i]);
    }
    return on_the_plane(sum);
  }
  std::string sum = slabs.back();
  for (std::size_t i = slabs.size() - 1; i-- > 0;) {
    sum = fmt::format("add() {{\n{}{}}}\n", slabs[i], sum);
  }
  return on_the_plane(sum);
}

FamilyMember slab(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/slab", seed, case_id);
  return placed_member(Placement(stream), wide(0, positive(parameters[0])));
}

FamilyMember gap(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/gap", seed, case_id);
  return placed_member(
      Placement(stream),
      fmt::format("add() {{\n  material(\"lower\") {}\n  material(\"upper\") {}\n}}", wide(-1, 1),
                  wide(positive(parameters[0]), 1)));
}

FamilyMember four_cases(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& which = word(parameters[0], {"i", "ii", "iii", "iv"});
  const Rational apart = positive(parameters[1]);
  SeededStream stream("scene/four-cases", seed, case_id);
  const Placement placement(stream);
  const bool on_top = which == "i" || which == "ii";
  const Rational surface = which == "i" || which == "iii" ? 1 + apart : 1 - apart;
  const Rational low = on_top ? surface : Rational(2, 5);
  const Rational height = on_top ? Rational(2, 3) : Rational(surface - low);
  FamilyMember member = placed_member(
      placement, fmt::format("difference() {{\n  material(\"A\") cube([2, 2, 1]);\n"
                             "  material(\"B\") translate([1/3, 1/2, {}]) cube([4/3, 1, {}]);\n}}",
                             number::to_text(low), number::to_text(height)));
  const Point corner = placement.apply({1.0 / 3, 0.5, 1});
  member.patches.push_back({corner, placement.apply({5.0 / 3, 0.5, 1}) - corner,
                            placement.apply({1.0 / 3, 1.5, 1}) - corner});
  return member;
}

FamilyMember far_origin(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& how = word(parameters[0], {"translated", "scaled"});
  constexpr std::int64_t kMost = 30;
  const std::int64_t power = whole(parameters[1], -kMost, kMost);
  const double value = std::pow(10.0, static_cast<double>(power));
  const bool scaled = how == "scaled";
  const FamilyMember near = coincident_faces(seed, case_id);
  FamilyMember member;
  member.text = fmt::format(
      fmt::runtime(scaled ? "scale(1e{0}) {1}" : "translate([1e{0}, 1e{0}, 1e{0}]) {1}"), power,
      near.text);
  member.place = [scaled, value, place = near.place](const Point& p) {
    return scaled ? value * place(p) : place(p) + Point{value, value, value};
  };
  for (const FamilyMember::Patch& patch : near.patches) {
    member.patches.push_back(
        scaled ? FamilyMember::Patch{value * patch.corner, value * patch.side1, value * patch.side2}
               : FamilyMember::Patch{patch.corner + Point{value, value, value}, patch.side1,
                                     patch.side2});
  }
  return member;
}

FamilyMember unclosed(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& solid = word(parameters[0], {"cylinder", "cone", "slab"});
  SeededStream stream("scene/unclosed", seed, case_id);
  const std::string text =
      solid == "cylinder" ? "cylinder(h=2, r=1, center=true);"
      : solid == "cone"   ? "cylinder(h=2, r1=2, r2=0, center=true);"
                          : "intersection() { halfspace([0, 0, 1], 1); halfspace([0, 0, -1], 1); }";
  return placed_member(Placement::aligned(stream), text);
}

FamilyMember round_solid(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& solid = word(parameters[0], {"ball", "ring", "cut-ring"});
  SeededStream stream("scene/round", seed, case_id);
  const std::string ring = "torus(1, 1/4);";
  return placed_member(Placement(stream),
                       solid == "ball"   ? "sphere(1);"
                       : solid == "ring" ? ring
                                         : "add() {\n  material(\"steel\") difference() { " + ring +
                                               " halfspace([1, 2, 3], 1/7); }\n"
                                               "  material(\"glass\") difference() { sphere(1); " +
                                               ring + " }\n}");
}

}  // namespace lamina::scene
