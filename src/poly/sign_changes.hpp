// Descartes' rule of signs: counting sign changes.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "poly/polynomial.hpp"

namespace lamina::poly {

/// C(n, k) up to kMostDegree: the weights of the Bernstein basis.
inline constexpr auto kBinomials = [] {
  std::array<std::array<int, kMostDegree + 1>, kMostDegree + 1> c{};
  for (int n = 0; n <= kMostDegree; ++n) {
    c[n][0] = 1;
    for (int k = 1; k <= n; ++k) {
      c[n][k] = c[n - 1][k - 1] + c[n - 1][k];
    }
  }
  return c;
}();

/// Returns the most sign changes, zeros left out, that numbers of these signs can have; a sign that
/// is not known may be any.
inline int most_sign_changes(std::span<const std::optional<int>> signs) {
  constexpr int kNever = -1;
  std::array<int, 2> most{kNever, kNever};  // by the last sign: minus, plus
  for (const std::optional<int>& sign : signs) {
    if (sign && *sign == 0) {
      continue;
    }
    const std::array<int, 2> before = most;
    for (const int s : {0, 1}) {
      if (sign && (*sign > 0) != (s == 1)) {
        most[s] = kNever;
        continue;
      }
      const int changed = before[1 - s] == kNever ? kNever : before[1 - s] + 1;
      most[s] = std::max({before[s], changed, 0});
    }
    if (!sign) {  // it may be zero, too
      most = {std::max(most[0], before[0]), std::max(most[1], before[1])};
    }
  }
  return std::max({most[0], most[1], 0});
}

}  // namespace lamina::poly
