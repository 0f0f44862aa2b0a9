#include "scene/families.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"

namespace lamina::scene {
namespace {

using base::SeededStream;
using Point = geometry::Vector3<double>;

// A rational as text and as a double, for the geometry of patches.
struct Length {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  [[nodiscard]] double value() const {
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }
  [[nodiscard]] std::string text() const {
    return denominator == 1 ? fmt::format("{}", numerator)
                            : fmt::format("{}/{}", numerator, denominator);
  }
};

Length operator+(const Length& a, const Length& b) {
  return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
}
Length operator-(const Length& a) { return {-a.numerator, a.denominator}; }
Length operator/(const Length& a, std::int64_t b) { return {a.numerator, a.denominator * b}; }

// Between low and high in steps of one over a random denominator: few of them are binary
// fractions, so that most lengths are rounded by every float.
Length random_length(SeededStream& stream, int low, int high) {
  constexpr std::array<std::int64_t, 6> kDenominators{1, 2, 3, 5, 7, 10};
  const std::int64_t d = kDenominators[stream.below(kDenominators.size())];
  return {stream.integer(low * d, high * d), d};
}

// The whole scene's rotation, exactly as the scene reads it back: the patches follow it in
// double, which is all that rays need.
class Rotation {
 public:
  explicit Rotation(SeededStream& stream) : aligned_(stream.chance(0.125)) {
    for (std::int64_t& angle : degrees_) {
      angle = aligned_ ? 0 : stream.integer(-179, 179);
    }
  }

  [[nodiscard]] std::string text() const {
    return aligned_ ? ""
                    : fmt::format("rotate([{}, {}, {}]) ", degrees_[0], degrees_[1], degrees_[2]);
  }

  [[nodiscard]] Point apply(Point p) const {
    const auto turn = [](double& a, double& b, std::int64_t degrees) {
      const double angle = static_cast<double>(degrees) * M_PI / 180;
      const double turned = std::cos(angle) * a - std::sin(angle) * b;
      b = std::sin(angle) * a + std::cos(angle) * b;
      a = turned;
    };
    turn(p.y, p.z, degrees_[0]);
    turn(p.z, p.x, degrees_[1]);
    turn(p.x, p.y, degrees_[2]);
    return p;
  }

  [[nodiscard]] FamilyMember::Patch patch(const Point& corner, const Point& side1,
                                          const Point& side2) const {
    return {apply(corner), apply(side1), apply(side2)};
  }

 private:
  bool aligned_;
  std::array<std::int64_t, 3> degrees_{};
};

// A solid of the family: standing on z = 0 of its own coordinates, with a flat top.
struct Solid {
  std::string text;
  double half_width = 0;
  Length height;
  bool flat = true;  // has the faces z = 0 and z = height
};

enum Shape { kBox, kCylinder, kCone, kSphere, kTorus, kShapeCount };

Solid make_solid(Shape shape, SeededStream& stream) {
  const Length width = random_length(stream, 1, 4);
  const Length height = random_length(stream, 1, 4);
  switch (shape) {
    case kBox:
      return {fmt::format("translate([{0}, {0}, 0]) cube([{1}, {1}, {2}]);", (-width / 2).text(),
                          width.text(), height.text()),
              width.value() / 2, height};
    case kCylinder:
      return {fmt::format("cylinder(h={}, r={});", height.text(), width.text()), width.value(),
              height};
    case kCone:
      return {fmt::format("cylinder(h={}, r1={}, r2={});", height.text(), width.text(),
                          (width / 2).text()),
              width.value(), height};
    case kSphere:
      return {fmt::format("sphere({});", width.text()), width.value(), height, false};
    case kTorus:
    default:
      return {fmt::format("torus({}, {});", width.text(), (width / 3).text()),
              width.value() * 4 / 3, height, false};
  }
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
  material(placed({0, 1}, base, first.text));
  for (std::size_t i = 1; i < count; ++i) {
    const double z = base.value();
    if (!first.flat || stream.chance(0.2)) {
      // The same surface again, by another route to the same place.
      const Length part = random_length(stream, -2, 2);
      material(fmt::format("translate([0, 0, {}]) {}", part.text(),
                           placed({0, 1}, base + -part, first.text)));
      const double w = first.half_width;
      member.patches.push_back(rotation.patch(
          {-w, -w, z + (first.flat ? first.height.value() / 2 : 0)}, {2 * w, 0, 0}, {0, 2 * w, 0}));
      continue;
    }
    // A solid with flat faces, one of them in the plane of the first's top or bottom, on either
    // side of it, shifted sideways so that the faces overlap in part.
    const Solid other = make_solid(static_cast<Shape>(stream.below(kSphere)), stream);
    const Length plane = stream.chance(0.5) ? base + first.height : base;
    const bool above = stream.chance(0.5);
    const Length z0 = above ? plane : plane + -other.height;
    const Length shift = random_length(stream, -1, 1);
    material(placed(shift, z0, other.text));
    const double low = std::max(-first.half_width, shift.value() - other.half_width);
    const double high = std::min(first.half_width, shift.value() + other.half_width);
    const double w = std::min(first.half_width, other.half_width);
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

std::string family_spelling(const std::string& name, std::uint64_t seed, std::uint64_t case_id) {
  return fmt::format("family:{}:{}:{}", name, seed, case_id);
}

Scene open_scene(const std::string& spelling, const ReadOptions& options) {
  constexpr std::string_view kPrefix = "family:";
  if (!spelling.starts_with(kPrefix)) {
    return read_scene(spelling, options);
  }
  const auto fail = [&] {
    throw base::InputError(fmt::format(
        "scene '{}': a member of a family is family:NAME:SEED:CASE, with NAME coincident-faces or "
        "ghost-cylinders",
        spelling));
  };
  const std::size_t name_end = std::min(spelling.find(':', kPrefix.size()), spelling.size());
  const std::string name = spelling.substr(kPrefix.size(), name_end - kPrefix.size());
  std::array<std::uint64_t, 2> numbers{};
  const char* at = spelling.data() + name_end;
  const char* const end = spelling.data() + spelling.size();
  for (std::uint64_t& number : numbers) {
    const auto result = at == end ? std::from_chars_result{at, std::errc::invalid_argument}
                                  : std::from_chars(at + 1, end, number);
    if (result.ec != std::errc{}) {
      fail();
    }
    at = result.ptr;
  }
  if (at != end || (name != "coincident-faces" && name != "ghost-cylinders")) {
    fail();
  }
  const FamilyMember member = name == "coincident-faces" ? coincident_faces(numbers[0], numbers[1])
                                                         : ghost_cylinders(numbers[0], numbers[1]);
  return parse_scene(member.text, spelling, options);
}

}  // namespace lamina::scene
