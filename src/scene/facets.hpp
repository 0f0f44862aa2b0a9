// Spheres, cylinders and cones as OpenSCAD 2021.01 facets them.
#pragma once

#include "number/rational.hpp"
#include "scene/solid.hpp"

namespace lamina::scene {

/// $fn, $fa and $fs, with OpenSCAD's defaults.
struct FacetSettings {
  number::Rational fn = 0;
  number::Rational fa = 12;
  number::Rational fs = 2;
};

/// No solid may have more facets than this.
inline constexpr int kMaxFacets = 100'000;

/// Returns the number of vertices of a circle: int($fn) if $fn > 0, else
/// ceil(min(360 / $fa, 2 pi r / $fs)) but at least 5; never below 3. Computed in double, as
/// OpenSCAD does; no more than kMaxFacets.
int vertices_of_circle(const number::Rational& radius, const FacetSettings& settings);

/// The sphere's rings of vertices for so many in each: ring i, from the top, is at the polar
/// angle 180 (i + 1/2) / rings.
int rings_of_sphere(int vertices);

/// Vertex k of a ring is at 360 k / vertices degrees. Cosines and sines are the nearest
/// doubles and exact from there on, the same for all rings, so that every facet is planar.
/// Contract: vertices >= 3, radius > 0.
Solid faceted_sphere(const number::Rational& radius, int vertices);

/// A circle of radius and height above the xy plane.
struct Rim {
  number::Rational radius;
  number::Rational z;
};

/// A cylinder, cone or truncated cone. Contract: vertices >= 3, bottom.z < top.z, and at
/// most one radius is zero, none negative.
Solid faceted_cylinder(const Rim& bottom, const Rim& top, int vertices);

}  // namespace lamina::scene
