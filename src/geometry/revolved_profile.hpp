// Profiles of solids of revolution whose pieces turn into quadrics and toruses; exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "geometry/contour.hpp"
#include "number/rational.hpp"

namespace lamina::geometry {

/// x^2 = alpha y^2 + beta y + gamma with x >= 0 at the heights y_low <= y <= y_high: a conic of
/// Hashimoto and Suenaga, equation 1, divided by -a11. About the axis x = 0 it turns into a
/// quadric.
struct Conic {
  number::Rational alpha;
  number::Rational beta;
  number::Rational gamma;
  number::Rational y_low;
  number::Rational y_high;
  int side = 1;  ///< 1: the profile goes up here, and the solid is on the axis' side; -1: down
  std::size_t interval = 0;  ///< of the profile, from 1: from the point of that number to the next

  [[nodiscard]] number::Rational square_at(const number::Rational& y) const;  ///< x^2
  [[nodiscard]] number::Rational slope_at(const number::Rational& y) const;   ///< d(x^2)/dy

  friend bool operator==(const Conic&, const Conic&) = default;
};

/// What an arc is of its circle.
enum class ArcPart : std::uint8_t {
  Above,  ///< y >= y_low, both sides of the centre: the profile comes up and goes down again
  Below,  ///< y <= y_high, likewise
  Inner,  ///< from the axis, which it touches, to the other one of y_low and y_high
};

/// Of the circle of radius `minor` about (major, height). It turns into a torus.
struct Arc {
  number::Rational major;
  number::Rational minor;
  number::Rational height;
  number::Rational y_low;
  number::Rational y_high;
  ArcPart part = ArcPart::Above;
  int side = 1;  ///< Inner: as in a conic; else 1 if the solid is inside the circle, -1 if outside
  std::size_t interval = 0;  ///< in which it begins

  friend bool operator==(const Arc&, const Arc&) = default;
};

using ProfilePiece = std::variant<Conic, Arc>;

/// A profile that goes round its solid with the solid on its left: up outside, down inside. Where
/// it does not begin or end on the axis, a horizontal line closes it to the axis, and where the
/// radius jumps at a height, to the next piece. Immutable.
class RevolvedProfile {
 public:
  /// Pieces whose regions all are added (side 1) or all taken away (side -1). The region of a conic
  /// or an inner arc lies between it and the axis, that of another arc inside the circle.
  struct Layer {
    int side = 1;
    std::vector<ProfilePiece> pieces;
  };

  /// Each piece begins at the height where the one before it ends.
  /// Throws base::InputError, which names intervals by the numbers of their points from 1, unless
  /// the pieces go round a solid as they should: wherever some overlap in height, they must not
  /// cross or touch, and from outside in, the profile must go up, down, up and so on. Exact for
  /// conics; an arc stands for the ring of radii that holds all of it.
  explicit RevolvedProfile(std::vector<ProfilePiece> pieces);

  /// In the order of the profile.
  [[nodiscard]] std::span<const ProfilePiece> pieces() const { return pieces_; }
  /// From outside in: adding and taking away one after the other gives the solid, since at each
  /// height the layers there come in descending order of their radii.
  [[nodiscard]] std::span<const Layer> layers() const { return layers_; }

 private:
  std::vector<ProfilePiece> pieces_;
  std::vector<Layer> layers_;
};

/// Returns the profile of straight lines through the points of the contour at `count` equal steps
/// of its parameter, which runs over an equal range on each of the contour's pieces; exact. The
/// lines turn into cones, cylinders and planes (Horiuchi et al. 1985, as Hashimoto and Suenaga
/// describe it); level lines and those on the axis have no piece: what is next to them ends there.
/// Throws base::InputError if count is 0, if the contour gets to negative u, or if the lines do not
/// go round a solid.
RevolvedProfile inscribed_cones(const Contour& contour, std::size_t count);

}  // namespace lamina::geometry
