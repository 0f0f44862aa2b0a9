// Where points lie with respect to a profile, by counting its pieces: no layers, no planes.
#pragma once

#include <variant>

#include "geometry/revolved_profile.hpp"

namespace lamina::geometry {

/// Whether a level line from (x, y), x >= 0, outwards crosses the piece an odd number of times.
/// Heights at which pieces end belong to the piece above.
inline bool crosses_oddly(const ProfilePiece& piece, const number::Rational& x,
                          const number::Rational& y) {
  if (const Conic* c = std::get_if<Conic>(&piece)) {
    return y >= c->y_low && y < c->y_high && x * x <= c->alpha * y * y + c->beta * y + c->gamma;
  }
  const Arc& arc = std::get<Arc>(piece);
  const number::Rational dx = x - arc.major;
  const number::Rational dy = y - arc.height;
  const bool in_circle = dx * dx + dy * dy <= arc.minor * arc.minor;
  if (y < arc.y_low || y >= arc.y_high) {
    return false;
  }
  return arc.part == ArcPart::Inner ? x <= arc.major && !in_circle : in_circle;
}

/// Whether (x, y) is in the region between the profile and the axis.
inline bool inside(const RevolvedProfile& profile, const number::Rational& x,
                   const number::Rational& y) {
  bool odd = false;
  for (const ProfilePiece& piece : profile.pieces()) {
    odd = odd != crosses_oddly(piece, x, y);
  }
  return odd;
}

}  // namespace lamina::geometry
