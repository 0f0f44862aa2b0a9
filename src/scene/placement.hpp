// Parts that the families of scenes are put together from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/seeded_stream.hpp"
#include "scene/families.hpp"

namespace lamina::scene {

/// What stands behind a family's name, one word each.
using Parameters = std::vector<std::string>;

/// What is given, if it is one of the words; else throws base::InputError that lists them.
const std::string& word(const std::string& given, const std::vector<std::string>& words);
/// A number above 0, exact; else throws base::InputError.
number::Rational positive(const std::string& text);
/// A whole number from low to high; else throws base::InputError.
std::int64_t whole(const std::string& text, std::int64_t low, std::int64_t high);

/// A rational as text and as a double, for the geometry of rays.
struct Length {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  [[nodiscard]] double value() const;
  [[nodiscard]] std::string text() const;
};

Length operator+(const Length& a, const Length& b);
Length operator-(const Length& a);
Length operator*(const Length& a, std::int64_t b);
Length operator/(const Length& a, std::int64_t b);

/// Between low and high in steps of one over a random denominator: few of them are binary
/// fractions, so that most lengths are rounded by every float.
Length random_length(base::SeededStream& stream, int low, int high);

/// A random rotation of a whole scene by whole degrees, none in one of eight: exactly as the
/// scene reads it back, and in double, which is all that rays need.
class Rotation {
 public:
  explicit Rotation(base::SeededStream& stream);

  /// `rotate([..]) `, or nothing.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] geometry::Vector3<double> apply(geometry::Vector3<double> p) const;
  [[nodiscard]] FamilyMember::Patch patch(const geometry::Vector3<double>& corner,
                                          const geometry::Vector3<double>& side1,
                                          const geometry::Vector3<double>& side2) const;

 private:
  bool aligned_;
  std::array<std::int64_t, 3> degrees_{};
};

/// A random rotation and then a random translation by fractions.
class Placement {
 public:
  explicit Placement(base::SeededStream& stream);
  /// The translation alone.
  static Placement aligned(base::SeededStream& stream);

  /// `translate([..]) rotate([..]) `.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] geometry::Vector3<double> apply(const geometry::Vector3<double>& p) const;

 private:
  Placement(std::optional<Rotation> rotation, base::SeededStream& stream);

  std::optional<Rotation> rotation_;
  std::array<Length, 3> translation_;
};

/// A solid of the scene language, placed.
FamilyMember placed_member(const Placement& placement, const std::string& solid);

}  // namespace lamina::scene
