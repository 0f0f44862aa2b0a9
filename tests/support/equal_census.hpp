// Compares censuses, number by number.
#pragma once

#include <gtest/gtest.h>

#include "census/census.hpp"

namespace lamina::support {

/// All of a cell but the sum of lengths, which depends on how it is put together.
inline void expect_equal_counts(const census::Cell& a, const census::Cell& b) {
  SCOPED_TRACE(a.method + " " + a.number);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.significand_bits, b.significand_bits);
  EXPECT_EQ(a.rays, b.rays);
  EXPECT_EQ(a.with, b.with);
  EXPECT_EQ(a.caused, b.caused);
  EXPECT_EQ(a.order_sensitive, b.order_sensitive);
  EXPECT_EQ(a.most_outcomes, b.most_outcomes);
  EXPECT_EQ(a.persistence, b.persistence);
  EXPECT_EQ(a.lamina_fronts, b.lamina_fronts);
  EXPECT_EQ(a.lamina_fronts_seen, b.lamina_fronts_seen);
  EXPECT_EQ(a.lamina_backs, b.lamina_backs);
  EXPECT_EQ(a.lamina_backs_seen, b.lamina_backs_seen);
  EXPECT_EQ(a.largest.t_ulps, b.largest.t_ulps);
  EXPECT_EQ(a.largest.point_rel, b.largest.point_rel);
  EXPECT_EQ(a.largest.normal_rad, b.largest.normal_rad);
  ASSERT_EQ(a.worst.has_value(), b.worst.has_value());
  if (a.worst) {
    EXPECT_EQ(a.worst->scene, b.worst->scene);
    EXPECT_EQ(a.worst->ray.origin, b.worst->ray.origin);
    EXPECT_EQ(a.worst->ray.direction, b.worst->ray.direction);
    EXPECT_EQ(a.worst->artifacts, b.worst->artifacts);
    EXPECT_EQ(a.worst->wrong_length, b.worst->wrong_length);
  }
}

inline void expect_equal(const census::Census& a, const census::Census& b) {
  EXPECT_EQ(a.rays, b.rays);
  EXPECT_EQ(a.in_carrier, b.in_carrier);
  EXPECT_EQ(a.with_coincidence, b.with_coincidence);
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    expect_equal_counts(a.cells[i], b.cells[i]);
    EXPECT_EQ(a.cells[i].wrong_length, b.cells[i].wrong_length);
  }
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t i = 0; i < a.pairs.size(); ++i) {
    EXPECT_EQ(a.pairs[i].number, b.pairs[i].number);
    EXPECT_EQ(a.pairs[i].first, b.pairs[i].first);
    EXPECT_EQ(a.pairs[i].second, b.pairs[i].second);
    EXPECT_EQ(a.pairs[i].only_first_wrong, b.pairs[i].only_first_wrong);
    EXPECT_EQ(a.pairs[i].only_second_wrong, b.pairs[i].only_second_wrong);
  }
}

}  // namespace lamina::support
