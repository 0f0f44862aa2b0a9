#include "census/run_store.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/contract.hpp"
#include "support/equal_census.hpp"
#include "support/scratch.hpp"

namespace lamina::census {
namespace {

const Record kSettings{{"experiment", "e"}, {"seed", "7"}};

// Counts that are told from one another by `salt`.
Census sample(std::uint64_t salt) {
  Census census;
  census.rays = 100 + salt;
  census.in_carrier = salt;
  census.with_coincidence = 2 * salt;
  for (const char* number : {"float", "exact"}) {
    Cell cell;
    cell.method = "roth";
    cell.number = number;
    cell.significand_bits = 24;
    cell.rays = 100;
    for (std::size_t a = 0; a < kArtifactCount; ++a) {
      cell.with[a] = salt + a;
    }
    for (std::size_t c = 0; c < kCauseCount; ++c) {
      cell.caused[c] = salt + 100 + c;
    }
    cell.order_sensitive = salt + 3;
    cell.most_outcomes = 4;
    cell.wrong_length = 0.1 * static_cast<double>(salt);
    cell.persistence = 5;
    cell.lamina_fronts = 60;
    cell.lamina_fronts_seen = 50;
    cell.lamina_backs = 40;
    cell.lamina_backs_seen = 30;
    cell.largest = {1.0 / 3, 2.5e-300, std::numeric_limits<double>::infinity()};
    if (salt % 2 == 1) {
      using number::Rational;
      cell.worst = WorstCase{"a 'scene', \"quoted\"",
                             {{Rational(1, 3), Rational(-2), Rational(5, 8)},
                              {Rational(0), Rational(1, 7), Rational(1)}},
                             static_cast<std::uint32_t>(salt),
                             0.7};
    }
    census.cells.push_back(cell);
  }
  census.pairs = {{"float", "roth", "regularized", 3 + salt, 4},
                  {"exact", "roth", "regularized", 1, 0}};
  return census;
}

class RunStoreTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string file() const { return folder() + "/run.sqlite"; }
  [[nodiscard]] std::string folder() const { return scratch_.path("run"); }

  // What opening the run says.
  [[nodiscard]] std::string error() const {
    try {
      const RunStore store = RunStore::open(folder());
      static_cast<void>(store.census(0));
      return "";
    } catch (const base::InputError& failure) {
      return failure.what();
    }
  }

 private:
  test::Scratch scratch_;
};

TEST_F(RunStoreTest, ReadsBackWhatWasWritten) {
  const std::vector<SeriesRecord> series{{{std::string("uniform"), std::uint64_t{3}, 2.0}, 2},
                                         {{std::string("other"), std::uint64_t{0}, 0.1}, 1}};
  {
    RunStore store = RunStore::begin(folder(), kSettings);
    store.add_environment({{"version", "1"}, {"commit", "x"}});
    store.set_series(series);
    // The later block first: they are added up in order.
    store.add_block(0, 1, sample(2), 1.5);
    store.add_block(0, 0, sample(1), 0.25);
    EXPECT_TRUE(store.has_block(0, 1));
    EXPECT_FALSE(store.has_block(1, 0));
    EXPECT_FALSE(store.census(1).has_value());
  }
  RunStore store = RunStore::open(folder());
  store.add_environment({{"version", "1"}, {"commit", "y"}});
  EXPECT_EQ(store.settings(), kSettings);
  EXPECT_EQ(store.environments(), (std::vector<Record>{{{"version", "1"}, {"commit", "x"}},
                                                       {{"version", "1"}, {"commit", "y"}}}));
  EXPECT_EQ(store.series(), series);
  EXPECT_NO_THROW(store.set_series(series));
  EXPECT_EQ(store.block_count(), 2U);
  EXPECT_EQ(store.seconds(0), 1.75);
  EXPECT_EQ(store.seconds(1), 0);
  Census sum = sample(1);
  sum.merge(sample(2));
  ASSERT_TRUE(store.census(0).has_value());
  support::expect_equal(*store.census(0), sum);
}

TEST_F(RunStoreTest, InMemoryIsTheSame) {
  RunStore store = RunStore::in_memory(kSettings);
  store.set_series({{{std::string("a")}, 1}});
  store.add_block(0, 0, sample(3), 1);
  EXPECT_EQ(store.settings(), kSettings);
  support::expect_equal(*store.census(0), sample(3));
}

TEST_F(RunStoreTest, OtherSeriesAreNotGoneOnWith) {
  RunStore store = RunStore::begin(folder(), kSettings);
  store.set_series({{{std::string("a")}, 2}});
  EXPECT_THROW(store.set_series({{{std::string("a")}, 3}}), base::InputError);
  EXPECT_THROW(store.set_series({{{std::string("b")}, 2}}), base::InputError);
}

TEST_F(RunStoreTest, ABlockIsCountedOnce) {
  RunStore store = RunStore::begin(folder(), kSettings);
  store.add_block(0, 0, sample(1), 1);
  EXPECT_THROW(store.add_block(0, 0, sample(1), 1), base::InputError);
  support::expect_equal(*store.census(0), sample(1));
}

// A block that fails half-way leaves nothing of itself.
TEST_F(RunStoreTest, ABlockIsWholeOrNotThere) {
  RunStore store = RunStore::begin(folder(), kSettings);
  store.add_block(0, 0, sample(1), 1);
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(file().c_str(), &other), SQLITE_OK);
  // Someone's pair in the way of the second block's, which is written last but one.
  ASSERT_EQ(sqlite3_exec(other, "INSERT INTO pair VALUES (0, 1, 1, '', '', '', 0, 0)", nullptr,
                         nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(other);
  EXPECT_THROW(store.add_block(0, 1, sample(2), 1), base::InputError);
  EXPECT_FALSE(store.has_block(0, 1));
  support::expect_equal(*store.census(0), sample(1));
}

TEST_F(RunStoreTest, AFolderThatCannotBeMadeIsAnInputError) {
  const test::Scratch scratch;
  EXPECT_THROW(RunStore::begin(scratch.write("file", "x") + "/below", kSettings), base::InputError);
}

TEST_F(RunStoreTest, NothingThereSaysHowToMakeIt) {
  EXPECT_FALSE(RunStore::exists(folder()));
  EXPECT_NE(error().find("lamina run"), std::string::npos) << error();
}

TEST_F(RunStoreTest, WhatIsNoRunIsAnInputErrorThatNamesTheFile) {
  std::filesystem::create_directories(folder());
  for (const std::string& text :
       {std::string(), std::string("no database"), std::string(5000, 'x')}) {
    std::ofstream(file(), std::ios::binary) << text;
    EXPECT_NE(error().find("run.sqlite' is damaged"), std::string::npos) << error();
  }
}

TEST_F(RunStoreTest, ATruncatedFileIsToldFromASoundOne) {
  {
    RunStore store = RunStore::begin(folder(), kSettings);
    store.set_series({{{std::string("a")}, 40}});
    for (std::size_t block = 0; block < 40; ++block) {
      store.add_block(0, block, sample(block), 1);
    }
  }
  ASSERT_EQ(error(), "");
  const auto whole = std::filesystem::file_size(file());
  ASSERT_GT(whole, 20'000U);
  for (const auto size :
       {whole - 1, whole - 4096, whole / 2, std::uintmax_t{4096}, std::uintmax_t{100}}) {
    std::filesystem::resize_file(file(), size);
    EXPECT_NE(error().find("is damaged"), std::string::npos) << size << ": " << error();
  }
}

TEST_F(RunStoreTest, AnotherLayoutNamesTheVersions) {
  static_cast<void>(RunStore::begin(folder(), kSettings));
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(file().c_str(), &handle), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(handle, "PRAGMA user_version = 99", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(handle);
  EXPECT_NE(error().find("layout 99"), std::string::npos) << error();
}

}  // namespace
}  // namespace lamina::census
