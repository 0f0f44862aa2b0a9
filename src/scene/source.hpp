// The text of a scene, and messages that point into it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lamina::scene {

/// A named text. Positions in it are byte offsets; messages show line and column, both
/// from 1, columns counted in characters (UTF-8). Refers to strings that must outlive it.
class Source {
 public:
  Source(std::string_view name, std::string_view text) : name_(name), text_(text) {}

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::size_t line_of(std::size_t offset) const;

  /// Throws base::InputError: `name:line:column: message`, then the line and a caret.
  [[noreturn]] void fail(std::size_t offset, std::string_view message) const;

  /// `name:line:column: warning: message`
  [[nodiscard]] std::string warning(std::size_t offset, std::string_view message) const;

 private:
  [[nodiscard]] std::string place(std::size_t offset) const;

  std::string_view name_;
  std::string_view text_;
};

}  // namespace lamina::scene
