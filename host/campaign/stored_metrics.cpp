// SPDX-License-Identifier: MIT
#include "campaign/stored_metrics.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "campaign/match_encoding.hpp"
#include "campaign/stored_row.hpp"
#include "match/side.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

std::int64_t checksum_of(std::int64_t row, std::int64_t names, std::int64_t size, std::string_view numbers) {
  return RowChecksum().whole(row).whole(names).whole(size).bytes(numbers).value();
}

}  // namespace

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

std::string StoredMetrics::text_of_names(std::int64_t id) {
  SQLite::Statement find(database_, "SELECT names, checksum FROM metric_names WHERE id = ?");
  find.bind(1, id);
  if (!find.executeStep()) throw std::invalid_argument(fmt::format("metric names {} are missing", id));
  std::string out = find.getColumn(0).getString();
  if (RowChecksum().bytes(out).value() != find.getColumn(1).getInt64()) {
    throw std::invalid_argument(fmt::format("the checksum of metric names {} does not fit", id));
  }
  return out;
}

const StoredMetrics::Names& StoredMetrics::names_under(std::int64_t row, std::int64_t id) {
  if (const auto known = by_id_.find(id); known != by_id_.end()) return known->second;
  return by_id_.emplace(id, reading_row(row, "metrics: ", [&] { return names_of(text_of_names(id)); })).first->second;
}

std::optional<std::int64_t> StoredMetrics::id_of_text(const std::string& text) {
  SQLite::Statement find(database_, "SELECT id FROM metric_names WHERE names = ?");
  find.bindNoCopy(1, text);
  return find.executeStep() ? std::optional(find.getColumn(0).getInt64()) : std::nullopt;
}

std::int64_t StoredMetrics::add(const std::string& text) {
  SQLite::Statement insert_names(database_, "INSERT INTO metric_names(names, checksum) VALUES(?, ?)");
  put(insert_names, text, RowChecksum().bytes(text).value());
  return database_.getLastInsertRowid();
}

// Returns the id of the names, and stores new names. New names enter by_id_ only when the next match finds them in the
// table, because the transaction that stores them may fail.
std::int64_t StoredMetrics::id_of(const Names& names) {
  const auto known =
      std::ranges::find_if(by_id_, [&](const auto& each) { return each.second == names || *each.second == *names; });
  if (known != by_id_.end()) return known->first;
  const std::string text = names_text(*names);
  if (const auto there = id_of_text(text)) return by_id_.emplace(*there, names).first->first;
  return add(text);
}

std::optional<StoredMetrics::Packed> StoredMetrics::packed(std::int64_t row) {
  SQLite::Statement* const found = rows_.at(row);
  if (found == nullptr) return std::nullopt;
  const std::int64_t id = found->getColumn(1).getInt64(), size = found->getColumn(2).getInt64();
  const std::string_view frame = blob_of(found->getColumn(3));
  if (checksum_of(row, id, size, frame) != found->getColumn(4).getInt64()) {
    throw DamagedRow(row, "the checksum of its metrics does not fit");
  }
  return Packed{id, size, frame};
}

void StoredMetrics::write(std::int64_t row, const Packed& numbers) {
  const auto& [names, size, frame] = numbers;
  put(*insert_, row, names, size, Blob{frame}, checksum_of(row, names, size, frame));
}

StoredMetrics::StoredMetrics(SQLite::Database& database, bool written_to)
    : database_(database), rows_(database, "row, names, size, numbers, checksum FROM metrics") {
  // This statement only tests whether the table exists, and throws if it does not. text_of_names() reads names later.
  SQLite::Statement(database, "SELECT id, names, checksum FROM metric_names");
  if (!written_to) return;
  insert_ = std::make_unique<SQLite::Statement>(
      database, "INSERT INTO metrics(row, names, size, numbers, checksum) VALUES(?, ?, ?, ?, ?)");
}

StoredMetrics::~StoredMetrics() = default;

match::MetricNumbers StoredMetrics::read(std::int64_t row) {
  const std::optional<Packed> found = packed(row);
  if (!found) return {};
  const Names& names = names_under(row, found->names);
  return reading_row(row, "metrics: ", [&]() -> match::MetricNumbers {
    try {
      decompressor_.decompress(found->frame, static_cast<std::uint64_t>(found->size), bytes_);
    } catch (const mcap::Malformed& error) {
      throw std::invalid_argument(error.why);
    }
    return {names, numbers_of(bytes_, names->size())};
  });
}

std::int64_t StoredMetrics::number_of_names(const std::string& text) {
  if (const auto there = id_of_text(text)) return *there;
  names_of(text);  // throws if the text is not a list of names
  return add(text);
}

match::MetricPaths StoredMetrics::paths(std::int64_t rows) {
  match::MetricPaths out;
  SQLite::Statement each(database_,
                         "SELECT min(row), names FROM metrics WHERE row <= ? GROUP BY names ORDER BY min(row)");
  each.bind(1, rows);
  while (each.executeStep()) {
    const Names& names = names_under(each.getColumn(0).getInt64(), each.getColumn(1).getInt64());
    const auto take = [&names](std::vector<std::string>& paths, const std::vector<std::size_t>& places) {
      for (const std::size_t place : places) texts::add_once(paths, names->path(place));
    };
    for (const match::Side side : match::both_sides) take(out.of_teams, names->of(side));
    take(out.of_match, names->of_match());
  }
  return out;
}

void StoredMetrics::write(std::int64_t row, const match::MetricNumbers& numbers) {
  const std::string bytes = number_bytes(numbers.values());
  std::string frame;
  compressor_.append(frame, bytes);
  write(row, Packed{id_of(numbers.shared_names()), static_cast<std::int64_t>(bytes.size()), frame});
}

}  // namespace regista::campaign
