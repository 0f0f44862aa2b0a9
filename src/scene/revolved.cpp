#include "scene/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace lamina::scene {
namespace {

using csg::Operator;
using geometry::Arc;
using geometry::ArcPart;
using geometry::Conic;
using geometry::ProfilePiece;
using geometry::RevolvedProfile;
using number::Rational;

Solid::Part not_below(const Rational& z) { return {"bottom", surface::plane({0, 0, -1}, -z)}; }
Solid::Part not_above(const Rational& z) { return {"top", surface::plane({0, 0, 1}, z)}; }

Solid solid_of(const Conic& conic) {
  const surface::LocalSurface side = surface::quadric(
      {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -conic.alpha, -conic.beta}, {0, 0, 0, -conic.gamma}}});
  return {.parts = {{"side", side}, not_below(conic.y_low), not_above(conic.y_high)}};
}

Solid torus_of(const Arc& arc) {
  return {.parts = {{"torus", surface::torus(arc.major, arc.minor)}},
          .placement = geometry::translation({0, 0, arc.height})};
}

Solid solid_of(const Arc& arc) {
  if (arc.part == ArcPart::Above) {
    return {.parts = {not_below(arc.y_low)}, .solids = {torus_of(arc)}};
  }
  if (arc.part == ArcPart::Below) {
    return {.parts = {not_above(arc.y_high)}, .solids = {torus_of(arc)}};
  }
  // Within the cylinder through the centres of its circles the torus has its inner side only.
  // Not inside the braces below: g++ 12.2 leaves out its default members there.
  Solid tube{.parts = {{"side", surface::infinite_cylinder(arc.major)},
                       not_below(arc.y_low),
                       not_above(arc.y_high)}};
  return {.op = Operator::Difference, .solids = {std::move(tube), torus_of(arc)}};
}

// A rational that is not below the root: (s + k^2) / 2k for any k > 0, by the two means.
Rational root_from_above(const Rational& square) {
  const double near = std::sqrt(number::nearest_double(square));
  if (near == 0 || !std::isfinite(near)) {  // zero, or beyond the doubles
    return square > 0 && square < 1 ? Rational(1) : square;
  }
  const Rational k = near;
  return (square + k * k) / (2 * k);
}

Rational greatest_radius(const Conic& conic) {
  Rational square = std::max(conic.square_at(conic.y_low), conic.square_at(conic.y_high));
  if (!conic.alpha.is_zero()) {
    const Rational vertex = -conic.beta / (2 * conic.alpha);
    if (vertex > conic.y_low && vertex < conic.y_high) {
      square = std::max(square, conic.square_at(vertex));
    }
  }
  return root_from_above(square);
}

Rational greatest_radius(const Arc& arc) {
  return arc.part == ArcPart::Inner ? arc.major : Rational(arc.major + arc.minor);
}

Bounds box_around(const RevolvedProfile& profile) {
  const auto radius = [](const ProfilePiece& piece) {
    return std::visit([](const auto& p) { return greatest_radius(p); }, piece);
  };
  const auto low = [](const ProfilePiece& piece) {
    return std::visit([](const auto& p) { return p.y_low; }, piece);
  };
  const auto high = [](const ProfilePiece& piece) {
    return std::visit([](const auto& p) { return p.y_high; }, piece);
  };
  Rational r = 0;
  Rational z_low = low(profile.pieces().front());
  Rational z_high = z_low;
  for (const ProfilePiece& piece : profile.pieces()) {
    r = std::max(r, radius(piece));
    z_low = std::min(z_low, low(piece));
    z_high = std::max(z_high, high(piece));
  }
  return {{-r, -r, z_low}, {r, r, z_high}};
}

}  // namespace

Solid revolved_solid(const RevolvedProfile& profile) {
  Solid solid{.op = Operator::Add};
  for (const RevolvedProfile::Layer& layer : profile.layers()) {
    const Operator op = layer.side > 0 ? Operator::Add : Operator::Difference;
    if (op != solid.op) {
      Solid so_far = std::move(solid);
      solid = {.op = op};
      solid.solids.push_back(std::move(so_far));
    }
    for (const ProfilePiece& piece : layer.pieces) {
      solid.solids.push_back(std::visit([](const auto& p) { return solid_of(p); }, piece));
    }
  }
  solid.box = box_around(profile);
  return solid;
}

}  // namespace lamina::scene
