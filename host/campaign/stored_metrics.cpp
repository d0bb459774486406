// SPDX-License-Identifier: MIT
#include "campaign/stored_metrics.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "campaign/metric_bytes.hpp"
#include "campaign/row_checksum.hpp"
#include "campaign/rows_in_order.hpp"
#include "mcap/compression.hpp"
#include "mcap/decode.hpp"

namespace regista::campaign {
namespace {

using Names = std::shared_ptr<const match::MetricNames>;

std::int64_t checksum_of(std::int64_t row, std::int64_t names, std::int64_t size, std::string_view numbers) {
  return RowChecksum().whole(row).whole(names).whole(size).bytes(numbers).value();
}

}  // namespace

struct StoredMetrics::Parts {
  explicit Parts(SQLite::Database& in) : database(in), rows(in, "row, names, size, numbers, checksum FROM metrics") {}

  std::string text(std::int64_t id) {
    SQLite::Statement find(database, "SELECT names, checksum FROM metric_names WHERE id = ?");
    find.bind(1, id);
    if (!find.executeStep()) throw std::invalid_argument(fmt::format("metric names {} are missing", id));
    std::string out = find.getColumn(0).getString();
    if (RowChecksum().bytes(out).value() != find.getColumn(1).getInt64()) {
      throw std::invalid_argument(fmt::format("the checksum of metric names {} does not fit", id));
    }
    return out;
  }

  // row: that has them.
  const Names& names(std::int64_t row, std::int64_t id) {
    if (const auto known = by_id.find(id); known != by_id.end()) return known->second;
    try {
      return by_id.emplace(id, names_of(text(id))).first->second;
    } catch (const std::invalid_argument& error) {
      throw DamagedRow(row, std::string("metrics: ") + error.what());
    }
  }

  std::optional<std::int64_t> id_of_text(const std::string& text) {
    SQLite::Statement find(database, "SELECT id FROM metric_names WHERE names = ?");
    find.bindNoCopy(1, text);
    return find.executeStep() ? std::optional(find.getColumn(0).getInt64()) : std::nullopt;
  }

  std::int64_t add(const std::string& text) {
    SQLite::Statement insert_names(database, "INSERT INTO metric_names(names, checksum) VALUES(?, ?)");
    insert_names.bindNoCopy(1, text);
    insert_names.bind(2, RowChecksum().bytes(text).value());
    insert_names.exec();
    return database.getLastInsertRowid();
  }

  // The same names come with almost every match. Names that are new are known from the next match on: the transaction
  // that adds them may fail.
  std::int64_t id_of(const Names& names) {
    const auto known =
        std::ranges::find_if(by_id, [&](const auto& each) { return each.second == names || *each.second == *names; });
    if (known != by_id.end()) return known->first;
    const std::string text = names_text(*names);
    if (const auto there = id_of_text(text)) return by_id.emplace(*there, names).first->first;
    return add(text);
  }

  // Nothing where there are none.
  std::optional<Packed> packed(std::int64_t row) {
    SQLite::Statement* const found = rows.at(row);
    if (found == nullptr) return std::nullopt;
    const std::int64_t id = found->getColumn(1).getInt64(), size = found->getColumn(2).getInt64();
    const SQLite::Column column = found->getColumn(3);
    const std::string_view frame(static_cast<const char*>(column.getBlob()),
                                 static_cast<std::size_t>(column.getBytes()));
    if (checksum_of(row, id, size, frame) != found->getColumn(4).getInt64()) {
      throw DamagedRow(row, "the checksum of its metrics does not fit");
    }
    return Packed{id, size, frame};
  }

  // id: of the names, here.
  void put(std::int64_t row, std::int64_t id, std::int64_t size, std::string_view frame) {
    insert->tryReset();
    insert->bind(1, row);
    insert->bind(2, id);
    insert->bind(3, size);
    insert->bindNoCopy(4, frame.data(), static_cast<int>(frame.size()));
    insert->bind(5, checksum_of(row, id, size, frame));
    insert->exec();
    insert->reset();
  }

  SQLite::Database& database;
  RowsInOrder rows;
  std::optional<SQLite::Statement> insert;
  std::map<std::int64_t, Names> by_id;
  mcap::Compressor compressor;
  mcap::Decompressor decompressor;
  std::string bytes;  // of the match that was read last
};

StoredMetrics::StoredMetrics(SQLite::Database& database, bool written_to) : parts_(std::make_unique<Parts>(database)) {
  // Refuses a file without them; they are read when the first match asks for them.
  SQLite::Statement(database, "SELECT id, names, checksum FROM metric_names");
  if (written_to) {
    parts_->insert.emplace(database, "INSERT INTO metrics(row, names, size, numbers, checksum) VALUES(?, ?, ?, ?, ?)");
  }
}

StoredMetrics::~StoredMetrics() = default;

void StoredMetrics::reset() { parts_->rows.reset(); }

match::MetricNumbers StoredMetrics::read(std::int64_t row) {
  const std::optional<Packed> packed = parts_->packed(row);
  if (!packed) return {};
  const Names& names = parts_->names(row, packed->names);
  try {
    parts_->decompressor.decompress(packed->frame, static_cast<std::uint64_t>(packed->size), parts_->bytes);
    return {names, numbers_of(parts_->bytes, names->size())};
  } catch (const std::invalid_argument& error) {
    throw DamagedRow(row, std::string("metrics: ") + error.what());
  } catch (const mcap::Malformed& error) {
    throw DamagedRow(row, "metrics: " + error.why);
  }
}

StoredMetrics::Packed StoredMetrics::packed(std::int64_t row) {
  const std::optional<Packed> packed = parts_->packed(row);
  if (!packed) throw DamagedRow(row, "its metrics are missing");
  return *packed;
}

std::string StoredMetrics::text_of_names(std::int64_t row, std::int64_t names) {
  try {
    return parts_->text(names);
  } catch (const std::invalid_argument& error) {
    throw DamagedRow(row, std::string("metrics: ") + error.what());
  }
}

std::int64_t StoredMetrics::number_of_names(const std::string& text) {
  if (const auto there = parts_->id_of_text(text)) return *there;
  names_of(text);  // as they are read later
  return parts_->add(text);
}

void StoredMetrics::write(std::int64_t row, const Packed& numbers, std::int64_t names) {
  parts_->put(row, names, numbers.size, numbers.frame);
}

match::MetricPaths StoredMetrics::paths(std::int64_t rows) {
  match::MetricPaths out;
  SQLite::Statement each(parts_->database,
                         "SELECT min(row), names FROM metrics WHERE row <= ? GROUP BY names ORDER BY min(row)");
  each.bind(1, rows);
  while (each.executeStep()) {
    const Names& names = parts_->names(each.getColumn(0).getInt64(), each.getColumn(1).getInt64());
    const auto take = [&names](std::vector<std::string>& paths, const std::vector<std::size_t>& places) {
      for (const std::size_t place : places) {
        if (std::ranges::find(paths, names->path(place)) == paths.end()) paths.push_back(names->path(place));
      }
    };
    for (const match::Side side : match::both_sides) take(out.of_teams, names->of(side));
    take(out.of_match, names->of_match());
  }
  return out;
}

void StoredMetrics::write(std::int64_t row, const match::MetricNumbers& numbers) {
  const std::string bytes = number_bytes(numbers.values());
  std::string frame;
  parts_->compressor.append(frame, bytes);
  parts_->put(row, parts_->id_of(numbers.shared_names()), static_cast<std::int64_t>(bytes.size()), frame);
}

}  // namespace regista::campaign
