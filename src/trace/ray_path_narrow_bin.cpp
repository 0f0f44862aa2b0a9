#include "number/all_numbers.hpp"
#include "trace/ray_path.ipp"

namespace lamina::trace {

#define LAMINA_INSTANTIATE(Number)                                             \
  template std::unique_ptr<RayPath> make_ray_path<Number>(const scene::Scene&, \
                                                          const poly::Solvers&);
LAMINA_FOR_EACH_NARROW_BIN_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::trace
