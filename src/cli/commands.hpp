// The program's commands: each adds its options, and what to do, to the parser.
#pragma once

#include <CLI/CLI.hpp>

namespace lamina::cli {

void add_trace(CLI::App& app);
void add_locate(CLI::App& app);
void add_explain(CLI::App& app);
void add_census(CLI::App& app);
void add_convert(CLI::App& app);
void add_minimise(CLI::App& app);
void add_run(CLI::App& app);
void add_render(CLI::App& app);
void add_solve(CLI::App& app);
void add_table(CLI::App& app);
void add_list(CLI::App& app);

}  // namespace lamina::cli
