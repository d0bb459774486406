// SPDX-License-Identifier: MIT
#include "campaign/rows_in_order.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <limits>

namespace regista::campaign {

RowsInOrder::RowsInOrder(SQLite::Database& database, const std::string& what)
    : statement_(std::make_unique<SQLite::Statement>(database, "SELECT " + what + " WHERE row >= ? ORDER BY row")) {}
RowsInOrder::~RowsInOrder() = default;

SQLite::Statement* RowsInOrder::at(std::int64_t row) {
  if (next_ != row) {
    statement_->tryReset();
    statement_->bind(1, row);
  }
  next_.reset();
  if (!statement_->executeStep()) {
    statement_->reset();
    return nullptr;
  }
  if (statement_->getColumn(0).getInt64() != row) return nullptr;
  if (row < std::numeric_limits<std::int64_t>::max()) next_ = row + 1;
  return statement_.get();
}

void RowsInOrder::reset() {
  statement_->tryReset();
  next_.reset();
}

}  // namespace regista::campaign
