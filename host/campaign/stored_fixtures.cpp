// SPDX-License-Identifier: MIT
#include "campaign/stored_fixtures.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "campaign/row_checksum.hpp"

namespace regista::campaign {
namespace {

std::int64_t checksum_of(const std::string& key, const std::string& job) {
  return RowChecksum().bytes(key).bytes(job).value();
}

}  // namespace

void StoredFixtures::add(std::span<const Fixture> fixtures) {
  SQLite::Statement add(database_, "INSERT OR IGNORE INTO fixtures(key, job, checksum) VALUES(?, ?, ?)");
  for (const Fixture& fixture : fixtures) {
    const std::string job = to_json(fixture.job);
    add.bindNoCopy(1, fixture.key);
    add.bindNoCopy(2, job);
    add.bind(3, checksum_of(fixture.key, job));
    add.exec();
    add.reset();
  }
}

void StoredFixtures::check() {
  if (std::exchange(checked_, true)) return;
  SQLite::Statement each(database_, "SELECT id, key, job, checksum FROM fixtures");
  while (each.executeStep()) {
    if (checksum_of(each.getColumn(1).getString(), each.getColumn(2).getString()) == each.getColumn(3).getInt64())
      continue;
    throw std::invalid_argument(fmt::format("the checksum of fixture {} does not fit", each.getColumn(0).getInt64()));
  }
}

std::vector<std::int64_t> StoredFixtures::numbers(std::span<const std::string> keys) {
  check();
  std::vector<std::int64_t> out;
  SQLite::Statement select(database_, "SELECT id FROM fixtures WHERE key = ?");
  for (const std::string& key : keys) {
    select.bindNoCopy(1, key);
    out.push_back(select.executeStep() ? select.getColumn(0).getInt64() : 0);
    select.reset();
  }
  return out;
}

std::vector<std::pair<std::int64_t, std::string>> StoredFixtures::keys() {
  check();
  std::vector<std::pair<std::int64_t, std::string>> out;
  SQLite::Statement each(database_, "SELECT id, key FROM fixtures ORDER BY id");
  while (each.executeStep()) out.emplace_back(each.getColumn(0).getInt64(), each.getColumn(1).getString());
  return out;
}

std::vector<Fixture> StoredFixtures::all() {
  check();
  std::vector<Fixture> out;
  SQLite::Statement each(database_, "SELECT key, job FROM fixtures ORDER BY id");
  while (each.executeStep())
    out.push_back({each.getColumn(0).getString(), job_from_json(each.getColumn(1).getString())});
  return out;
}

Job StoredFixtures::job(std::int64_t number, std::int64_t row) {
  SQLite::Statement select(database_, "SELECT key, job, checksum FROM fixtures WHERE id = ?");
  select.bind(1, number);
  if (!select.executeStep()) throw DamagedRow(row, "what was to be played is missing");
  const std::string job = select.getColumn(1).getString();
  if (checksum_of(select.getColumn(0).getString(), job) != select.getColumn(2).getInt64()) {
    throw DamagedRow(row, "the checksum of what was to be played does not fit");
  }
  try {
    return job_from_json(job);
  } catch (const std::invalid_argument& error) {
    throw DamagedRow(row, error.what());
  }
}

}  // namespace regista::campaign
