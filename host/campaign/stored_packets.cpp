// SPDX-License-Identifier: MIT
#include "campaign/stored_packets.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "campaign/metric_bytes.hpp"
#include "campaign/row_checksum.hpp"
#include "campaign/rows_in_order.hpp"
#include "match/packet_metrics.hpp"
#include "match/side.hpp"

namespace regista::campaign {
namespace {

std::int64_t checksum_of(std::int64_t row, std::string_view numbers) {
  return RowChecksum().whole(row).bytes(numbers).value();
}

std::shared_ptr<const match::MetricNames> packet_names() {
  std::vector<match::MetricName> out;
  for (const char* const name : match::packet_metrics) {
    for (const match::Side side : match::both_sides) out.push_back({.side = side, .name = name});
  }
  return std::make_shared<const match::MetricNames>(std::move(out));
}

}  // namespace

struct StoredPackets::Parts {
  Parts(SQLite::Database& database, bool written_to) : rows(database, "row, numbers, checksum FROM packets") {
    // The row may be there: whoever takes a match out of a file need not know this table.
    if (written_to) insert.emplace(database, "INSERT OR REPLACE INTO packets(row, numbers, checksum) VALUES(?, ?, ?)");
  }

  RowsInOrder rows;
  std::optional<SQLite::Statement> insert;
  std::shared_ptr<const match::MetricNames> names = packet_names();
};

StoredPackets::StoredPackets(SQLite::Database& database, bool written_to)
    : parts_(database.tableExists("packets") ? std::make_unique<Parts>(database, written_to) : nullptr) {}
StoredPackets::~StoredPackets() = default;

std::optional<std::string_view> StoredPackets::packed(std::int64_t row) {
  if (!parts_) return std::nullopt;
  SQLite::Statement* const found = parts_->rows.at(row);
  if (found == nullptr) return std::nullopt;
  const SQLite::Column column = found->getColumn(1);
  const std::string_view out(static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes()));
  if (checksum_of(row, out) != found->getColumn(2).getInt64()) {
    throw DamagedRow(row, "the checksum of its packets does not fit");
  }
  return out;
}

std::optional<match::MetricNumbers> StoredPackets::read(std::int64_t row) {
  const std::optional<std::string_view> bytes = packed(row);
  if (!bytes) return std::nullopt;
  try {
    return match::MetricNumbers(parts_->names, numbers_of(*bytes, parts_->names->size()));
  } catch (const std::invalid_argument& error) {
    throw DamagedRow(row, std::string("packets: ") + error.what());
  }
}

void StoredPackets::write(std::int64_t row, const match::MetricNumbers& numbers) {
  if (!parts_) return;
  std::vector<double> values;
  for (std::size_t i = 0; i < parts_->names->size(); ++i) {
    const match::MetricName& name = (*parts_->names)[i];
    const std::optional<std::size_t> place = numbers.names().find(name.side, name.name);
    values.push_back(place ? numbers.values()[*place] : std::numeric_limits<double>::quiet_NaN());
  }
  write(row, number_bytes(values));
}

void StoredPackets::write(std::int64_t row, std::string_view packed) {
  if (!parts_) return;
  SQLite::Statement& insert = *parts_->insert;
  insert.tryReset();
  insert.bind(1, row);
  insert.bindNoCopy(2, packed.data(), static_cast<int>(packed.size()));
  insert.bind(3, checksum_of(row, packed));
  insert.exec();
  insert.reset();
}

void StoredPackets::reset() {
  if (parts_) parts_->rows.reset();
}

}  // namespace regista::campaign
