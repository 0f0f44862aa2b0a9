#include "trace/render.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <optional>

namespace lamina::trace {

bool each_pixel(const ImageSize& size, int threads, const std::function<PixelWork()>& make_work,
                const PixelProgress& progress) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  tbb::enumerable_thread_specific<PixelWork> works(make_work);
  const auto width = static_cast<std::uint64_t>(size.width);
  for (int y = 0; y < size.height; ++y) {
    tbb::parallel_for(0, size.width, [&](int x) { works.local()(x, y); });
    if (!progress(width * (y + 1), width * size.height) && y + 1 < size.height) {
      return false;
    }
  }
  return true;
}

}  // namespace lamina::trace
