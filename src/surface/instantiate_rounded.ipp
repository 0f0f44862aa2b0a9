// The templates of surfaces in rounded numbers, and how all of them are instantiated for one type:
// once, in rounded_hardware.cpp, rounded_narrow_bin.cpp and so on.
#pragma once

#include "surface/generalised_conic.ipp"
#include "surface/parity_trimming.ipp"
#include "surface/rounded_sphere_sweep.ipp"
#include "surface/rounded_surface.ipp"
#include "surface/rounded_sweep.ipp"

#define LAMINA_INSTANTIATE_ROUNDED(Number)                                                \
  template class RoundedMap<Number>;                                                      \
  template class RoundedSurface<Number>;                                                  \
  template class RoundedSweep<Number>;                                                    \
  template class RoundedSphereSweep<Number>;                                              \
  template void trim_by_parity(const RoundedSweep<Number>&, const geometry::Ray<Number>&, \
                               std::vector<RoundedSweep<Number>::Crossing>&);
