#include "trace/render.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace lamina::trace {
namespace {

TEST(RenderTest, DoesEveryPixelOnce) {
  const ImageSize size{7, 9};
  for (const int threads : {0, 1, 3}) {
    std::vector<std::atomic<int>> times(7 * 9);
    std::uint64_t last = 0;
    EXPECT_TRUE(each_pixel(
        size, threads, [&] { return [&](int x, int y) { ++times[y * 7 + x]; }; },
        [&](std::uint64_t done, std::uint64_t total) {
          EXPECT_GT(done, last);
          EXPECT_EQ(total, 63U);
          last = done;
          return true;
        }));
    EXPECT_EQ(last, 63U);
    for (const auto& count : times) {
      EXPECT_EQ(count, 1);
    }
  }
}

TEST(RenderTest, StopsWhereProgressSays) {
  std::atomic<int> done = 0;
  EXPECT_FALSE(each_pixel(
      {10, 100}, 1, [&] { return [&](int, int) { ++done; }; },
      [](std::uint64_t, std::uint64_t) { return false; }));
  EXPECT_GT(done, 0);
  EXPECT_LT(done, 1000);
}

}  // namespace
}  // namespace lamina::trace
