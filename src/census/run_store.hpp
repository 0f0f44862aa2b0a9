// The run store: what a run has counted so far, kept in one SQLite file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "census/census.hpp"

namespace lamina::census {

namespace sqlite {
class Database;
}

/// Names and values: settings, the environment.
using Record = std::vector<std::pair<std::string, std::string>>;

/// A part of a run: rays of one kind through scenes of one kind, in so many blocks.
struct SeriesRecord {
  std::vector<Label> labels;
  std::uint64_t blocks = 0;

  friend bool operator==(const SeriesRecord&, const SeriesRecord&) = default;
};

/// A run is series of blocks; a block is the census of up to kTasksPerBlock tasks. Each block
/// is one transaction, so that a run that ends in any way loses the block in hand and nothing
/// else. Clock times are apart from counts: the counts of two runs with one seed are equal.
/// Every failure is a base::InputError that says what is wrong with the file and what to do.
class RunStore {
 public:
  /// A run that is kept in memory only.
  static RunStore in_memory(const Record& settings);
  /// Begins a run in `folder`, which is made if need be. The folder must not have one.
  static RunStore begin(const std::filesystem::path& folder, const Record& settings);
  /// Opens the run in `folder`, whole: a damaged file is told from a sound one.
  static RunStore open(const std::filesystem::path& folder);
  /// Is there a run?
  static bool exists(const std::filesystem::path& folder);

  RunStore(RunStore&&) noexcept;
  ~RunStore();

  [[nodiscard]] Record settings() const;

  /// Adds what the run is made with; a run that is resumed has several.
  void add_environment(const Record& environment);
  [[nodiscard]] std::vector<Record> environments() const;

  /// Sets the series of the run, each with a label or more. Those of a run that was begun
  /// earlier must be the same.
  void set_series(const std::vector<SeriesRecord>& series);
  [[nodiscard]] std::vector<SeriesRecord> series() const;

  [[nodiscard]] bool has_block(std::size_t series, std::size_t block) const;
  void add_block(std::size_t series, std::size_t block, const Census& census, double seconds);
  /// Adds a block that is told in the experiment's own words.
  void add_record(std::size_t series, std::size_t block, std::uint64_t rays,
                  const std::string& record, double seconds);
  /// Blocks that the run has.
  [[nodiscard]] std::uint64_t block_count() const;

  /// The sum of the series' blocks, in their order; nothing if there is none.
  [[nodiscard]] std::optional<Census> census(std::size_t series) const;
  /// The records of the series' blocks, in their order.
  [[nodiscard]] std::vector<std::string> records(std::size_t series) const;
  /// Rays, or what else the blocks of the series are made of.
  [[nodiscard]] std::uint64_t ray_count(std::size_t series) const;
  /// Seconds that the series' blocks took, by the clock.
  [[nodiscard]] double seconds(std::size_t series) const;

 private:
  explicit RunStore(std::unique_ptr<sqlite::Database> database);

  std::unique_ptr<sqlite::Database> database_;
};

}  // namespace lamina::census
