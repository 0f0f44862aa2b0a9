// The only file that compiles these templates.
#include "surface/rounded_sweep.ipp"

#include "number/all_numbers.hpp"

namespace lamina::surface {

#define LAMINA_INSTANTIATE(Number) template class RoundedSweep<Number>;
LAMINA_FOR_EACH_ROUNDED_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::surface
