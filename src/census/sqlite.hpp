// SQLite as the run store uses it: statements, transactions, and failures that say what to do.
#pragma once

#include <sqlite3.h>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace lamina::census::sqlite {

/// An open file. Every failure, here and below, is a base::InputError that names the file and
/// what to do about it.
class Database {
 public:
  /// `flags` are those of sqlite3_open_v2.
  Database(std::string file, int flags);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  void execute(const std::string& sql) const;

  /// Throws what the last error means.
  [[noreturn]] void fail() const;
  /// Throws that the file is no sound run.
  [[noreturn]] void damaged(const std::string& why) const;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* handle() const { return handle_; }

 private:
  std::string name_;
  sqlite3* handle_ = nullptr;
};

/// One SQL statement: bound from left to right, read from left to right.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  Statement& bind(double value);
  Statement& bind(std::string_view value);
  template <std::integral Integer>
  Statement& bind(Integer value) {
    return bind_integer(static_cast<std::int64_t>(value));
  }

  /// Goes to the next row; false if there is none.
  bool step();
  /// Makes it ready to be bound and run again.
  Statement& rewind();
  /// Runs a statement without rows, and rewinds it.
  void run();

  /// SQLite's type of the column that is read next.
  [[nodiscard]] int type() const;
  std::string text();
  double real();
  std::uint64_t integer();
  void read(double& value) { value = real(); }
  template <std::integral Integer>
  void read(Integer& value) {
    value = static_cast<Integer>(integer());
  }

 private:
  Statement& bind_integer(std::int64_t value);
  Statement& checked(int code);

  const Database& database_;
  sqlite3_stmt* handle_ = nullptr;
  int bound_ = 0;
  int read_ = 0;
};

/// What commit() does not end is undone.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  const Database& database_;
  bool committed_ = false;
};

}  // namespace lamina::census::sqlite
