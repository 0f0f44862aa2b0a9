// Half-spaces bounded by a swept contour, in a rounded number type, by van Wijk's equations.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vector.hpp"
#include "poly/solver.hpp"
#include "surface/box_tree.hpp"
#include "surface/contour_search.hpp"
#include "surface/ray_image.hpp"
#include "surface/swept_surface.hpp"

namespace lamina::surface {

/// What is done as van Wijk 1984 has it in print, to be measured.
struct AsPrinted {
  /// n_z = -+(u^2 + v^2)^1/2 for a normal of length one in (u, v), section 4: right only where that
  /// is radial.
  bool conic_normal = false;
  /// The rectangle of each piece is tested in its turn, without a tree over them.
  bool each_piece = false;
  /// Taken for d_x = d_y = 0, but in conic sweeps of both kinds, and for d_z = 0 in rotational ones
  /// and at cap planes: his "very small absolute value" (section 3), for which he names no number.
  /// Without, these rays have equations of their own.
  std::optional<double> small_value{};
};

/// A sweep in local coordinates, its contour's pieces rounded once.
template <number::RoundedNumber Number>
class RoundedSweep {
 public:
  explicit RoundedSweep(const SweptSurface& exact, const AsPrinted& printed = {});

  struct Crossing {
    Number t;
    Number s;  ///< the contour's parameter on the piece, 0 <= s < 1, or 1 at the axis
    std::uint32_t piece = 0;
  };

  /// Returns in `crossings`, ascending in t, where a ray in local coordinates crosses the surface:
  /// the s of each piece that its rectangle does not rule out, by equations 2, 6 and 9 of van Wijk
  /// 1984 and the search that `solvers` names, then t by one of its equations for it, that with the
  /// largest divisor. Rays along the contour's plane or its axis have equations of their own in
  /// place of his very small numbers, unless one is given: at one z in a rotational sweep v(s) =
  /// o_z, and two t on the circle; parallel to the axis u(s) is the distance from it. The pieces
  /// are reached by a tree of their rectangles, which leaves out none that its own does not rule
  /// out. Roots that the solver knows to be of even multiplicity are touches, and left out. Returns
  /// false, and no crossings, for a ray for which the equation of a piece holds all along.
  ///
  /// By his rule a joint belongs to the piece with s = 0: a ray that touches a corner there crosses
  /// it once, as far as a solver can tell; the other searches decide it by the signs of the image
  /// on both sides. Where the contour meets the axis and ends, or goes on along it, u^2 has a
  /// double root, which is a crossing.
  ///
  /// A generalised conic sweep has such equations for level rays only. For others s is eliminated,
  /// and roots in t of degree 15 at most, by the solver of sextics, divide the ray: a crossing is
  /// where side() changes from one part's middle to the next one's. There t and s are polished
  /// together, so that they are as good as the two equations for them.
  ///
  /// Error:  that of the solver's or the search's s times the slope of t over s. The image's
  ///         coefficients are the more off the farther away the ray starts, and with them s; and as
  ///         a ray gets nearly level, t is off by some u (|d| / d_z)^2: for |d_z| below some
  ///         sqrt(u) |d| its two crossings of a steep piece are lost.
  ///         Where a ray passes close by a place at which the scaling of a generalised conic sweep
  ///         is zero, its roots there, of all pieces, are next to each other: t may be off by the
  ///         distance from that place.
  bool find_crossings(const geometry::Ray<Number>& local, const poly::Solvers& solvers,
                      std::vector<Crossing>& crossings) const;

  /// In the contour's parameter s, ascending.
  struct Polynomial {
    std::array<Number, 7> c;
    int degree = 0;  ///< of the piece, or twice that, whatever c[degree] is
  };
  /// Its roots in 0 .. 1 are where a piece meets the ray's image: equations 2, 6 and 9 of van Wijk
  /// 1984.
  [[nodiscard]] Polynomial polynomial(const geometry::Ray<Number>& local,
                                      std::uint32_t piece) const {
    return polynomial(pieces_[piece], image(local));
  }

  /// Are all of the piece's points off the ray, for certain if nothing underflows? Van Wijk's
  /// rectangle tests of sections 3 to 5, as bounds of the equation over the rectangle, each less a
  /// bound on its rounding. (The twelve cases of section 5 decide the same for the hyperbola.)
  [[nodiscard]] bool rules_out(const geometry::Ray<Number>& local, std::uint32_t piece) const;

  /// The outward normal at a crossing's point, not of length one: van Wijk's, but the right n_z of
  /// a conic sweep, -(n_x u + n_y v). Contract: not at the apex of a conic sweep, or where the
  /// scaling of a generalised one is zero.
  [[nodiscard]] geometry::Vector3<Number> normal(const geometry::Vector3<Number>& local,
                                                 const Crossing& crossing) const;

  /// Of a point: -1 inside, 0 on the surface, 1 outside. By the parity of the crossings of a
  /// half-line in the contour's plane that runs along no straight piece; `scratch` is overwritten.
  [[nodiscard]] int side(const geometry::Vector3<Number>& local, const poly::Solvers& solvers,
                         std::vector<Crossing>& scratch) const;
  /// The same of a ray's points for t towards -infinity, given its crossings: outside but for one
  /// in a prism along its axis, or in a cone. `scratch` is overwritten.
  [[nodiscard]] int side_at_minus_infinity(const geometry::Ray<Number>& local,
                                           const std::vector<Crossing>& crossings,
                                           const poly::Solvers& solvers,
                                           std::vector<Crossing>& scratch) const;

  /// A function that is zero on the surface's tangent plane at a crossing, and has normal() for its
  /// gradient: how far a point is from there, to first order.
  [[nodiscard]] Number value(const geometry::Vector3<Number>& local,
                             const Crossing& crossing) const;
  /// A bound on the error of value() at a point of the world, from the scene's numbers on.
  ///
  /// Arguments: magnitude  RoundedMap::magnitude of the point.
  [[nodiscard]] Number rounding_error(const geometry::Vector3<Number>& magnitude,
                                      const Crossing& crossing) const;

  [[nodiscard]] Sweep sweep() const { return sweep_; }
  [[nodiscard]] const AsPrinted& printed() const { return printed_; }

 private:
  using Piece = RoundedPiece<Number>;
  using Image = RayImage<Number>;

  // What x and y are divided by at this height, to get u and v.
  struct Scales {
    Number x, y;
  };
  [[nodiscard]] Scales scales_at(const Number& z) const;
  void find_by_sides(const geometry::Ray<Number>& local, const poly::Solvers& solvers,
                     std::vector<Crossing>& crossings) const;
  // Where a piece is nearest to a place in its plane, by u or v alone, and how far that is,
  // squared.
  struct Foot {
    Number s, distance;
  };
  [[nodiscard]] Foot foot_of(const Piece& piece, const std::array<Number, 2>& place,
                             const poly::Solvers& solvers) const;
  // By Newton's method for x = u(s) p(z) and y = v(s) q(z), as long as it helps.
  [[nodiscard]] Crossing polished(const geometry::Ray<Number>& local, Crossing crossing) const;
  [[nodiscard]] Image image(const geometry::Ray<Number>& local) const;
  [[nodiscard]] bool is_level(const geometry::Ray<Number>& local) const {
    return sweep_ == Sweep::Rotational && local.direction.z == 0;
  }
  [[nodiscard]] bool is_upright(const geometry::Ray<Number>& local) const {
    return sweep_ == Sweep::Rotational && local.direction.x == 0 && local.direction.y == 0;
  }
  [[nodiscard]] geometry::Ray<Number> with_small_values(geometry::Ray<Number> local) const;
  [[nodiscard]] Polynomial polynomial(const Piece& piece, const Image& image) const;
  // The roots of that in 0 .. 1.
  [[nodiscard]] poly::RealRoots<Number> roots_of(const Piece& piece, const Image& image,
                                                 const poly::Solvers& solvers) const;
  // Calls cross(s) where the piece crosses the ray's image; false if it is part of that.
  template <typename Cross>
  bool search(const Piece& piece, const Image& image, const poly::Solvers& solvers,
              const Cross& cross) const;
  void add_crossings(const geometry::Ray<Number>& local, std::uint32_t piece, const Number& s,
                     std::vector<Crossing>& crossings) const;

  Sweep sweep_;
  int orientation_;
  AsPrinted printed_;
  std::vector<Number> scale_x_;  // polynomials in z; empty but of a generalised conic sweep
  std::vector<Number> scale_y_;
  std::vector<Piece> pieces_;
  BoxTree<Number> tree_;
};

}  // namespace lamina::surface
