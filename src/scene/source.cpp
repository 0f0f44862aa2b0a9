#include "scene/source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.hpp"

namespace lamina::scene {
namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7F'; }

std::size_t begin_of_line(std::string_view text, std::size_t offset) {
  const std::size_t newline = text.substr(0, offset).rfind('\n');
  return newline == std::string_view::npos ? 0 : newline + 1;
}

std::size_t end_of_line(std::string_view text, std::size_t offset) {
  return std::min(text.find('\n', offset), text.size());
}

// Other control characters than the tab would move the caret, or end the message.
std::string printable(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return is_control(c) && c != '\t'; }, ' ');
  return result;
}

// Blanks as wide as the text: tabs stay, and the bytes of one character count once.
std::string blanks_under(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (!continues_character(c)) {
      result += c == '\t' ? '\t' : ' ';
    }
  }
  return result;
}

}  // namespace

std::size_t Source::line_of(std::size_t offset) const {
  const std::string_view before = text_.substr(0, offset);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::string Source::place(std::size_t offset) const {
  const std::size_t begin = begin_of_line(text_, offset);
  const std::string_view before = text_.substr(begin, offset - begin);
  const auto characters = static_cast<std::size_t>(
      std::count_if(before.begin(), before.end(), [](char c) { return !continues_character(c); }));
  return fmt::format("{}:{}:{}", name_, line_of(offset), characters + 1);
}

void Source::fail(std::size_t offset, std::string_view message) const {
  constexpr std::size_t kShownBefore = 120;
  constexpr std::size_t kShownAfter = 80;
  offset = std::min(offset, text_.size());
  std::size_t begin = begin_of_line(text_, offset);
  begin = std::max(begin, offset - std::min(offset, kShownBefore));
  const std::size_t end = std::min(end_of_line(text_, offset), offset + kShownAfter);
  const std::string before = printable(text_.substr(begin, offset - begin));
  const std::string after = printable(text_.substr(offset, end - offset));
  throw base::InputError(fmt::format("{}: {}\n{}{}\n{}^", place(offset), message, before, after,
                                     blanks_under(before)));
}

std::string Source::warning(std::size_t offset, std::string_view message) const {
  return fmt::format("{}: warning: {}", place(offset), message);
}

}  // namespace lamina::scene
