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
#include "campaign/match_key.hpp"

namespace SQLite {
class Database;
}

namespace regista::campaign {

// What came of matches that were played elsewhere.
struct Taken {
  std::uint64_t rows = 0, known = 0;  // taken over; here already, with the same result
  // Matches that do not fit, and why the first ones don't, a line each: nothing like them was planned, the row is
  // damaged or holds another match, or the same match had another result.
  std::uint64_t refused = 0;
  std::vector<std::string> why;
  friend bool operator==(const Taken&, const Taken&) = default;
};

// Numbers of fixtures in this file, by those in another.
using FixtureNumbers = std::map<std::int64_t, std::int64_t>;

class StoredMatches {
 public:
  // Of the tables, as SQL.
  static std::string tables();

  // In a database that has these tables and outlives this. All throw SQLite::Exception; what reads also DamagedRow.
  StoredMatches(SQLite::Database& database, bool written_to);
  ~StoredMatches();
  StoredMatches(const StoredMatches&) = delete;
  StoredMatches& operator=(const StoredMatches&) = delete;

  // The match of a key. `row`: where it is looked for first.
  std::optional<Decided> find(std::int64_t row, const MatchKey& key, Metrics metrics);
  struct Row {
    MatchKey key;
    Decided decided;  // with metrics
  };
  std::optional<Row> row(std::int64_t row);
  std::int64_t rows();
  // The first row from `from` to `to` for which `planned` is false.
  std::optional<std::int64_t> first_not_planned(
      std::int64_t from, std::int64_t to, const std::function<bool(std::int64_t row, const MatchKey& key)>& planned);
  // Paths that the first rows have numbers under, each once, in the order in which they come up.
  match::MetricPaths metric_paths(std::int64_t rows);

  // Within a transaction. Also refuses a key that there is already, and a row that is taken.
  void insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts);

  // Within a transaction: the matches of another file that are not here yet, in their rows. fixtures: the numbers here
  // of those of the other file; matches of others are refused. What can't be read there is left out, and said.
  Taken take(StoredMatches& other, const FixtureNumbers& fixtures);

  // All that cannot be read, by their rows.
  std::vector<std::int64_t> damaged_rows();
  // Lets go of what was read last.
  void reset();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::campaign
