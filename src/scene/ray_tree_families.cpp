#include "scene/ray_tree_families.hpp"

#include <fmt/format.h>

#include <cmath>

namespace lamina::scene {
namespace {

using base::SeededStream;
using Point = geometry::Vector3<double>;

constexpr std::int64_t kMostPower = 30;

// A block less what opens it; doubled, the block added to itself, and less that twice.
std::string opened(const std::string& how, const std::string& block, const std::string& opening) {
  return word(how, {"plain", "doubled"}) == "plain"
             ? fmt::format("difference() {{\n  {}\n  {}\n}}", block, opening)
             : fmt::format("difference() {{\n  add() {{\n    {0}\n    {0}\n  }}\n  {1}\n  {1}\n}}",
                           block, opening);
}

// Glasses of different refractive indices between 1.2 and 2.2.
std::string glass(std::int64_t i, SeededStream& stream) {
  return fmt::format("material(\"glass{}\", color=[0.9, 0.9, 0.9, 1/4], index={}/10)", i + 1,
                     stream.integer(12, 22));
}

}  // namespace

FamilyMember single(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::string& solid = word(parameters[0], {"box", "cylinder", "cone", "ball", "ring"});
  const std::int64_t power = whole(parameters[1], -kMostPower, kMostPower);
  SeededStream stream("scene/single", seed, case_id);
  const Placement placement(stream);
  const std::string text = solid == "box"        ? "cube(2, center=true);"
                           : solid == "cylinder" ? "cylinder(h=2, r=1, center=true);"
                           : solid == "cone"     ? "cylinder(h=2, r1=1, r2=0, center=true);"
                           : solid == "ball"     ? "sphere(1);"
                                                 : "torus(1, 1/4);";
  FamilyMember member = placed_member(placement, text);
  member.text = fmt::format("scale(1e{}) {}", power, member.text);
  member.place = [placement, size = std::pow(10.0, static_cast<double>(power))](const Point& p) {
    return size * placement.apply(p);
  };
  return member;
}

FamilyMember distant_ball(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::int64_t power = whole(parameters[0], 0, kMostPower);
  SeededStream stream("scene/distant-ball", seed, case_id);
  const Placement placement(stream);
  const double far = power == 0 ? 0 : std::pow(10.0, static_cast<double>(power));
  FamilyMember member = placed_member(placement, "sphere(1);");
  if (power > 0) {
    member.text = fmt::format("translate([1e{0}, 1e{0}, 1e{0}]) {1}", power, member.text);
  }
  member.place = [placement, far](const Point& p) {
    return placement.apply(p) + Point{far, far, far};
  };
  return member;
}

FamilyMember bubble(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/bubble", seed, case_id);
  const Placement placement(stream);
  return placed_member(placement, opened(parameters[0], "cube(4, center=true);", "sphere(1);"));
}

FamilyMember well(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/well", seed, case_id);
  const Placement placement(stream);
  return placed_member(placement,
                       opened(parameters[0], "translate([-3/2, -3/2, -1]) cube([3, 3, 41]);",
                              "translate([-1/2, -1/2, 0]) cube([1, 1, 50]);"));
}

FamilyMember cube_corner(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  SeededStream stream("scene/cube-corner", seed, case_id);
  const Placement placement(stream);
  return placed_member(placement,
                       opened(parameters[0], "translate([-1, -1, -1]) cube(6);", "cube(9);"));
}

FamilyMember plates(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::int64_t count = whole(parameters[0], 1, 64);
  SeededStream stream("scene/plates", seed, case_id);
  const Placement placement(stream);
  std::string sum = "add() {\n";
  for (std::int64_t i = 0; i < count; ++i) {
    sum +=
        fmt::format("  {} translate([-50, -50, {}]) cube([100, 100, 1]);\n", glass(i, stream), i);
  }
  FamilyMember member = placed_member(placement, sum + "}");
  const auto top = static_cast<double>(count);
  const Point corner = placement.apply({-1, -1, top});
  member.patches.push_back(
      {corner, placement.apply({1, -1, top}) - corner, placement.apply({-1, 1, top}) - corner});
  return member;
}

FamilyMember onion(const Parameters& parameters, std::uint64_t seed, std::uint64_t case_id) {
  const std::int64_t count = whole(parameters[0], 1, 64);
  SeededStream stream("scene/onion", seed, case_id);
  const Placement placement(stream);
  std::string sum = "add() {\n";
  for (std::int64_t i = 0; i < count; ++i) {
    sum += fmt::format("  {} sphere({});\n", glass(i, stream), count - i);
  }
  return placed_member(placement, sum + "}");
}

}  // namespace lamina::scene
