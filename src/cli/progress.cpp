#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>

namespace lamina::cli {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void on_interrupt(int) {
  g_interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void catch_interrupts() { std::signal(SIGINT, on_interrupt); }

bool interrupted() { return g_interrupted != 0; }

std::function<bool(std::uint64_t, std::uint64_t)> progress_bar(const std::string& what) {
  using Clock = std::chrono::steady_clock;
  constexpr int kWidth = 40;
  const bool on_terminal = isatty(STDERR_FILENO) != 0;
  return [on_terminal, label = what.empty() ? "" : what + " ", start = Clock::now(),
          last = std::make_shared<Clock::time_point>(),
          begun = std::make_shared<double>(-1)](std::uint64_t done, std::uint64_t total) {
    const auto now = Clock::now();
    const bool finished = done >= total;
    if (on_terminal && total > 0 && (finished || now - *last > std::chrono::milliseconds(100))) {
      *last = now;
      const double part = static_cast<double>(done) / static_cast<double>(total);
      const std::chrono::duration<double> spent = now - start;
      // What a resumed run had already took none of this time.
      if (*begun < 0) {
        *begun = part;
      }
      const double left = part > *begun ? spent.count() * (1 - part) / (part - *begun) : 0;
      const int filled = static_cast<int>(part * kWidth);
      // The bar is wiped when it is full: only results stay on the screen.
      fmt::print(stderr, "\r\033[K{}",
                 finished ? std::string()
                          : fmt::format("{}[{:#<{}}{:.<{}}] {:3.0f} %  {:.0f} s left", label, "",
                                        filled, "", kWidth - filled, 100 * part, left));
      std::fflush(stderr);
    }
    return !interrupted();
  };
}

}  // namespace lamina::cli
