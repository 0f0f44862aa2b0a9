#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scene/placement.hpp"

namespace lamina::scene {
namespace {

using base::SeededStream;

enum Shape { kBox, kCylinder, kCone, kSphere, kTorus, kShapeCount };

// A solid of the family: standing on z = 0 of its own coordinates, with a flat top.
struct Solid {
  Shape shape = kBox;
  Length width;
  Length height;

  // Has it the faces z = 0 and z = height?
  [[nodiscard]] bool flat() const { return shape != kSphere && shape != kTorus; }

  [[nodiscard]] double half_width() const {
    return shape == kBox     ? width.value() / 2
           : shape == kTorus ? width.value() * 4 / 3
                             : width.value();
  }

  // Times `factor`.
  [[nodiscard]] std::string text(std::int64_t factor = 1) const {
    const Length w = width * factor;
    const Length h = height * factor;
    switch (shape) {
      case kBox:
        return fmt::format("translate([{0}, {0}, 0]) cube([{1}, {1}, {2}]);", (-w / 2).text(),
                           w.text(), h.text());
      case kCylinder:
        return fmt::format("cylinder(h={}, r={});", h.text(), w.text());
      case kCone:
        return fmt::format("cylinder(h={}, r1={}, r2={});", h.text(), w.text(), (w / 2).text());
      case kSphere:
        return fmt::format("sphere({});", w.text());
      case kTorus:
      default:
        return fmt::format("torus({}, {});", w.text(), (w / 3).text());
    }
  }
};

Solid make_solid(Shape shape, SeededStream& stream) {
  const Length width = random_length(stream, 1, 4);
  return {shape, width, random_length(stream, 1, 4)};
}

std::string placed(const Length& x, const Length& z, const std::string& solid) {
  return fmt::format("translate([{}, 0, {}]) {}", x.text(), z.text(), solid);
}

// Wraps the operands in two random operators, nested to the left or to the right.
std::string combine(const std::vector<std::string>& solids, SeededStream& stream) {
  constexpr std::array<const char*, 3> kOperators{"add", "difference", "intersection"};
  const auto op = [&] { return kOperators[stream.below(kOperators.size())]; };
  std::string text = fmt::format("{}() {{\n  {}\n  {}\n}}", op(), solids[0], solids[1]);
  if (solids.size() == 3) {
    text = stream.chance(0.5) ? fmt::format("{}() {{\n{}\n  {}\n}}", op(), text, solids[2])
                              : fmt::format("{}() {{\n  {}\n{}\n}}", op(), solids[2], text);
  }
  return text;
}

}  // namespace

FamilyMember coincident_faces(std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/coincident_faces", seed, case_id);
  const Rotation rotation(stream);
  FamilyMember member;
  member.place = [rotation](const geometry::Vector3<double>& p) { return rotation.apply(p); };
  const std::size_t count = 2 + stream.below(2);
  std::vector<std::string> solids;
  const auto material = [&](const std::string& solid) {
    // Mostly different materials; sometimes the same.
    const std::size_t index = stream.chance(0.8) ? solids.size() : 0;
    solids.push_back(
        fmt::format("material(\"{}\") {}", std::string(1, static_cast<char>('a' + index)), solid));
  };

  const Solid first = make_solid(static_cast<Shape>(stream.below(kShapeCount)), stream);
  const Length base = random_length(stream, -2, 2);
  material(placed({0, 1}, base, first.text()));
  for (std::size_t i = 1; i < count; ++i) {
    const double z = base.value();
    if (!first.flat() || stream.chance(0.2)) {
      // Exactly the same surface again, from other numbers.
      material(placed({0, 1}, base, "scale(1/3) " + first.text(3)));
      const double w = first.half_width();
      member.patches.push_back(
          rotation.patch({-w, -w, z + (first.flat() ? first.height.value() / 2 : 0)}, {2 * w, 0, 0},
                         {0, 2 * w, 0}));
      continue;
    }
    // A solid with flat faces, one of them in the plane of the first's top or bottom, on either
    // side of it, shifted sideways so that the faces overlap in part.
    const Solid other = make_solid(static_cast<Shape>(stream.below(kSphere)), stream);
    const Length plane = stream.chance(0.5) ? base + first.height : base;
    const bool above = stream.chance(0.5);
    const Length z0 = above ? plane : plane + -other.height;
    const Length shift = random_length(stream, -1, 1);
    material(placed(shift, z0, other.text()));
    const double low = std::max(-first.half_width(), shift.value() - other.half_width());
    const double high = std::min(first.half_width(), shift.value() + other.half_width());
    const double w = std::min(first.half_width(), other.half_width());
    member.patches.push_back(
        rotation.patch({low, -w, plane.value()}, {high - low, 0, 0}, {0, 2 * w, 0}));
  }
  member.text = fmt::format("{}{}\n", rotation.text(), combine(solids, stream));
  return member;
}

FamilyMember ghost_cylinders(std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/ghost_cylinders", seed, case_id);
  const Rotation rotation(stream);
  const Length top = random_length(stream, 1, 3);
  const auto cylinder = [&](const char* name, const Length& radius, const Length& x) {
    return fmt::format(
        "  material(\"{}\") translate([{}, 0, 0]) difference() {{\n    infinite_cylinder({});\n"
        "    halfspace([0, 0, 1], 0);\n    halfspace([0, 0, -1], -{});\n  }}\n",
        name, x.text(), radius.text(), top.text());
  };
  const Length radius_a = random_length(stream, 1, 2);
  const Length radius_b = random_length(stream, 1, 2);
  const Length gap{stream.integer(1, 5), 7};
  const Length x_b = radius_a + radius_b + gap;
  const std::string a = cylinder("a", radius_a, {0, 1});
  const std::string b = cylinder("b", radius_b, x_b);
  const bool a_first = stream.chance(0.5);
  FamilyMember member;
  member.place = [rotation](const geometry::Vector3<double>& p) { return rotation.apply(p); };
  member.text =
      fmt::format("{}add() {{\n{}{}}}\n", rotation.text(), a_first ? a : b, a_first ? b : a);
  for (const auto& [x, radius] :
       {std::pair{0.0, radius_a.value()}, std::pair{x_b.value(), radius_b.value()}}) {
    const double half = radius / std::sqrt(2.0);
    member.patches.push_back(
        rotation.patch({x - half, -half, top.value()}, {2 * half, 0, 0}, {0, 2 * half, 0}));
  }
  return member;
}

}  // namespace lamina::scene
