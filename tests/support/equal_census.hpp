// Compares censuses, number by number.
#pragma once

#include <gtest/gtest.h>

#include "census/census.hpp"

namespace lamina::support {

inline void expect_equal(const census::Census& a, const census::Census& b) {
  EXPECT_EQ(a.rays, b.rays);
  EXPECT_EQ(a.in_carrier, b.in_carrier);
  EXPECT_EQ(a.with_coincidence, b.with_coincidence);
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    const census::Cell& x = a.cells[i];
    const census::Cell& y = b.cells[i];
    EXPECT_EQ(x.method, y.method);
    EXPECT_EQ(x.number, y.number);
    EXPECT_EQ(x.significand_bits, y.significand_bits);
    EXPECT_EQ(x.rays, y.rays);
    EXPECT_EQ(x.with, y.with);
    EXPECT_EQ(x.caused, y.caused);
    EXPECT_EQ(x.order_sensitive, y.order_sensitive);
    EXPECT_EQ(x.most_outcomes, y.most_outcomes);
    EXPECT_EQ(x.wrong_length, y.wrong_length);
    EXPECT_EQ(x.persistence, y.persistence);
    EXPECT_EQ(x.lamina_fronts, y.lamina_fronts);
    EXPECT_EQ(x.lamina_fronts_seen, y.lamina_fronts_seen);
    EXPECT_EQ(x.lamina_backs, y.lamina_backs);
    EXPECT_EQ(x.lamina_backs_seen, y.lamina_backs_seen);
    EXPECT_EQ(x.largest.t_ulps, y.largest.t_ulps);
    EXPECT_EQ(x.largest.point_rel, y.largest.point_rel);
    EXPECT_EQ(x.largest.normal_rad, y.largest.normal_rad);
    ASSERT_EQ(x.worst.has_value(), y.worst.has_value());
    if (x.worst) {
      EXPECT_EQ(x.worst->scene, y.worst->scene);
      EXPECT_EQ(x.worst->ray.origin, y.worst->ray.origin);
      EXPECT_EQ(x.worst->ray.direction, y.worst->ray.direction);
      EXPECT_EQ(x.worst->artifacts, y.worst->artifacts);
      EXPECT_EQ(x.worst->wrong_length, y.worst->wrong_length);
    }
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
