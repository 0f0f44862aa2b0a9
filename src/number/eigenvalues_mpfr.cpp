#include "number/all_numbers.hpp"
#include "number/eigenvalues.ipp"

namespace lamina::number {

#define LAMINA_INSTANTIATE(Number)                                     \
  template bool companion_eigenvalues<Number>(std::span<const Number>, \
                                              std::span<Eigenvalue<Number>>);
LAMINA_FOR_EACH_MPFR_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::number
