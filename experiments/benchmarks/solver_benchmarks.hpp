// The benchmarks of root finders.
#pragma once

namespace lamina::benchmarks {

void register_solvers();

}  // namespace lamina::benchmarks
