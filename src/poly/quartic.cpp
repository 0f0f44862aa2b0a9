// The only file that compiles these templates.
#include "poly/quartic.ipp"

#include "number/all_numbers.hpp"

namespace lamina::poly {

#define LAMINA_INSTANTIATE(Number) \
  template LineRoots<Number> quartic_crossings<Number>(const std::array<Number, 5>&, QuarticSolver);
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::poly
