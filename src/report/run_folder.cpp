#include "report/run_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/contract.hpp"

namespace lamina::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTables = "tables.json";
constexpr const char* kEnvironment = "environment.json";

Json to_json(const Record& record) {
  Json object = Json::object();
  for (const auto& [name, value] : record) {
    object[name] = value;
  }
  return object;
}

Json to_json(const Value& value) {
  if (const Rate* rate = std::get_if<Rate>(&value)) {
    return {{"count", rate->count}, {"n", rate->n}};
  }
  if (const double* number = std::get_if<double>(&value)) {
    return {{"real", *number}};  // apart from integers, which JSON does not keep apart
  }
  if (const auto* number = std::get_if<std::uint64_t>(&value)) {
    return *number;
  }
  return std::get<std::string>(value);
}

Value value_from(const Json& json) {
  if (json.is_string()) {
    return json.get<std::string>();
  }
  if (json.is_number_unsigned()) {
    return json.get<std::uint64_t>();
  }
  if (json.contains("real")) {
    const Json& real = json.at("real");  // JSON has no infinities: they are written as null
    return real.is_null() ? std::numeric_limits<double>::quiet_NaN() : real.get<double>();
  }
  return Rate{json.at("count").get<std::uint64_t>(), json.at("n").get<std::uint64_t>()};
}

Json to_json(const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name},
                       {"heading", column.heading},
                       {"definition", column.definition},
                       {"only_for_programs", column.only_for_programs}});
  }
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const Value& value : row) {
      cells.push_back(to_json(value));
    }
    rows.push_back(std::move(cells));
  }
  return {{"title", table.title},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)},
          {"notes", table.notes}};
}

Table table_from(const Json& json) {
  Table table;
  json.at("title").get_to(table.title);
  json.at("notes").get_to(table.notes);
  for (const Json& column : json.at("columns")) {
    table.columns.push_back({column.at("name"), column.at("heading"), column.at("definition"),
                             column.at("only_for_programs")});
  }
  for (const Json& row : json.at("rows")) {
    table.rows.emplace_back();
    for (const Json& value : row) {
      table.rows.back().push_back(value_from(value));
    }
    if (table.rows.back().size() != table.columns.size()) {
      throw base::InputError("a row of '" + table.title + "' does not fit its columns");
    }
  }
  return table;
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::path part = file;
  part += ".part";
  {
    std::ofstream out(part, std::ios::binary);
    out << text << std::flush;
    if (!out) {
      throw base::InputError(fmt::format("'{}' cannot be written", part.string()));
    }
  }
  std::filesystem::rename(part, file);
}

}  // namespace

Found find_run(const std::filesystem::path& folder, const Record& settings) {
  if (!std::filesystem::exists(folder / kTables)) {
    return Found::Nothing;
  }
  std::ifstream in(folder / kEnvironment, std::ios::binary);
  const Json found = Json::parse(in, nullptr, false);
  const bool same =
      found.is_object() && found.contains("settings") && found.at("settings") == to_json(settings);
  return same ? Found::ThisRun : Found::AnotherRun;
}

void write_run(const std::filesystem::path& folder, const std::vector<Table>& tables,
               const Record& environment, const Record& settings) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw base::InputError(
        fmt::format("folder '{}' cannot be made: {}", folder.string(), error.message()));
  }
  Json all = Json::array();
  for (const Table& table : tables) {
    all.push_back(to_json(table));
  }
  write_whole(folder / kTables, Json{{"schema", 1}, {"tables", std::move(all)}}.dump(1) + '\n');
  Json record = to_json(environment);
  record["settings"] = to_json(settings);
  write_whole(folder / kEnvironment, record.dump(1) + '\n');
}

std::vector<Table> read_run(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kTables;
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw base::InputError(fmt::format(
        "no run in '{}': '{}' cannot be read; `lamina run EXPERIMENT --out {}` makes it",
        folder.string(), file.string(), folder.string()));
  }
  try {
    std::vector<Table> tables;
    const Json document = Json::parse(in);
    for (const Json& table : document.at("tables")) {
      tables.push_back(table_from(table));
    }
    return tables;
  } catch (const Json::exception& error) {
    throw base::InputError(
        fmt::format("'{}' is not a run's tables: {}", file.string(), error.what()));
  }
}

std::string write(const std::vector<Table>& tables, Format format) {
  std::string text;
  if (format == Format::Json) {
    Json all = Json::array();
    for (const Table& table : tables) {
      all.push_back(Json::parse(write(table, format)));
    }
    return Json{{"tables", std::move(all)}}.dump(1) + '\n';
  }
  for (const Table& table : tables) {
    text += (text.empty() ? "" : "\n") + write(table, format);
  }
  return text;
}

}  // namespace lamina::report
