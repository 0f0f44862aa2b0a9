#include "geometry/affine.hpp"

#include <cmath>

#include "base/contract.hpp"
#include "number/trigonometry.hpp"

namespace lamina::geometry {
namespace {

using number::Rational;

ExactPoint linear_row(const AffineMap::Row& row) { return {row[0], row[1], row[2]}; }

ExactPoint constant_column(const AffineMap& map) {
  return {map.rows[0][3], map.rows[1][3], map.rows[2][3]};
}

bool is_zero(const ExactPoint& vector) { return vector == ExactPoint{}; }

// A coordinate axis is replaced by its unit vector, so that its length is no irrational
// matter and right angles about it come out exactly.
ExactPoint with_unit_length_if_coordinate_axis(const ExactPoint& axis) {
  const int nonzero = (axis.x != 0 ? 1 : 0) + (axis.y != 0 ? 1 : 0) + (axis.z != 0 ? 1 : 0);
  return nonzero == 1 ? ExactPoint{axis.x.sign(), axis.y.sign(), axis.z.sign()} : axis;
}

}  // namespace

ExactPoint apply(const AffineMap& map, const ExactPoint& point) {
  return apply_to_direction(map, point) + constant_column(map);
}

ExactPoint apply_to_direction(const AffineMap& map, const ExactPoint& direction) {
  return {dot(linear_row(map.rows[0]), direction), dot(linear_row(map.rows[1]), direction),
          dot(linear_row(map.rows[2]), direction)};
}

AffineMap compose(const AffineMap& second, const AffineMap& first) {
  AffineMap result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      Rational sum = column == 3 ? second.rows[row][3] : Rational(0);
      for (std::size_t k = 0; k < 3; ++k) {
        sum += second.rows[row][k] * first.rows[k][column];
      }
      result.rows[row][column] = sum;
    }
  }
  return result;
}

Rational determinant(const AffineMap& map) {
  return dot(linear_row(map.rows[0]), cross(linear_row(map.rows[1]), linear_row(map.rows[2])));
}

std::optional<AffineMap> inverse(const AffineMap& map) {
  const Rational scale = determinant(map);
  if (scale.is_zero()) {
    return std::nullopt;
  }
  // The columns of the adjugate are the cross products of the rows.
  std::array<ExactPoint, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    columns[i] = Rational(1 / scale) *
                 cross(linear_row(map.rows[(i + 1) % 3]), linear_row(map.rows[(i + 2) % 3]));
  }
  AffineMap result{{AffineMap::Row{columns[0].x, columns[1].x, columns[2].x, 0},
                    AffineMap::Row{columns[0].y, columns[1].y, columns[2].y, 0},
                    AffineMap::Row{columns[0].z, columns[1].z, columns[2].z, 0}}};
  const ExactPoint shift = apply_to_direction(result, constant_column(map));
  result.rows[0][3] = -shift.x;
  result.rows[1][3] = -shift.y;
  result.rows[2][3] = -shift.z;
  return result;
}

AffineMap translation(const ExactPoint& by) {
  return {{AffineMap::Row{1, 0, 0, by.x}, AffineMap::Row{0, 1, 0, by.y},
           AffineMap::Row{0, 0, 1, by.z}}};
}

AffineMap scaling(const ExactPoint& by) {
  return {{AffineMap::Row{by.x, 0, 0, 0}, AffineMap::Row{0, by.y, 0, 0},
           AffineMap::Row{0, 0, by.z, 0}}};
}

AffineMap reflection(const ExactPoint& normal) {
  LAMINA_REQUIRE(!is_zero(normal), "the normal of a reflection is not zero");
  // p - 2 n (n.p) / (n.n)
  const std::array<Rational, 3> n{normal.x, normal.y, normal.z};
  const Rational factor = 2 / dot(normal, normal);
  AffineMap result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result.rows[row][column] -= factor * n[row] * n[column];
    }
  }
  return result;
}

AffineMap rotation(const Rational& w, const ExactPoint& xyz) {
  const auto& [x, y, z] = xyz;
  const Rational square = w * w + dot(xyz, xyz);
  LAMINA_REQUIRE(!square.is_zero(), "the quaternion of a rotation is not zero");
  const Rational s = 2 / square;
  return {{AffineMap::Row{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), 0},
           AffineMap::Row{s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), 0},
           AffineMap::Row{s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), 0}}};
}

AffineMap rotation_about(const ExactPoint& axis, const Rational& degrees) {
  LAMINA_REQUIRE(!is_zero(axis), "the axis of a rotation is not zero");
  const ExactPoint direction = with_unit_length_if_coordinate_axis(axis);
  const Rational angle = number::reduced_degrees(degrees);
  if (angle == 180) {
    return rotation(0, direction);
  }
  const double tangent =
      number::tangent_of_degrees_over_root(Rational(angle / 2), dot(direction, direction));
  // Beyond the range of double the angle is within 1e-300 of a half turn.
  return std::isinf(tangent) ? rotation(0, direction) : rotation(1, Rational(tangent) * direction);
}

CosSin cos_sin_degrees(const Rational& degrees) {
  return {Rational(number::sine_of_degrees(Rational(90 - degrees))),
          Rational(number::sine_of_degrees(degrees))};
}

}  // namespace lamina::geometry
