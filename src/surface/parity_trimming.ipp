#pragma once

#include <algorithm>
#include <utility>

#include "surface/parity_trimming.hpp"

namespace lamina::surface {

template <number::RoundedNumber Number>
void trim_by_parity(const RoundedSweep<Number>& sweep, const geometry::Ray<Number>& local,
                    std::vector<typename RoundedSweep<Number>::Crossing>& crossings) {
  using Crossing = typename RoundedSweep<Number>::Crossing;
  if (sweep.sweep() == Sweep::Rotational) {
    return;
  }
  const Number& o_z = local.origin.z;
  Number d_z = local.direction.z;
  if (d_z == 0) {
    const auto& small_value = sweep.printed().small_value;
    if (!small_value) {
      if (o_z < 0 || o_z > 1) {
        crossings.clear();
      }
      return;
    }
    d_z = static_cast<Number>(*small_value);
  }
  Crossing near{-o_z / d_z, Number(0), kBasePlane};
  Crossing far{(1 - o_z) / d_z, Number(0), kCapPlane};
  if (d_z < 0) {
    std::swap(near, far);
  }
  const auto before = [](const Crossing& x, const Crossing& y) { return x.t < y.t; };
  const auto is_odd = [](auto count) { return count % 2 != 0; };
  if (sweep.sweep() == Sweep::Conic) {
    crossings.erase(std::lower_bound(crossings.begin(), crossings.end(), far, before),
                    crossings.end());
    crossings.erase(crossings.begin(),
                    std::lower_bound(crossings.begin(), crossings.end(), near, before));
    if (is_odd(crossings.size())) {
      crossings.insert(d_z > 0 ? crossings.end() : crossings.begin(), d_z > 0 ? far : near);
    }
    return;
  }
  crossings.erase(crossings.begin(),
                  std::upper_bound(crossings.begin(), crossings.end(), near, before));
  crossings.insert(crossings.begin(), near);
  const auto at_far =
      crossings.insert(std::lower_bound(crossings.begin() + 1, crossings.end(), far, before), far);
  crossings.erase(is_odd(crossings.end() - (at_far + 1)) ? at_far + 1 : at_far, crossings.end());
  if (is_odd(crossings.size())) {
    crossings.erase(crossings.begin());
  }
}

}  // namespace lamina::surface
