// Text for a terminal: a page of fixed width, columns, numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamina::report {

/// Columns of a line, at most.
inline constexpr std::size_t kPageWidth = 100;

/// Characters of UTF-8 text, each taken to be one column wide.
std::size_t width_of(std::string_view text);

/// The text, or its begin and end with `..` between where it is wider than `width`.
std::string shortened(std::string_view text, std::size_t width);

/// `1 event`, `2 events`.
std::string counted(std::size_t count, std::string_view noun);

/// Lines that end in newlines, broken between words, each indented; `first` stands before the
/// first in place of the indent.
std::string paragraph(std::string_view text, std::string_view first, std::size_t indent);

/// Rows of cells in columns as wide as they need to be. The last column takes what is left of
/// the page and is broken into lines; the others must leave it some room.
class Columns {
 public:
  void add(std::vector<std::string> row);
  /// Every row, indented.
  [[nodiscard]] std::string text(std::size_t indent) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// The shortest decimal that, read to so many significand bits, is the value; to the bits of
/// double where there are more of them, or none.
std::string shortest_text(double value, int significand_bits);

}  // namespace lamina::report
