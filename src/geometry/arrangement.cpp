#include "geometry/arrangement.hpp"

#include <utility>
#include <vector>

#include "base/contract.hpp"

namespace lamina::geometry {
namespace {

bool is_zero(const IntegerVector& v) { return v.x.is_zero() && v.y.is_zero() && v.z.is_zero(); }

IntegerVector times(int sign, const IntegerVector& v) { return number::Integer(sign) * v; }

// An edge: where two planes or more meet, in one of its two directions.
struct Edge {
  IntegerVector along;
  std::vector<int> signs;             // of normal . along
  std::vector<std::size_t> contacts;  // planes that contain it

  Edge(std::span<const IntegerVector> normals, IntegerVector direction)
      : along(std::move(direction)) {
    for (std::size_t k = 0; k < normals.size(); ++k) {
      signs.push_back(number::sign(dot(normals[k], along)));
      if (signs.back() == 0) {
        contacts.push_back(k);
      }
    }
  }

  [[nodiscard]] Edge reversed() const {
    Edge result = *this;
    result.along = times(-1, along);
    for (int& sign : result.signs) {
      sign = -sign;
    }
    return result;
  }

  // Were i and j the first two planes to meet here?
  [[nodiscard]] bool first_found_by(std::span<const IntegerVector> normals, std::size_t i,
                                    std::size_t j) const {
    for (const std::size_t k : contacts) {
      if (k < i || (k > i && k < j && !is_zero(cross(normals[i], normals[k])))) {
        return false;
      }
    }
    return true;
  }
};

// Visits the cells at the edge: both sides of each half-plane that ends there.
bool visit_cells_at(const Edge& edge, std::span<const IntegerVector> normals,
                    const CellVisitor& visit) {
  std::vector<int> signs = edge.signs;
  for (const std::size_t side : edge.contacts) {
    const IntegerVector across = cross(normals[side], edge.along);
    for (const int direction : {-1, 1}) {
      for (const int above : {-1, 1}) {
        const LimitDirection witness{edge.along, times(direction, across),
                                     times(above, normals[side])};
        for (const std::size_t k : edge.contacts) {
          signs[k] = sign_along(normals[k], witness);
        }
        if (!visit(witness, signs)) {
          return false;
        }
      }
    }
  }
  return true;
}

// One plane alone: its two sides.
void visit_sides(std::span<const IntegerVector> normals, const CellVisitor& visit) {
  for (const int above : {-1, 1}) {
    const LimitDirection witness{times(above, normals[0]), {}, {}};
    std::vector<int> signs;
    for (const IntegerVector& normal : normals) {
      signs.push_back(sign_along(normal, witness));
    }
    if (!visit(witness, signs)) {
      return;
    }
  }
}

}  // namespace

int sign_along(const IntegerVector& normal, const LimitDirection& direction) {
  for (const IntegerVector* step : {&direction.along, &direction.across, &direction.off}) {
    if (const int sign = number::sign(dot(normal, *step)); sign != 0) {
      return sign;
    }
  }
  return 0;
}

void for_each_cell(std::span<const IntegerVector> normals, const CellVisitor& visit) {
  LAMINA_REQUIRE(!normals.empty(), "one plane or more");
  bool all_parallel = true;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    LAMINA_REQUIRE(!is_zero(normals[i]), "a plane has a normal");
    for (std::size_t j = i + 1; j < normals.size(); ++j) {
      const IntegerVector along = cross(normals[i], normals[j]);
      if (is_zero(along)) {
        continue;
      }
      all_parallel = false;
      const Edge edge(normals, along);
      if (!edge.first_found_by(normals, i, j)) {
        continue;
      }
      if (!visit_cells_at(edge, normals, visit) ||
          !visit_cells_at(edge.reversed(), normals, visit)) {
        return;
      }
    }
  }
  if (all_parallel) {
    visit_sides(normals, visit);
  }
}

}  // namespace lamina::geometry
