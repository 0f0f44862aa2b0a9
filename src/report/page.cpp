#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/traits.hpp"

namespace lamina::report {
namespace {

constexpr int kDoubleBits = std::numeric_limits<double>::digits;

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

// Byte offset of the n-th character, or the end.
std::size_t offset_of(std::string_view text, std::size_t n) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (starts_character(text[i]) && n-- == 0) {
      return i;
    }
  }
  return text.size();
}

std::vector<std::string> broken(std::string_view text, std::size_t width) {
  std::vector<std::string> lines{""};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool fits = lines.back().empty() || width_of(lines.back()) + 1 + width_of(word) <= width;
    if (!fits) {
      lines.emplace_back();
    }
    while (width_of(word) > width) {
      const std::size_t cut = offset_of(word, width);
      lines.back() = word.substr(0, cut);
      lines.emplace_back();
      word.remove_prefix(cut);
    }
    lines.back() += lines.back().empty() ? "" : " ";
    lines.back() += word;
  }
  return lines;
}

std::string spaces(std::size_t count) { return std::string(count, ' '); }

void trim_right(std::string& line) { line.erase(line.find_last_not_of(' ') + 1); }

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string shortened(std::string_view text, std::size_t width) {
  constexpr std::string_view kGap = "..";
  const std::size_t length = width_of(text);
  if (length <= width) {
    return std::string(text);
  }
  const std::size_t kept = width - std::min(width, kGap.size());
  const std::size_t head = kept / 2;
  return fmt::format("{}{}{}", text.substr(0, offset_of(text, head)), kGap,
                     text.substr(offset_of(text, length - (kept - head))));
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string paragraph(std::string_view text, std::string_view first, std::size_t indent) {
  std::string result;
  for (const std::string& line : broken(text, kPageWidth - indent)) {
    result +=
        result.empty() ? std::string(first) + spaces(indent - width_of(first)) : spaces(indent);
    result += line;
    trim_right(result);
    result += '\n';
  }
  return result;
}

void Columns::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::string Columns::text(std::size_t indent) const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  constexpr std::size_t kGap = 2;
  std::string result;
  for (const auto& row : rows_) {
    std::string line = spaces(indent);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      line += row[i] + spaces(widths[i] + kGap - width_of(row[i]));
    }
    result += paragraph(row.back(), line, width_of(line));
  }
  return result;
}

std::string shortest_text(double value, int significand_bits) {
  if (significand_bits == 0 || significand_bits >= kDoubleBits || !std::isfinite(value) ||
      value == 0) {
    return fmt::format("{}", value);
  }
  for (int digits = 1; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    const number::Rational decimal = number::parse_rational(fmt::format("{:.{}g}", value, digits));
    const auto rounded = number::detail::round_to_bits(decimal, significand_bits);
    if (number::detail::scale_by_power_of_two(rounded.mantissa, rounded.exponent) ==
        number::Rational(value)) {
      return fmt::format("{}", number::nearest_double(decimal));
    }
  }
  return fmt::format("{}", value);
}

}  // namespace lamina::report
