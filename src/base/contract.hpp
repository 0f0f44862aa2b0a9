// Contract checks and the two kinds of failure a caller can see.
#pragma once

#include <stdexcept>
#include <string>

namespace lamina::base {

/// A broken contract: a defect in the calling code, never a difficult input.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Bad input: a scene, a ray file or an argument that the user can mend. The
/// message says what is wrong, where, and what to write instead.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void contract_failed(const char* condition, const char* file, int line,
                                  const std::string& message);

}  // namespace lamina::base

/// Checks a contract in every build type; throws ContractError with file and line.
#define LAMINA_REQUIRE(condition, message)                                        \
  do {                                                                            \
    if (!(condition)) {                                                           \
      ::lamina::base::contract_failed(#condition, __FILE__, __LINE__, (message)); \
    }                                                                             \
  } while (false)
