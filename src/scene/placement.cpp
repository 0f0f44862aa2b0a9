#include "scene/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/contract.hpp"

namespace lamina::scene {

using base::SeededStream;
using number::Rational;
using Point = geometry::Vector3<double>;

const std::string& word(const std::string& given, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), given) == words.end()) {
    throw base::InputError(fmt::format("'{}': one of {}", given, fmt::join(words, ", ")));
  }
  return given;
}

Rational positive(const std::string& text) {
  const Rational value = number::parse_rational(text);
  if (value.sign() <= 0) {
    throw base::InputError(fmt::format("'{}': a number above 0", text));
  }
  return value;
}

std::int64_t whole(const std::string& text, std::int64_t low, std::int64_t high) {
  const Rational value = number::parse_rational(text);
  if (denominator(value) != 1 || value < low || value > high) {
    throw base::InputError(fmt::format("'{}': a whole number from {} to {}", text, low, high));
  }
  return static_cast<std::int64_t>(number::nearest_double(value));
}

double Length::value() const {
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

std::string Length::text() const {
  return denominator == 1 ? fmt::format("{}", numerator)
                          : fmt::format("{}/{}", numerator, denominator);
}

Length operator+(const Length& a, const Length& b) {
  return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
}

Length operator-(const Length& a) { return {-a.numerator, a.denominator}; }

Length operator*(const Length& a, std::int64_t b) { return {a.numerator * b, a.denominator}; }

Length operator/(const Length& a, std::int64_t b) { return {a.numerator, a.denominator * b}; }

Length random_length(SeededStream& stream, int low, int high) {
  constexpr std::array<std::int64_t, 6> kDenominators{1, 2, 3, 5, 7, 10};
  const std::int64_t d = kDenominators[stream.below(kDenominators.size())];
  return {stream.integer(low * d, high * d), d};
}

Rotation::Rotation(SeededStream& stream) : aligned_(stream.chance(0.125)) {
  for (std::int64_t& angle : degrees_) {
    angle = aligned_ ? 0 : stream.integer(-179, 179);
  }
}

std::string Rotation::text() const {
  return aligned_ ? ""
                  : fmt::format("rotate([{}, {}, {}]) ", degrees_[0], degrees_[1], degrees_[2]);
}

Point Rotation::apply(Point p) const {
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

FamilyMember::Patch Rotation::patch(const Point& corner, const Point& side1,
                                    const Point& side2) const {
  return {apply(corner), apply(side1), apply(side2)};
}

Placement::Placement(SeededStream& stream) : Placement(Rotation(stream), stream) {}

Placement::Placement(std::optional<Rotation> rotation, SeededStream& stream) : rotation_(rotation) {
  for (Length& length : translation_) {
    length = random_length(stream, -1, 1);
  }
}

Placement Placement::aligned(SeededStream& stream) { return {std::nullopt, stream}; }

std::string Placement::text() const {
  return fmt::format("translate([{}, {}, {}]) {}", translation_[0].text(), translation_[1].text(),
                     translation_[2].text(), rotation_ ? rotation_->text() : "");
}

Point Placement::apply(const Point& p) const {
  const Point turned = rotation_ ? rotation_->apply(p) : p;
  return turned + Point{translation_[0].value(), translation_[1].value(), translation_[2].value()};
}

FamilyMember placed_member(const Placement& placement, const std::string& solid) {
  return {placement.text() + solid + "\n", {}, [placement](const Point& p) {
            return placement.apply(p);
          }};
}

}  // namespace lamina::scene
