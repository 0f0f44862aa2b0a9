#include "base/contract.hpp"

#include <fmt/format.h>

namespace lamina::base {

void contract_failed(const char* condition, const char* file, int line,
                     const std::string& message) {
  throw ContractError(
      fmt::format("{}:{}: contract broken: {} ({})", file, line, message, condition));
}

}  // namespace lamina::base
