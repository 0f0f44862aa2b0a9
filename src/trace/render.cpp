#include "trace/render.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

namespace lamina::trace {

bool each_pixel(const ImageSize& size, int threads, const std::function<PixelWork()>& make_work,
                const PixelProgress& progress) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  tbb::enumerable_thread_specific<PixelWork> works(make_work);
  constexpr int kRows = 4;
  for (int first = 0; first < size.height; first += kRows) {
    const int last = std::min(first + kRows, size.height);
    tbb::parallel_for(first * size.width, last * size.width,
                      [&](int pixel) { works.local()(pixel % size.width, pixel / size.width); });
    const auto width = static_cast<std::uint64_t>(size.width);
    if (!progress(width * last, width * size.height) && last < size.height) {
      return false;
    }
  }
  return true;
}

}  // namespace lamina::trace
