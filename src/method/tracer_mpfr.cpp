#include "method/tracer.ipp"
#include "number/all_numbers.hpp"

namespace lamina::method {

#define LAMINA_INSTANTIATE(Number)  \
  template class RayEvents<Number>; \
  template std::unique_ptr<Tracer> make_tracer<Number>(const scene::Scene&, const poly::Solvers&);
LAMINA_FOR_EACH_MPFR_NUMBER(LAMINA_INSTANTIATE)
#undef LAMINA_INSTANTIATE

}  // namespace lamina::method
