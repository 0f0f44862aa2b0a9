// Runs the program as a user would.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/scratch.hpp"

namespace lamina::test {

struct Outcome {
  int status = -1;
  std::string out;
  std::string error;
};

inline std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Runs `lamina` with arguments in shell syntax.
inline Outcome lamina(const std::string& arguments) {
  const Scratch scratch;
  const std::string command = std::string(LAMINA_PROGRAM) + " " + arguments + " >" +
                              scratch.path("out") + " 2>" + scratch.path("error") + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(scratch.path("out")),
          read(scratch.path("error"))};
}

/// One JSON object a line.
inline std::vector<nlohmann::json> json_lines(const std::string& text) {
  std::vector<nlohmann::json> objects;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    objects.push_back(nlohmann::json::parse(line));
  }
  return objects;
}

}  // namespace lamina::test
