// Carriers: the exact surfaces of a scene in world coordinates, in canonical form.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/affine.hpp"
#include "number/algebraic.hpp"
#include "number/interval.hpp"
#include "surface/half_space.hpp"

namespace lamina::surface {

using CarrierIndex = std::uint32_t;

/// A sweep and its place: points p of the world are at to_local(p).
struct PlacedSweep {
  AnySweep surface;
  geometry::AffineMap to_local;
};

/// The polynomial f of a surface in world coordinates, as a form of its degree (1, 2 or 4)
/// in (x, y, z, w) with w = 1: coprime integer coefficients in a fixed order of the
/// monomials, the first non-zero one positive. Two half-spaces have equal carriers if and
/// only if their boundaries have the same equation up to a factor: exactly coincident
/// surfaces share one carrier, and so share its roots along every ray.
///
/// A sweep, whose pieces have no f in common, is its own carrier, f < 0 inside: two share one if
/// they are the same sweep of the same contour at the same place. Where sweeps coincide that are
/// written otherwise, or a sweep and a plane or quadric, their roots are equal all the same.
struct Carrier {
  int degree = 1;                               ///< 0 of a sweep
  std::vector<number::Integer> coefficients{};  ///< none of a sweep
  std::shared_ptr<const PlacedSweep> sweep{};   ///< null of all others

  friend bool operator==(const Carrier& a, const Carrier& b) { return (a <=> b) == 0; }
  friend std::strong_ordering operator<=>(const Carrier& a, const Carrier& b);
};

/// A carrier and the side of it that is inside: f <= 0 for side 1, -f <= 0 for side -1.
struct OrientedCarrier {
  Carrier carrier;
  int side = 1;
};

/// Returns the carrier of a local surface whose points p are at map^-1: `to_local` takes
/// world to local coordinates. Throws base::InputError if f is constant, which no surface
/// of the scene language is.
OrientedCarrier carrier_of(const LocalSurface& surface, const geometry::AffineMap& to_local);

/// The monomials of degrees 1, 2 and 4 along one line, whose coordinates (x, y, z, w) are
/// polynomials of degree 1 over a ring: computed once for a line, used for all carriers.
template <typename Ring>
class LineMonomials {
 public:
  using Polynomial = std::vector<Ring>;

  explicit LineMonomials(std::array<Polynomial, 4> coordinates)
      : coordinates_(std::move(coordinates)) {}

  /// f along the line: as many coefficients, ascending, as its degree asks for.
  [[nodiscard]] Polynomial restrict(const Carrier& carrier);

 private:
  const std::vector<Polynomial>& monomials(int degree);

  std::array<Polynomial, 4> coordinates_;
  std::array<std::vector<Polynomial>, 5> monomials_;
};

/// Carriers along an exact ray, over the integers.
class RayMonomials {
 public:
  explicit RayMonomials(const geometry::ExactRay& ray);

  /// f(origin + t direction) as a polynomial in t, times a positive constant. Contract: the
  /// carrier is no sweep, here and where else a polynomial is asked for.
  [[nodiscard]] number::IntegerPolynomial restrict(const Carrier& carrier);

 private:
  LineMonomials<number::Integer> line_;
};

/// Carriers along a ray whose origin is enclosed and whose direction is exact.
class EnclosedRayMonomials {
 public:
  EnclosedRayMonomials(const geometry::Vector3<number::Interval>& origin,
                       const geometry::ExactPoint& direction);

  /// f(origin + s direction): the coefficients, ascending, enclosed. The last one is that of the
  /// carrier's degree unless that is exactly zero, as it depends on the direction alone.
  [[nodiscard]] std::vector<number::Interval> restrict(const Carrier& carrier);

 private:
  LineMonomials<number::Interval> line_;
  RayMonomials direction_;
};

/// What an exact ray meets of one carrier.
class CarrierOnRay {
 public:
  /// `monomials` are those of the ray.
  CarrierOnRay(const Carrier& carrier, const geometry::ExactRay& ray, RayMonomials& monomials);

  /// Is f zero all along the ray? (Of a sweep: along a part of it.)
  [[nodiscard]] bool contains_ray() const;
  /// Of f for t towards -infinity; 0 if the carrier contains the ray.
  [[nodiscard]] int sign_at_minus_infinity() const;
  /// Where f changes its sign, ascending. Contract: the carrier does not contain the ray.
  [[nodiscard]] std::vector<number::Root> crossings() const;
  /// Where f is zero and does not change its sign, likewise; none of a sweep, which does not look
  /// for them.
  [[nodiscard]] std::vector<number::Root> touches() const;
  /// The sign of f at a t of the ray; of a sweep that of its surroundings where the ray touches it.
  [[nodiscard]] int sign_at(const number::Root& t) const;

 private:
  struct OnSweep {
    bool starts_inside = false;
    bool in_boundary = false;
    std::vector<number::Root> crossings;
  };
  static OnSweep on_sweep(const PlacedSweep& sweep, const geometry::ExactRay& ray);

  number::IntegerPolynomial polynomial_;  // of all but a sweep
  std::optional<OnSweep> swept_;
};

/// Exact sign of the carrier's f at a point: -1, 0 or 1.
int sign_at(const Carrier& carrier, const geometry::ExactPoint& point);

/// The gradient of f at a point times a positive constant: its direction, exact. Of a sweep: as its
/// normal_near has it.
geometry::ExactPoint gradient_at(const Carrier& carrier, const geometry::ExactPoint& point);

/// The sweep's facets in world coordinates.
std::optional<SweptSurface::Facets> facets_at(const PlacedSweep& sweep,
                                              const geometry::ExactPoint& point);

}  // namespace lamina::surface
