#include "method/tracer.ipp"

namespace lamina::method {

template std::unique_ptr<Tracer> make_tracer<number::exact>(const scene::Scene&,
                                                            const poly::Solvers&);

}  // namespace lamina::method
