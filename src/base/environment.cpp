#include "base/environment.hpp"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <tbb/version.h>

#include <algorithm>
#include <fstream>

#include <commit.hpp>  // written by the build

namespace lamina::base {
namespace {

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      return line.substr(std::min(line.find(':') + 2, line.size()));
    }
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  return uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine)
                           : "unknown";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> environment() {
  return {{"version", LAMINA_VERSION},
          {"commit", LAMINA_COMMIT},
          {"compiler", compiler()},
          {"flags", LAMINA_FLAGS},
          {"fmt", fmt::format("{}", FMT_VERSION)},
          {"onetbb", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
          {"sqlite", sqlite3_libversion()},
          {"processor", processor()},
          {"system", system_name()}};
}

}  // namespace lamina::base
