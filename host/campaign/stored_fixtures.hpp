// SPDX-License-Identifier: MIT
// What is to be played, as a file of results holds it: the table fixtures.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/job.hpp"

namespace SQLite {
class Database;
}

namespace regista::campaign {

// key: see inputs.hpp. job: with any seed.
struct Fixture {
  std::string key;
  Job job;
};

class StoredFixtures {
 public:
  static constexpr auto tables = R"(
    CREATE TABLE fixtures(
      id INTEGER PRIMARY KEY,
      key TEXT NOT NULL UNIQUE,
      job TEXT NOT NULL,
      checksum INTEGER NOT NULL
    );)";

  // In a database that has this table and outlives this. All throw SQLite::Exception.
  explicit StoredFixtures(SQLite::Database& database) : database_(database) {}

  // Those that are new are added, all at once.
  void add(std::span<const Fixture> fixtures);
  // The numbers of those that there are, in this order; 0 for others. Throws std::invalid_argument when any is damaged:
  // one whose key is damaged would not be found, and its matches would count as not played.
  std::vector<std::int64_t> numbers(std::span<const std::string> keys);
  // All that there are, by their numbers: with their keys, or whole. Throw std::invalid_argument when any is damaged.
  std::vector<std::pair<std::int64_t, std::string>> keys();
  std::vector<Fixture> all();
  // Throws DamagedRow, which names `row`: the match that it is asked for.
  Job job(std::int64_t number, std::int64_t row);

 private:
  void check();

  SQLite::Database& database_;
  bool checked_ = false;
};

}  // namespace regista::campaign
