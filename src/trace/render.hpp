// Pixels of a picture, in parallel.
#pragma once

#include <cstdint>
#include <functional>

#include "trace/camera.hpp"

namespace lamina::trace {

/// Does one pixel; each thread has one of its own.
using PixelWork = std::function<void(int x, int y)>;

/// Called between rows: pixels done and in all; returns false to stop.
using PixelProgress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// Does every pixel once, rows from the top. Returns false if it was stopped early. What is done
/// for a pixel must depend on nothing but the pixel: then the result does not depend on threads.
///
/// Arguments: threads  0: as many as the machine has.
bool each_pixel(const ImageSize& size, int threads, const std::function<PixelWork()>& make_work,
                const PixelProgress& progress);

}  // namespace lamina::trace
