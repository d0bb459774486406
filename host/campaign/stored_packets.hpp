// SPDX-License-Identifier: MIT
// What teams spent in short games, in a file of results: the table packets. The same numbers stand among all numbers of
// a match, but reports of scores read these of every match, and to unpack all for them takes most of the time. A file
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

  // The metrics of match/packet_metrics.hpp of both sides; nothing where the file has none of this match.
  std::optional<match::MetricNumbers> read(std::int64_t row);
  // Within a transaction. Of a match that has not all of them nothing is written.
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
