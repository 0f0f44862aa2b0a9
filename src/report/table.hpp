// Tables: built once, written as Markdown, CSV, JSON or LaTeX.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lamina::report {

/// `count` events in `n` trials; written with its 95 % Clopper-Pearson interval.
struct Rate {
  std::uint64_t count = 0;
  std::uint64_t n = 0;
};

/// A NaN stands for no value.
using Value = std::variant<std::string, std::uint64_t, double, Rate>;

struct Column {
  std::string name;                ///< snake_case, for CSV and JSON
  std::string heading;             ///< for people
  std::string definition;          ///< one sentence; empty where the heading says it all
  bool only_for_programs = false;  ///< in CSV and JSON, not in Markdown and LaTeX
};

struct Table {
  std::string name;  ///< one word, to choose it by
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Value>> rows;
  std::vector<std::string> notes;  ///< below the table
  bool on_request = false;         ///< printed only if it is asked for
};

enum class Format : std::uint8_t { Markdown, Csv, Json, Latex };

/// `md`, `csv`, `json` or `latex`. Throws base::InputError otherwise.
Format parse_format(std::string_view text);

/// Markdown and LaTeX leave out columns of rates that are zero in every row and name them
/// below, and columns without any value; rates are percentages: `12.3 [11.9, 12.8]`, or `< 0.015`
/// (3/n) where nothing was counted. CSV and JSON have every column; a rate becomes _count, _n,
/// _rate, _lower, _upper.
std::string write(const Table& table, Format format);

/// All tables one after the other; JSON as `{"tables": [...]}`.
std::string write(const std::vector<Table>& tables, Format format);

}  // namespace lamina::report
