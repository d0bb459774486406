// SPDX-License-Identifier: MIT
// The numbers of matches in a file of results: their names once for all matches that have the same, the numbers
// themselves compressed, in the tables metric_names and metrics.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "match/metric_numbers.hpp"

namespace SQLite {
class Database;
}

namespace regista::campaign {

class StoredMetrics {
 public:
  static constexpr auto tables = R"(
    CREATE TABLE metric_names(id INTEGER PRIMARY KEY, names TEXT NOT NULL, checksum INTEGER NOT NULL);
    CREATE TABLE metrics(
      row INTEGER PRIMARY KEY REFERENCES matches(row),
      names INTEGER NOT NULL REFERENCES metric_names(id),
      size INTEGER NOT NULL,
      numbers BLOB NOT NULL,
      checksum INTEGER NOT NULL
    );)";

  // In a database that has these tables and outlives this. All throw SQLite::Exception.
  StoredMetrics(SQLite::Database& database, bool written_to);
  ~StoredMetrics();
  StoredMetrics(const StoredMetrics&) = delete;
  StoredMetrics& operator=(const StoredMetrics&) = delete;

  // None of a match that has none. Throws DamagedRow.
  match::MetricNumbers read(std::int64_t row);
  // Within a transaction.
  void write(std::int64_t row, const match::MetricNumbers& numbers);

  // The numbers of a row as they stand here, for another file. Valid until the next that is read. Throws DamagedRow
  // where they are missing or their checksum does not fit.
  struct Packed {
    std::int64_t names = 0;  // their number in this file
    std::int64_t size = 0;
    std::string_view frame;
  };
  Packed packed(std::int64_t row);
  // What stands here under the number of the names of a row. Throws DamagedRow.
  std::string text_of_names(std::int64_t row, std::int64_t names);
  // Within a transaction: the number of such names in this file, to which they are added. Throws std::invalid_argument
  // where the text holds none.
  std::int64_t number_of_names(const std::string& text);
  // Within a transaction. names: their number in this file.
  void write(std::int64_t row, const Packed& numbers, std::int64_t names);

  // Paths that the first rows have numbers under, each once, in the order in which they come up. Throws DamagedRow.
  match::MetricPaths paths(std::int64_t rows);
  // Lets go of what was read last.
  void reset();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::campaign
