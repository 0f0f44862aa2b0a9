// How GoogleTest prints exact points and maps.
#pragma once

#include <ostream>

#include "geometry/affine.hpp"

namespace lamina::geometry {

inline void PrintTo(const ExactPoint& point, std::ostream* out) {
  *out << "(" << point.x << " " << point.y << " " << point.z << ")";
}

inline void PrintTo(const AffineMap& map, std::ostream* out) {
  for (const AffineMap::Row& row : map.rows) {
    *out << "[" << row[0] << " " << row[1] << " " << row[2] << " " << row[3] << "]";
  }
}

}  // namespace lamina::geometry
