// Polynomials as lists of coefficients of 1, t, t^2 ... over a ring: rationals, intervals, or
// numbers that round. Leading zeros are allowed; the empty list is zero.
#pragma once

#include <cstddef>
#include <vector>

namespace lamina::surface {

template <typename Ring>
std::vector<Ring> multiply(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  if (a.empty() || b.empty()) {
    return {};
  }
  std::vector<Ring> product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

/// Adds factor * b to a.
template <typename Ring, typename Factor>
void add(std::vector<Ring>& a, const std::vector<Ring>& b, const Factor& factor) {
  if (a.size() < b.size()) {
    a.resize(b.size());
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] += factor * b[i];
  }
}

/// Adds b to a.
template <typename Ring>
void add(std::vector<Ring>& a, const std::vector<Ring>& b) {
  if (a.size() < b.size()) {
    a.resize(b.size());
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] += b[i];
  }
}

/// outer(inner(t)), the outer one's coefficients each as `held(c)`. Contract: the outer polynomial
/// is not empty.
template <typename Coefficient, typename Ring, typename Held>
std::vector<Ring> composed(const std::vector<Coefficient>& outer, const std::vector<Ring>& inner,
                           const Held& held) {
  std::vector<Ring> result{held(outer.back())};
  for (std::size_t i = outer.size() - 1; i-- > 0;) {
    result = multiply(result, inner);
    add(result, std::vector<Ring>{held(outer[i])});
  }
  return result;
}

}  // namespace lamina::surface
