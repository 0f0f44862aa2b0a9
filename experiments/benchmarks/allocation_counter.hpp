#pragma once

#include <cstdint>

namespace lamina::benchmarks {

/// Heap allocations by `new` since the program began.
std::uint64_t allocations();

}  // namespace lamina::benchmarks
