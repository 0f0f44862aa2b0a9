#include "census/sqlite.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/contract.hpp"

namespace lamina::census::sqlite {

Database::Database(std::string file, int flags) : name_(std::move(file)) {
  const int code = sqlite3_open_v2(name_.c_str(), &handle_, flags, nullptr);
  if (code != SQLITE_OK) {
    const std::string why = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    sqlite3_close(handle_);
    throw base::InputError(
        fmt::format("'{}' cannot be opened ({}): may its folder be written?", name_, why));
  }
  // A column that is not there is an error, not a text of its name.
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
  constexpr int kPatienceMilliseconds = 5000;
  sqlite3_busy_timeout(handle_, kPatienceMilliseconds);
}

Database::~Database() { sqlite3_close(handle_); }

void Database::execute(const std::string& sql) const {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail();
  }
}

void Database::fail() const {
  const std::string why = sqlite3_errmsg(handle_);
  switch (sqlite3_errcode(handle_) & 0xFF) {  // without SQLite's finer distinctions
    case SQLITE_FULL:
    case SQLITE_IOERR:
      throw base::InputError(fmt::format(
          "'{}' cannot be written ({}): what was finished is kept; make room and go on with "
          "--resume",
          name_, why));
    case SQLITE_READONLY:
      throw base::InputError(
          fmt::format("'{}' may not be written ({}): copy the folder elsewhere", name_, why));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_CONSTRAINT:
      throw base::InputError(fmt::format(
          "'{}' is in use by another run ({}): wait for it, or name another folder", name_, why));
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:
      damaged(why);
    default:
      throw base::InputError(fmt::format("'{}': {}", name_, why));
  }
}

void Database::damaged(const std::string& why) const {
  throw base::InputError(
      fmt::format("'{0}' is damaged, or no run of Lamina ({1}): move it away and run again; what "
                  "can be read of it, `sqlite3 '{0}' .recover` writes out",
                  name_, why));
}

Statement::Statement(const Database& database, const std::string& sql) : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &handle_, nullptr) != SQLITE_OK) {
    database.fail();
  }
}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement& Statement::bind(double value) {
  return checked(sqlite3_bind_double(handle_, ++bound_, value));
}

Statement& Statement::bind(std::string_view value) {
  return checked(sqlite3_bind_text(handle_, ++bound_, value.data(), static_cast<int>(value.size()),
                                   SQLITE_TRANSIENT));
}

Statement& Statement::bind_integer(std::int64_t value) {
  return checked(sqlite3_bind_int64(handle_, ++bound_, value));
}

bool Statement::step() {
  read_ = 0;
  const int code = sqlite3_step(handle_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    database_.fail();
  }
  return code == SQLITE_ROW;
}

Statement& Statement::rewind() {
  sqlite3_reset(handle_);
  bound_ = 0;
  return *this;
}

void Statement::run() {
  step();
  rewind();
}

int Statement::type() const { return sqlite3_column_type(handle_, read_); }

std::string Statement::text() {
  const auto* chars = reinterpret_cast<const char*>(sqlite3_column_text(handle_, read_));
  const int bytes = sqlite3_column_bytes(handle_, read_++);
  return chars == nullptr ? std::string() : std::string(chars, static_cast<std::size_t>(bytes));
}

double Statement::real() {
  const bool none = type() == SQLITE_NULL;  // what SQLite makes of NaN
  const double value = sqlite3_column_double(handle_, read_++);
  return none ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::uint64_t Statement::integer() {
  return static_cast<std::uint64_t>(sqlite3_column_int64(handle_, read_++));
}

Statement& Statement::checked(int code) {
  if (code != SQLITE_OK) {
    database_.fail();
  }
  return *this;
}

Transaction::Transaction(const Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!committed_) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  committed_ = true;
}

}  // namespace lamina::census::sqlite
