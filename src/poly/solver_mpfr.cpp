#include "number/all_numbers.hpp"
#include "poly/solver.ipp"

namespace lamina::poly {

#define LAMINA_INSTANTIATE(Number)                                                             \
  template RealRoots<Number> real_roots<Number>(std::span<const Number>, const Range<Number>&, \
                                                Solver);                                       \
  template LineRoots<Number> crossings<Number>(std::span<const Number>, Solver);
LAMINA_FOR_EACH_MPFR_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::poly
