// SPDX-License-Identifier: MIT
// What teams spent, in a file of results: the table packets. The same numbers stand among all numbers of a match. But
// reports of short games read these of every match, and to unpack all numbers for them took most of the time. A file
// that was begun before there was this table has none, and gets none.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "match/metric_numbers.hpp"

namespace SQLite {
class Database;
}

namespace regista::campaign {

class StoredPackets {
 public:
  static constexpr auto table = R"(
    CREATE TABLE packets(
      row INTEGER PRIMARY KEY REFERENCES matches(row),
      numbers BLOB NOT NULL,
      checksum INTEGER NOT NULL
    );)";

  // In a database that outlives this. All throw SQLite::Exception; what reads also DamagedRow.
  StoredPackets(SQLite::Database& database, bool written_to);
  ~StoredPackets();
  StoredPackets(const StoredPackets&) = delete;
  StoredPackets& operator=(const StoredPackets&) = delete;

  // The metrics of match/packet_metrics.hpp, of both sides; nothing where the table has no such row.
  std::optional<match::MetricNumbers> read(std::int64_t row);
  // Within a transaction. numbers: all of the match, not empty.
  void write(std::int64_t row, const match::MetricNumbers& numbers);

  // A row as it stands here, for another file. Valid until the next that is read.
  std::optional<std::string_view> packed(std::int64_t row);
  // Within a transaction.
  void write(std::int64_t row, std::string_view packed);

  // Lets go of what was read last.
  void reset();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;  // null: there is no such table
};

}  // namespace regista::campaign
