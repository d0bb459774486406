// SPDX-License-Identifier: MIT
// Matches in a file of results: the tables matches, remarks, metric_names, metrics and packets.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"

namespace SQLite {
class Database;
}

namespace regista::campaign {

// The result of StoredMatches::take(), which copies matches of another file.
struct Taken {
  std::uint64_t rows = 0, known = 0;  // rows: copied matches; known: matches that this file had with the same result
  // The number of refused matches, and one line for each of the first 20. Reasons: this file lacks the fixture; the row
  // is damaged or holds another match; this file has another result of the same match.
  std::uint64_t refused = 0;
  std::vector<std::string> why;
  friend bool operator==(const Taken&, const Taken&) = default;
};

// Maps the number of a fixture in another file to the number of the same fixture in this file.
using FixtureNumbers = std::map<std::int64_t, std::int64_t>;

class StoredMatches {
 public:
  // SQL that creates the tables.
  static std::string tables();

  // `database` must have the tables of tables() and outlive this object. Functions throw SQLite::Exception and
  // DamagedRow. find(), metric_paths() and insert() do what these functions of Store do.
  StoredMatches(SQLite::Database& database, bool written_to);
  ~StoredMatches();

  std::optional<MatchResult> find(std::int64_t row, const MatchKey& key, Metrics metrics);
  struct Row {
    MatchKey key;
    MatchResult decided;  // with all metrics
  };
  std::optional<Row> row(std::int64_t row);
  std::int64_t rows();
  // Returns the first row from `from` to `to` for which `planned` returns false; nothing if there is no such row.
  std::optional<std::int64_t> first_not_planned(
      std::int64_t from, std::int64_t to, const std::function<bool(std::int64_t row, const MatchKey& key)>& planned);
  match::MetricPaths metric_paths(std::int64_t rows);

  // Must be called within a transaction.
  void insert(std::int64_t row, const MatchKey& key, const MatchResult& decided, int attempts);

  // Copies the matches of `other` that this file lacks into the same rows, within a transaction of the caller. Refuses
  // matches whose fixture is not in `fixtures`, and rows that cannot be read.
  Taken take(StoredMatches& other, const FixtureNumbers& fixtures);

  // Returns the rows of all matches that cannot be read.
  std::vector<std::int64_t> damaged_rows();
  // Releases the current rows of all tables: see RowsInOrder::reset().
  void reset();

 private:
  struct Impl;
  std::unique_ptr<Impl> parts_;
};

}  // namespace regista::campaign
