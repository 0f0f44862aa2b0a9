#include "census/run_store.hpp"

#include <fmt/format.h>
#include "base/contract.hpp"
#include "census/sqlite.hpp"
#include "geometry/ray_text.hpp"

namespace lamina::census {

using sqlite::Database;
using sqlite::Statement;
using sqlite::Transaction;

namespace {

constexpr const char* kFile = "run.sqlite";
constexpr int kApplication = 0x4C414D49;  // "LAMI"
constexpr int kSchema = 3;

// Every number of a cell and what it is called: the one list that the schema, writing and
// reading follow. CellType is Cell or const Cell.
template <typename CellType, typename Visit>
void each_number(CellType& cell, Visit visit) {
  visit("bits", cell.significand_bits);
  visit("rays", cell.rays);
  visit("not_spawned", cell.not_spawned);
  visit("undecided", cell.undecided);
  for (std::size_t a = 0; a < kArtifactCount; ++a) {
    visit(artifact_texts()[a].name, cell.with[a]);
  }
  for (std::size_t c = 0; c < kCauseCount; ++c) {
    visit(cause_texts()[c].name, cell.caused[c]);
  }
  visit("order_sensitive", cell.order_sensitive);
  visit("most_outcomes", cell.most_outcomes);
  visit("wrong_length", cell.wrong_length);
  visit("persistence", cell.persistence);
  visit("lamina_fronts", cell.lamina_fronts);
  visit("lamina_fronts_seen", cell.lamina_fronts_seen);
  visit("lamina_backs", cell.lamina_backs);
  visit("lamina_backs_seen", cell.lamina_backs_seen);
  visit("t_ulps", cell.largest.t_ulps);
  visit("point_rel", cell.largest.point_rel);
  visit("normal_rad", cell.largest.normal_rad);
}

// The columns of each_number, each with `format` applied to its name.
std::string number_columns(std::string_view format) {
  std::string text;
  const Cell cell;
  each_number(cell, [&](std::string_view name, const auto&) {
    text += fmt::format(fmt::runtime(format), name);
  });
  return text;
}

std::string schema() {
  return fmt::format(
      "CREATE TABLE setting (name TEXT PRIMARY KEY, value TEXT NOT NULL);"
      "CREATE TABLE environment (session INTEGER, name TEXT, value TEXT NOT NULL,"
      " PRIMARY KEY (session, name));"
      "CREATE TABLE series (series INTEGER PRIMARY KEY, blocks INTEGER NOT NULL);"
      "CREATE TABLE label (series INTEGER, position INTEGER, label,"
      " PRIMARY KEY (series, position));"
      "CREATE TABLE block (series INTEGER, block INTEGER, rays INTEGER NOT NULL,"
      " in_carrier INTEGER NOT NULL, with_coincidence INTEGER NOT NULL,"
      " PRIMARY KEY (series, block));"
      "CREATE TABLE cell (series INTEGER, block INTEGER, position INTEGER,"
      " method TEXT NOT NULL, number TEXT NOT NULL{},"
      " worst_scene TEXT, worst_ray TEXT, worst_artifacts INTEGER, worst_length REAL,"
      " PRIMARY KEY (series, block, position));"
      "CREATE TABLE pair (series INTEGER, block INTEGER, position INTEGER,"
      " number TEXT NOT NULL, first TEXT NOT NULL, second TEXT NOT NULL,"
      " only_first_wrong INTEGER NOT NULL, only_second_wrong INTEGER NOT NULL,"
      " PRIMARY KEY (series, block, position));"
      "CREATE TABLE record (series INTEGER, block INTEGER, record TEXT NOT NULL,"
      " PRIMARY KEY (series, block));"
      "CREATE TABLE clock (series INTEGER, block INTEGER, seconds REAL NOT NULL,"
      " PRIMARY KEY (series, block));"
      "PRAGMA application_id = {};"
      "PRAGMA user_version = {};",
      number_columns(", \"{}\" NUMERIC"), kApplication, kSchema);
}

std::filesystem::path file_in(const std::filesystem::path& folder) { return folder / kFile; }

void make_schema(const Database& database, const Record& settings) {
  Transaction transaction(database);
  database.execute(schema());
  Statement insert(database, "INSERT INTO setting VALUES (?, ?)");
  for (const auto& [name, value] : settings) {
    insert.bind(name).bind(value).run();
  }
  transaction.commit();
}

void check_sound(const Database& database) {
  const auto number_of = [&database](const char* sql) {
    Statement statement(database, sql);
    statement.step();
    return statement.integer();
  };
  if (number_of("PRAGMA application_id") != kApplication) {
    database.damaged("it is not marked as one");
  }
  if (const auto found = number_of("PRAGMA user_version"); found != kSchema) {
    throw base::InputError(
        fmt::format("'{}' was made by another version of Lamina (layout {}, here {}): use that "
                    "version, or run again in another folder",
                    database.name(), found, kSchema));
  }
  // SQLite overlooks a last page that is cut off.
  const std::uint64_t bytes = number_of("PRAGMA page_count") * number_of("PRAGMA page_size");
  std::error_code error;
  const std::uintmax_t there = std::filesystem::file_size(database.name(), error);
  if (error || there < bytes) {
    database.damaged("it is cut off");
  }
  Statement check(database, "PRAGMA quick_check(1)");
  check.step();
  if (const std::string result = check.text(); result != "ok") {
    database.damaged(result);
  }
}

}  // namespace

RunStore::RunStore(std::unique_ptr<Database> database) : database_(std::move(database)) {}
RunStore::RunStore(RunStore&&) noexcept = default;
RunStore::~RunStore() = default;

RunStore RunStore::in_memory(const Record& settings) {
  auto database =
      std::make_unique<Database>(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  make_schema(*database, settings);
  return RunStore(std::move(database));
}

bool RunStore::exists(const std::filesystem::path& folder) {
  return std::filesystem::exists(file_in(folder));
}

RunStore RunStore::begin(const std::filesystem::path& folder, const Record& settings) {
  LAMINA_REQUIRE(!exists(folder), "a run is begun once");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw base::InputError(
        fmt::format("folder '{}' cannot be made: {}", folder.string(), error.message()));
  }
  // Under another name until it has its settings: a run.sqlite is always a run.
  std::filesystem::path draft = file_in(folder);
  draft += ".new";
  std::filesystem::remove(draft, error);
  make_schema(Database(draft.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE), settings);
  std::filesystem::rename(draft, file_in(folder), error);
  if (error) {
    throw base::InputError(
        fmt::format("'{}' cannot be made: {}", file_in(folder).string(), error.message()));
  }
  return open(folder);
}

RunStore RunStore::open(const std::filesystem::path& folder) {
  const std::string file = file_in(folder).string();
  if (!exists(folder)) {
    throw base::InputError(fmt::format(
        "no run in '{0}': there is no '{1}'; `lamina run EXPERIMENT --out {0}` makes it",
        folder.string(), file));
  }
  auto database = std::make_unique<Database>(file, SQLITE_OPEN_READWRITE);
  check_sound(*database);
  return RunStore(std::move(database));
}

Record RunStore::settings() const {
  Record settings;
  Statement select(*database_, "SELECT name, value FROM setting ORDER BY rowid");
  while (select.step()) {
    std::string name = select.text();
    settings.emplace_back(std::move(name), select.text());
  }
  return settings;
}

void RunStore::add_environment(const Record& environment) {
  Transaction transaction(*database_);
  Statement insert(*database_, "INSERT INTO environment VALUES (?, ?, ?)");
  Statement last(*database_, "SELECT coalesce(max(session) + 1, 0) FROM environment");
  last.step();
  const std::uint64_t session = last.integer();
  for (const auto& [name, value] : environment) {
    insert.bind(session).bind(name).bind(value).run();
  }
  transaction.commit();
}

std::vector<Record> RunStore::environments() const {
  std::vector<Record> sessions;
  Statement select(*database_,
                   "SELECT session, name, value FROM environment ORDER BY session, rowid");
  while (select.step()) {
    sessions.resize(std::max<std::size_t>(sessions.size(), select.integer() + 1));
    std::string name = select.text();
    sessions.back().emplace_back(std::move(name), select.text());
  }
  return sessions;
}

void RunStore::set_series(const std::vector<SeriesRecord>& wanted) {
  const auto known = series();
  if (!known.empty()) {
    if (known != wanted) {
      throw base::InputError(fmt::format(
          "'{}' was begun with other series of rays than this version of Lamina, or these "
          "files, would run: use another folder",
          database_->name()));
    }
    return;
  }
  Transaction transaction(*database_);
  Statement insert(*database_, "INSERT INTO series VALUES (?, ?)");
  Statement insert_label(*database_, "INSERT INTO label VALUES (?, ?, ?)");
  for (std::size_t s = 0; s < wanted.size(); ++s) {
    insert.bind(s).bind(wanted[s].blocks).run();
    for (std::size_t i = 0; i < wanted[s].labels.size(); ++i) {
      insert_label.bind(s).bind(i);
      std::visit([&](const auto& label) { insert_label.bind(label); }, wanted[s].labels[i]);
      insert_label.run();
    }
  }
  transaction.commit();
}

std::vector<SeriesRecord> RunStore::series() const {
  std::vector<SeriesRecord> all;
  Statement select(*database_, "SELECT blocks FROM series ORDER BY series");
  Statement labels(*database_, "SELECT label FROM label WHERE series = ? ORDER BY position");
  while (select.step()) {
    SeriesRecord record;
    select.read(record.blocks);
    for (labels.rewind().bind(all.size()); labels.step();) {
      switch (labels.type()) {
        case SQLITE_INTEGER:
          record.labels.emplace_back(labels.integer());
          break;
        case SQLITE_FLOAT:
          record.labels.emplace_back(labels.real());
          break;
        default:
          record.labels.emplace_back(labels.text());
      }
    }
    all.push_back(std::move(record));
  }
  return all;
}

std::uint64_t RunStore::block_count() const {
  Statement count(*database_, "SELECT count(*) FROM block");
  count.step();
  return count.integer();
}

bool RunStore::has_block(std::size_t series, std::size_t block) const {
  Statement select(*database_, "SELECT 1 FROM block WHERE series = ? AND block = ?");
  select.bind(series).bind(block);
  return select.step();
}

namespace {

void insert_block(const Database& database, std::size_t series, std::size_t block,
                  const Census& counts, double seconds) {
  Statement(database, "INSERT INTO block VALUES (?, ?, ?, ?, ?)")
      .bind(series)
      .bind(block)
      .bind(counts.rays)
      .bind(counts.in_carrier)
      .bind(counts.with_coincidence)
      .run();
  Statement(database, "INSERT INTO clock VALUES (?, ?, ?)")
      .bind(series)
      .bind(block)
      .bind(seconds)
      .run();
}

}  // namespace

void RunStore::add_record(std::size_t series, std::size_t block, std::uint64_t rays,
                          const std::string& record, double seconds) {
  Transaction transaction(*database_);
  Census counts;
  counts.rays = rays;
  insert_block(*database_, series, block, counts, seconds);
  Statement(*database_, "INSERT INTO record VALUES (?, ?, ?)")
      .bind(series)
      .bind(block)
      .bind(record)
      .run();
  transaction.commit();
}

void RunStore::add_block(std::size_t series, std::size_t block, const Census& census,
                         double seconds) {
  Transaction transaction(*database_);
  insert_block(*database_, series, block, census, seconds);
  Statement insert_cell(
      *database_,
      fmt::format("INSERT INTO cell VALUES (?, ?, ?, ?, ?{}, ?, ?, ?, ?)", number_columns(", ?")));
  for (std::size_t i = 0; i < census.cells.size(); ++i) {
    const Cell& cell = census.cells[i];
    insert_cell.bind(series).bind(block).bind(i).bind(cell.method).bind(cell.number);
    each_number(cell, [&](std::string_view, const auto& value) { insert_cell.bind(value); });
    const WorstCase worst = cell.worst.value_or(WorstCase{});
    insert_cell.bind(worst.scene)
        .bind(cell.worst ? geometry::to_text(worst.ray) : std::string())
        .bind(worst.artifacts)
        .bind(worst.wrong_length)
        .run();
  }
  Statement insert_pair(*database_, "INSERT INTO pair VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < census.pairs.size(); ++i) {
    const Pair& pair = census.pairs[i];
    insert_pair.bind(series).bind(block).bind(i).bind(pair.number).bind(pair.first);
    insert_pair.bind(pair.second).bind(pair.only_first_wrong).bind(pair.only_second_wrong).run();
  }
  transaction.commit();
}

std::optional<Census> RunStore::census(std::size_t series) const {
  std::optional<Census> sum;
  Statement blocks(*database_,
                   "SELECT block, rays, in_carrier, with_coincidence FROM block WHERE series = ? "
                   "ORDER BY block");
  Statement cells(*database_,
                  fmt::format("SELECT method, number{}, worst_scene, worst_ray, worst_artifacts, "
                              "worst_length FROM cell WHERE series = ? AND block = ? "
                              "ORDER BY position",
                              number_columns(", \"{}\"")));
  Statement pairs(*database_,
                  "SELECT number, first, second, only_first_wrong, only_second_wrong FROM pair "
                  "WHERE series = ? AND block = ? ORDER BY position");
  blocks.bind(series);
  while (blocks.step()) {
    const std::uint64_t block = blocks.integer();
    Census part;
    blocks.read(part.rays);
    blocks.read(part.in_carrier);
    blocks.read(part.with_coincidence);
    for (cells.rewind().bind(series).bind(block); cells.step();) {
      Cell cell;
      cell.method = cells.text();
      cell.number = cells.text();
      each_number(cell, [&](std::string_view, auto& value) { cells.read(value); });
      WorstCase worst;
      worst.scene = cells.text();
      const std::string ray = cells.text();
      cells.read(worst.artifacts);
      cells.read(worst.wrong_length);
      if (!ray.empty()) {
        worst.ray = geometry::parse_ray(ray);
        cell.worst = std::move(worst);
      }
      part.cells.push_back(std::move(cell));
    }
    for (pairs.rewind().bind(series).bind(block); pairs.step();) {
      Pair pair{pairs.text(), {}, {}};
      pair.first = pairs.text();
      pair.second = pairs.text();
      pairs.read(pair.only_first_wrong);
      pairs.read(pair.only_second_wrong);
      part.pairs.push_back(std::move(pair));
    }
    if (sum) {
      sum->merge(part);
    } else {
      sum = std::move(part);
    }
  }
  return sum;
}

std::vector<std::string> RunStore::records(std::size_t series) const {
  std::vector<std::string> records;
  Statement select(*database_, "SELECT record FROM record WHERE series = ? ORDER BY block");
  select.bind(series);
  while (select.step()) {
    records.push_back(select.text());
  }
  return records;
}

std::uint64_t RunStore::ray_count(std::size_t series) const {
  Statement sum(*database_, "SELECT coalesce(sum(rays), 0) FROM block WHERE series = ?");
  sum.bind(series).step();
  return sum.integer();
}

double RunStore::seconds(std::size_t series) const {
  Statement sum(*database_, "SELECT total(seconds) FROM clock WHERE series = ?");
  sum.bind(series).step();
  return sum.real();
}

}  // namespace lamina::census
