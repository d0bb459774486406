// SPDX-License-Identifier: MIT
// The metrics of matches in a file of results. The table metrics holds the numbers of each match, compressed. The table
// metric_names holds the names of these numbers, once for all matches with the same names.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "match/metric_numbers.hpp"
#include "mcap/encoding.hpp"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace regista::campaign {

// Reads the rows of a table by their number. If callers read rows in ascending order, one statement steps from row to
// row, which is much faster than a new query for each row.
class RowsInOrder {
 public:
  // what: columns and table, as in "row, names FROM metrics"; the first column must be the number of the row.
  // `database` must outlive this object. All functions throw SQLite::Exception.
  RowsInOrder(SQLite::Database& database, const std::string& what);
  ~RowsInOrder();

  // Returns the statement at this row, valid until the next call; null if the table has no such row.
  SQLite::Statement* at(std::int64_t row);
  // Releases the current row, so that other programs can write to the file.
  void reset();

 private:
  std::unique_ptr<SQLite::Statement> statement_;
  std::optional<std::int64_t> next_;  // the row that the statement reads next
};

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

  // `database` must have these tables and outlive this object. All functions throw SQLite::Exception.
  StoredMetrics(SQLite::Database& database, bool written_to);
  ~StoredMetrics();

  // Returns the metrics of the match in this row; empty if the match has no metrics. Throws DamagedRow.
  match::MetricNumbers read(std::int64_t row);
  // Writes the numbers of a match. Must be called within a transaction.
  void write(std::int64_t row, const match::MetricNumbers& numbers);

  // The numbers of a row as stored, for a copy to another file. `frame` is valid until the next row is read. packed()
  // returns nothing if the row has no numbers, and throws DamagedRow if the checksum does not fit.
  struct Packed {
    std::int64_t names = 0;  // id of the names of the numbers in the table metric_names of this file
    std::int64_t size = 0;
    std::string_view frame;
  };
  std::optional<Packed> packed(std::int64_t row);
  // Returns the names with this id as text. Throws std::invalid_argument if this text is damaged or missing.
  std::string text_of_names(std::int64_t id);
  // Returns the id of a text of names in this file; adds the text if it is new. Must be called within a transaction.
  // Throws std::invalid_argument if the text is not a list of names.
  std::int64_t number_of_names(const std::string& text);
  // Writes packed numbers; `names` is the id of their names in this file. Must be called within a transaction.
  void write(std::int64_t row, const Packed& numbers);

  // Returns the paths of all metrics in rows 1 to `rows`, each once, in order of first appearance. Throws DamagedRow.
  match::MetricPaths paths(std::int64_t rows);
  // Releases the current row: see RowsInOrder::reset().
  void reset() { rows_.reset(); }

 private:
  using Names = std::shared_ptr<const match::MetricNames>;
  const Names& names_under(std::int64_t row, std::int64_t id);
  std::optional<std::int64_t> id_of_text(const std::string& text);
  std::int64_t add(const std::string& text);
  std::int64_t id_of(const Names& names);

  SQLite::Database& database_;
  RowsInOrder rows_;
  std::unique_ptr<SQLite::Statement> insert_;  // null: the file is only read
  std::map<std::int64_t, Names> by_id_;
  mcap::Compressor compressor_;
  mcap::Decompressor decompressor_;
  std::string bytes_;  // numbers of the match that was read last, not compressed
};

}  // namespace regista::campaign
