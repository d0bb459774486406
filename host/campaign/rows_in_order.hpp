// SPDX-License-Identifier: MIT
// Rows of a table that are asked for one after the other, by their number. Mostly they are asked for in their order: a
// statement that goes on from row to row is much faster than one for each.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace regista::campaign {

class RowsInOrder {
 public:
  // what: columns and table, as "row, names FROM metrics"; the first column is the number of the row. In a database
  // that outlives this. All throw SQLite::Exception.
  RowsInOrder(SQLite::Database& database, const std::string& what);
  ~RowsInOrder();
  RowsInOrder(const RowsInOrder&) = delete;
  RowsInOrder& operator=(const RowsInOrder&) = delete;

  // The statement at that row, valid until the next question; null where there is no such row.
  SQLite::Statement* at(std::int64_t row);
  // Lets go of the table: who holds on to a row keeps others from writing.
  void reset();

 private:
  std::unique_ptr<SQLite::Statement> statement_;
  std::optional<std::int64_t> next_;  // the row that it comes to next
};

}  // namespace regista::campaign
