#include "geometry/arrangement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "base/contract.hpp"
#include "base/seeded_stream.hpp"
#include "support/class_tally.hpp"

namespace lamina::geometry {
namespace {

using number::Integer;
using SignVector = std::vector<int>;

IntegerVector random_vector(base::SeededStream& stream, std::int64_t reach) {
  return {stream.integer(-reach, reach), stream.integer(-reach, reach),
          stream.integer(-reach, reach)};
}

bool is_zero(const IntegerVector& v) { return v == IntegerVector{}; }

SignVector signs_of(const std::vector<IntegerVector>& normals, const IntegerVector& direction) {
  SignVector signs;
  for (const IntegerVector& normal : normals) {
    signs.push_back(number::sign(dot(normal, direction)));
  }
  return signs;
}

// The limit direction with e = 1/n, times n^2: for n large enough it is in the cell.
IntegerVector at_finite_step(const LimitDirection& limit, const Integer& n) {
  return Integer(n * n) * limit.along + n * limit.across + limit.off;
}

std::set<SignVector> cells(const std::vector<IntegerVector>& normals) {
  std::set<SignVector> found;
  for_each_cell(normals, [&](const LimitDirection& witness, std::span<const int> signs) {
    const SignVector vector(signs.begin(), signs.end());
    const Integer far = Integer(1) << 200;
    EXPECT_EQ(signs_of(normals, at_finite_step(witness, far)), vector);
    for (std::size_t k = 0; k < normals.size(); ++k) {
      EXPECT_EQ(sign_along(normals[k], witness), vector[k]);
    }
    found.insert(vector);
    return true;
  });
  return found;
}

// k planes in general position, no three in one line, leave k^2 - k + 2 cells.
TEST(ArrangementTest, CountsTheCellsOfPlanesInGeneralPosition) {
  std::vector<IntegerVector> normals;
  for (std::int64_t k = 1; k <= 12; ++k) {
    normals.push_back({1, k, k * k});  // Vandermonde: any three are independent
    EXPECT_EQ(cells(normals).size(), k * k - k + 2);
  }
}

// Planes through one line leave two cells each; one more plane across it cuts each in two.
TEST(ArrangementTest, CountsTheCellsOfAPencil) {
  std::vector<IntegerVector> normals;
  for (std::int64_t k = 1; k <= 12; ++k) {
    normals.push_back({1, k, 0});
    EXPECT_EQ(cells(normals).size(), 2 * k);
    std::vector<IntegerVector> across = normals;
    across.push_back({3, -5, 7});
    EXPECT_EQ(cells(across).size(), 4 * k);
  }
}

TEST(ArrangementTest, ParallelNormalsAreOnePlane) {
  EXPECT_EQ(cells({{1, 2, 3}, {-2, -4, -6}}), (std::set<SignVector>{{1, -1}, {-1, 1}}));
  EXPECT_EQ(cells({{1, 0, 0}, {3, 0, 0}, {0, 1, 0}}).size(), 4);
  EXPECT_EQ(cells({{0, 0, 5}}).size(), 2);
}

// No direction has signs that no cell has, and every witness realises its signs (in cells).
TEST(ArrangementTest, FindsTheCellOfEveryDirection) {
  support::ClassTally reached({"parallel", "pencil", "general"});
  for (std::uint64_t case_id = 0; case_id < 120; ++case_id) {
    base::SeededStream stream("geometry/arrangement", 1, case_id);
    // Small coordinates make coincidences common.
    const std::int64_t reach = std::array{1, 2, 50}[case_id % 3];
    std::vector<IntegerVector> normals;
    for (std::uint64_t k = 1 + stream.below(9); normals.size() < k;) {
      if (const IntegerVector normal = random_vector(stream, reach); !is_zero(normal)) {
        normals.push_back(normal);
      }
    }
    bool parallel = false;
    bool pencil = false;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      for (std::size_t j = i + 1; j < normals.size(); ++j) {
        const IntegerVector edge = cross(normals[i], normals[j]);
        parallel = parallel || is_zero(edge);
        for (std::size_t k = j + 1; k < normals.size() && !is_zero(edge); ++k) {
          pencil = pencil || dot(edge, normals[k]).is_zero();
        }
      }
    }
    reached.add("parallel", parallel);
    reached.add("pencil", pencil);
    reached.add("general", !parallel && !pencil);

    const std::set<SignVector> found = cells(normals);
    for (int i = 0; i < 2000; ++i) {
      const SignVector signs = signs_of(normals, random_vector(stream, 1000));
      if (std::find(signs.begin(), signs.end(), 0) == signs.end()) {
        EXPECT_TRUE(found.contains(signs)) << "case " << case_id;
      }
    }
  }
  EXPECT_TRUE(reached.each_at_least(20)) << reached;
}

TEST(ArrangementTest, StopsWhenAskedTo) {
  const std::vector<IntegerVector> normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int visits = 0;
  for_each_cell(normals, [&](const auto&, auto) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

TEST(ArrangementTest, RefusesPlanesWithoutNormal) {
  const auto ignore = [](const auto&, auto) { return true; };
  const std::vector<IntegerVector> with_zero{{1, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(for_each_cell(with_zero, ignore), base::ContractError);
  EXPECT_THROW(for_each_cell({}, ignore), base::ContractError);
}

}  // namespace
}  // namespace lamina::geometry
