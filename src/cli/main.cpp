// The `lamina` program. Exit status: 0 done, 1 internal error, 2 bad input or usage, 130
// interrupted: what was finished is printed.
#include <fmt/format.h>

#include <cstdio>

#include "base/contract.hpp"
#include "base/environment.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "number/versions.hpp"

namespace {

std::string version_text() {
  std::string text;
  for (const auto& [name, value] : lamina::base::environment()) {
    text += name == "version" ? fmt::format("lamina {}\n", value)
                              : fmt::format("{:<10} {}\n", name, value);
  }
  for (const auto& [name, value] : lamina::number::library_versions()) {
    text += fmt::format("{:<10} {}\n", name, value);
  }
  text.pop_back();
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace lamina;
  CLI::App app(
      "Lamina: numerical robustness of ray-traced constructive solid geometry.\n"
      "Runs every method on every number type, and counts against exact arithmetic what each "
      "gets wrong.");
  app.name("lamina");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  cli::add_trace(app);
  cli::add_locate(app);
  cli::add_explain(app);
  cli::add_census(app);
  cli::add_minimise(app);
  cli::add_convert(app);
  cli::add_run(app);
  cli::add_render(app);
  cli::add_solve(app);
  cli::add_table(app);
  cli::add_list(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const base::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "internal error: {}\n", error.what());
    return 1;
  }
  return cli::interrupted() ? 130 : 0;
}
