#include "number/all_numbers.hpp"
#include "surface/instantiate_rounded.ipp"

namespace lamina::surface {

LAMINA_FOR_EACH_NARROW_BIN_NUMBER(LAMINA_INSTANTIATE_ROUNDED)

}  // namespace lamina::surface
