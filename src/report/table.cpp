#include "report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/contract.hpp"
#include "census/statistics.hpp"

namespace lamina::report {
namespace {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;  // clang++ 14 wants the guide

// Three significant digits, never in exponent form, for percentages.
std::string percent(double probability) {
  const double value = 100 * probability;
  if (value == 0 || value >= 10) {
    return fmt::format("{:.1f}", value);
  }
  return value >= 0.001 ? fmt::format("{:#.3g}", value) : fmt::format("{:.1e}", value);
}

std::string for_people(const Value& value) {
  return std::visit(
      Overloaded{
          [](const std::string& text) { return text; },
          [](std::uint64_t number) { return fmt::format("{}", number); },
          [](double number) { return std::isnan(number) ? "-" : fmt::format("{:.3g}", number); },
          [](const Rate& rate) -> std::string {
            if (rate.n == 0) {
              return "-";
            }
            const auto n = static_cast<double>(rate.n);
            if (rate.count == 0) {
              return fmt::format("< {}", percent(std::min(1.0, 3 / n)));
            }
            const census::Interval interval = census::clopper_pearson(rate.count, rate.n);
            return fmt::format("{} [{}, {}]", percent(static_cast<double>(rate.count) / n),
                               percent(interval.lower), percent(interval.upper));
          }},
      value);
}

bool is_zero(const Value& value) {
  const Rate* const rate = std::get_if<Rate>(&value);
  return rate != nullptr && rate->count == 0;
}

bool is_nothing(const Value& value) {
  const double* const number = std::get_if<double>(&value);
  return number != nullptr && std::isnan(*number);
}

// The columns for people: those for programs are out, and those with nothing but zero rates
// or without values.
struct Shown {
  std::vector<std::size_t> columns;
  std::vector<std::string> all_zero;
};

Shown shown_columns(const Table& table) {
  Shown shown;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].only_for_programs) {
      continue;
    }
    const auto all = [&](bool (*is)(const Value&)) {
      return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(),
                                                [&](const auto& row) { return is(row[c]); });
    };
    if (all(is_zero)) {
      shown.all_zero.push_back(table.columns[c].heading);
    } else if (!all(is_nothing)) {
      shown.columns.push_back(c);
    }
  }
  return shown;
}

std::vector<std::string> notes_below(const Table& table, const Shown& shown) {
  std::vector<std::string> notes;
  const bool rates = std::any_of(table.rows.begin(), table.rows.end(), [](const auto& row) {
    return std::any_of(row.begin(), row.end(),
                       [](const Value& v) { return std::holds_alternative<Rate>(v); });
  });
  if (rates) {
    notes.emplace_back(
        "Rates are percentages of rays with at least one of the artifact, with 95 % "
        "Clopper-Pearson intervals; `< x` is 3/n where none was seen in n rays.");
  }
  if (!shown.all_zero.empty()) {
    notes.push_back(
        fmt::format("Zero in every row, not shown: {}.", fmt::join(shown.all_zero, ", ")));
  }
  for (const std::size_t c : shown.columns) {
    if (!table.columns[c].definition.empty()) {
      notes.push_back(fmt::format("{}: {}", table.columns[c].heading, table.columns[c].definition));
    }
  }
  notes.insert(notes.end(), table.notes.begin(), table.notes.end());
  return notes;
}

std::string markdown(const Table& table) {
  const Shown shown = shown_columns(table);
  std::vector<std::vector<std::string>> lines(1);
  for (const std::size_t c : shown.columns) {
    lines[0].push_back(table.columns[c].heading);
  }
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const std::size_t c : shown.columns) {
      lines.back().push_back(for_people(row[c]));
    }
  }
  std::vector<std::size_t> widths(shown.columns.size(), 3);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) {
      widths[c] = std::max(widths[c], line[c].size());
    }
  }
  std::string text = table.title.empty() ? "" : fmt::format("### {}\n\n", table.title);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t c = 0; c < lines[i].size(); ++c) {
      text += fmt::format("| {:<{}} ", lines[i][c], widths[c]);
    }
    text += "|\n";
    if (i == 0) {
      for (const std::size_t width : widths) {
        text += fmt::format("|{:-<{}}", "", width + 2);
      }
      text += "|\n";
    }
  }
  text += '\n';
  for (const std::string& note : notes_below(table, shown)) {
    text += fmt::format("- {}\n", note);
  }
  return text;
}

// One flat list of (name, value) pairs for a row: rates expanded.
std::vector<std::pair<std::string, nlohmann::ordered_json>> flat(const Table& table,
                                                                 const std::vector<Value>& row) {
  std::vector<std::pair<std::string, nlohmann::ordered_json>> fields;
  for (std::size_t c = 0; c < row.size(); ++c) {
    const std::string& name = table.columns[c].name;
    std::visit(
        Overloaded{[&](const Rate& rate) {
                     const census::Interval interval = census::clopper_pearson(rate.count, rate.n);
                     fields.emplace_back(name + "_count", rate.count);
                     fields.emplace_back(name + "_n", rate.n);
                     fields.emplace_back(
                         name + "_rate",
                         rate.n == 0 ? nlohmann::ordered_json(nullptr)
                                     : nlohmann::ordered_json(static_cast<double>(rate.count) /
                                                              static_cast<double>(rate.n)));
                     fields.emplace_back(name + "_lower", interval.lower);
                     fields.emplace_back(name + "_upper", interval.upper);
                   },
                   [&](const auto& value) { fields.emplace_back(name, value); }},
        row[c]);
  }
  return fields;
}

std::string csv_field(const nlohmann::ordered_json& value) {
  if (!value.is_string()) {
    const std::string text = value.dump();  // `null` too for what is no finite number
    return text == "null" ? "" : text;
  }
  const auto& text = value.get_ref<const std::string&>();
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

std::string csv(const Table& table) {
  std::string text;
  const auto line = [&text](const std::vector<std::string>& fields) {
    text += fmt::format("{}\n", fmt::join(fields, ","));
  };
  // The header comes from an empty row, so that it is there without rows too.
  for (std::size_t i = 0; i <= table.rows.size(); ++i) {
    if (i == 0 && table.rows.empty()) {
      std::vector<std::string> names;
      for (const Column& column : table.columns) {
        names.push_back(column.name);
      }
      line(names);
      break;
    }
    const auto fields = flat(table, table.rows[i == 0 ? 0 : i - 1]);
    std::vector<std::string> cells;
    for (const auto& [name, value] : fields) {
      cells.push_back(i == 0 ? name : csv_field(value));
    }
    line(cells);
  }
  return text;
}

nlohmann::ordered_json json(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (const auto& [name, value] : flat(table, row)) {
      object[name] = value;
    }
    rows.push_back(std::move(object));
  }
  nlohmann::ordered_json definitions = nlohmann::ordered_json::object();
  for (const Column& column : table.columns) {
    if (!column.definition.empty()) {
      definitions[column.name] = column.definition;
    }
  }
  return {{"name", table.name},
          {"title", table.title},
          {"definitions", std::move(definitions)},
          {"rows", std::move(rows)},
          {"notes", table.notes}};
}

std::string escaped_latex(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '%':
      case '&':
      case '#':
      case '_':
      case '$':
      case '{':
      case '}':
        escaped += '\\';
        escaped += c;
        break;
      case '<':
        escaped += "$<$";
        break;
      case '>':
        escaped += "$>$";
        break;
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "\\textasciitilde{}";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string latex(const Table& table) {
  const Shown shown = shown_columns(table);
  std::string text = fmt::format("% {}\n\\begin{{tabular}}{{{:l<{}}}}\n\\toprule\n", table.title,
                                 "", shown.columns.size());
  const auto line = [&text](const std::vector<std::string>& cells) {
    text += fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  };
  std::vector<std::string> cells;
  for (const std::size_t c : shown.columns) {
    cells.push_back(escaped_latex(table.columns[c].heading));
  }
  line(cells);
  text += "\\midrule\n";
  for (const auto& row : table.rows) {
    cells.clear();
    for (const std::size_t c : shown.columns) {
      cells.push_back(escaped_latex(for_people(row[c])));
    }
    line(cells);
  }
  text += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : notes_below(table, shown)) {
    text += fmt::format("% {}\n", note);
  }
  return text;
}

}  // namespace

Format parse_format(std::string_view text) {
  if (text == "md") {
    return Format::Markdown;
  }
  if (text == "csv") {
    return Format::Csv;
  }
  if (text == "json") {
    return Format::Json;
  }
  if (text == "latex") {
    return Format::Latex;
  }
  throw base::InputError(fmt::format("format '{}': one of md, csv, json, latex", text));
}

std::string write(const Table& table, Format format) {
  switch (format) {
    case Format::Markdown:
      return markdown(table);
    case Format::Csv:
      return csv(table);
    case Format::Json:
      return json(table).dump(1) + '\n';
    case Format::Latex:
      return latex(table);
  }
  return {};
}

std::string write(const std::vector<Table>& tables, Format format) {
  std::string text;
  if (format == Format::Json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Table& table : tables) {
      all.push_back(json(table));
    }
    return nlohmann::ordered_json{{"tables", std::move(all)}}.dump(1) + '\n';
  }
  for (const Table& table : tables) {
    text += (text.empty() ? "" : "\n") + write(table, format);
  }
  return text;
}

}  // namespace lamina::report
