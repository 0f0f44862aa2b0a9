// Vectors and rays over any number type.
#pragma once

#include <array>
#include <cmath>

#include "number/rational.hpp"

namespace lamina::geometry {

/// Three coordinates. Operations round in a fixed order, left to right.
template <typename Number>
struct Vector3 {
  Number x{};
  Number y{};
  Number z{};

  friend bool operator==(const Vector3&, const Vector3&) = default;
};

template <typename Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Number>
Vector3<Number> operator+(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <typename Number>
Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename Number>
Vector3<Number> operator*(const Number& s, const Vector3<Number>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <typename Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// origin + t * direction for t over the whole line; the direction is not zero and need
/// not have length one: t has no unit.
template <typename Number>
struct Ray {
  Vector3<Number> origin;
  Vector3<Number> direction;
};

using ExactPoint = Vector3<number::Rational>;
using ExactRay = Ray<number::Rational>;

/// Each coordinate rounded to the nearest double.
inline Vector3<double> nearest_double(const ExactPoint& p) {
  return {number::nearest_double(p.x), number::nearest_double(p.y), number::nearest_double(p.z)};
}

/// The vector of length one in the same direction; not finite for zero.
inline Vector3<double> normalised(const Vector3<double>& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

}  // namespace lamina::geometry
