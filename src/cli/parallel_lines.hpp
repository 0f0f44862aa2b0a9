// Lines of output made in parallel and printed in order.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/progress.hpp"

namespace lamina::cli {

/// Prints line(worker, i) for i in 0 .. count-1, in order. Blocks of items are worked on in
/// parallel, each by a worker of its own from make_worker(): lines do not depend on threads.
/// Stops between batches of blocks at Ctrl-C.
template <typename MakeWorker, typename Line>
void print_lines(std::size_t count, MakeWorker make_worker, Line line) {
  constexpr std::size_t kBlock = 64;
  constexpr std::size_t kBatch = 16 * kBlock;
  const auto progress = progress_bar();
  for (std::size_t first = 0; first < count; first += kBatch) {
    const std::size_t last = std::min(first + kBatch, count);
    const std::size_t blocks = (last - first + kBlock - 1) / kBlock;
    std::vector<std::string> texts(blocks);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
      auto worker = make_worker();
      const std::size_t begin = first + block * kBlock;
      for (std::size_t i = begin; i < std::min(begin + kBlock, last); ++i) {
        texts[block] += line(worker, i);
        texts[block] += '\n';
      }
    });
    for (const std::string& text : texts) {
      std::fwrite(text.data(), 1, text.size(), stdout);
    }
    std::fflush(stdout);
    if (!progress(last, count)) {
      break;
    }
  }
}

}  // namespace lamina::cli
