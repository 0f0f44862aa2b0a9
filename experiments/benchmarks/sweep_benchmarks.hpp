// The benchmarks of swept splines.
#pragma once

namespace lamina::benchmarks {

void register_sweeps();

}  // namespace lamina::benchmarks
