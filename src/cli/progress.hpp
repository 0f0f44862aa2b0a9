// A progress bar on a terminal, and Ctrl-C that keeps what is finished.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace lamina::cli {

/// From now on Ctrl-C asks to stop instead of killing; a second one kills.
void catch_interrupts();
bool interrupted();

/// Draws on standard error if that is a terminal, and nothing in a pipe. Returns false once
/// Ctrl-C was pressed. `what` stands in front of the bar.
std::function<bool(std::uint64_t done, std::uint64_t total)> progress_bar(
    const std::string& what = "");

}  // namespace lamina::cli
