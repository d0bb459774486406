// SPDX-License-Identifier: MIT
#include "campaign/stored_matches.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <utility>

#include "campaign/row_checksum.hpp"
#include "campaign/stored_metrics.hpp"

namespace regista::campaign {
namespace {

constexpr int most_goals = 100'000;  // of a row that can be believed
constexpr auto own_tables = R"(
  CREATE TABLE matches(
    row INTEGER PRIMARY KEY,
    fixture INTEGER NOT NULL REFERENCES fixtures(id),
    seed INTEGER NOT NULL,
    home_goals INTEGER NOT NULL,
    away_goals INTEGER NOT NULL,
    ended TEXT NOT NULL,
    hash TEXT,
    failure TEXT,
    seconds REAL NOT NULL,
    attempts INTEGER NOT NULL,
    checksum INTEGER NOT NULL,
    UNIQUE(fixture, seed)
  );
  CREATE TABLE remarks(
    row INTEGER NOT NULL REFERENCES matches(row),
    kind TEXT NOT NULL,
    text TEXT NOT NULL,
    checksum INTEGER NOT NULL,
    PRIMARY KEY(row, kind)
  ) WITHOUT ROWID;)";
constexpr auto columns =
    "row, fixture, seed, home_goals, away_goals, ended, hash, failure, seconds, attempts, checksum";

void bind_or_null(SQLite::Statement& statement, int index, const std::string& text) {
  if (text.empty())
    statement.bind(index);
  else
    statement.bindNoCopy(index, text);
}

std::string text_of(const SQLite::Column& column) { return column.isNull() ? std::string() : column.getString(); }

// The match under the cursor of by_row or by_key.
MatchKey key_of(SQLite::Statement& row) {
  return {row.getColumn(1).getInt64(), std::bit_cast<std::uint64_t>(row.getColumn(2).getInt64())};
}

std::int64_t checksum_of(std::int64_t row, const MatchKey& key, const Decided& decided, const std::string& failure,
                         std::int64_t attempts) {
  return RowChecksum()
      .whole(row)
      .whole(key.fixture)
      .whole(std::bit_cast<std::int64_t>(key.seed))
      .whole(decided.score[0])
      .whole(decided.score[1])
      .bytes(decided.ended)
      .bytes(decided.hash)
      .bytes(failure)
      .real(decided.seconds)
      .whole(attempts)
      .value();
}

// Texts of the table remarks, by their kind.
std::array<std::pair<const char*, std::string*>, 3> remarks_of(Decided& decided) {
  return {{{"set_aside", &decided.why_set_aside},
           {"irreproducible", &decided.irreproducible},
           {"output", &decided.output}}};
}

std::string select_where(const char* condition) {
  return fmt::format("SELECT {} FROM matches WHERE {}", columns, condition);
}

}  // namespace

struct StoredMatches::Parts {
  Parts(SQLite::Database& in, bool written_to)
      : database(in),
        metrics(in, written_to),
        by_row(in, select_where("row = ?")),
        by_key(in, select_where("fixture = ? AND seed = ?")),
        remarks(in, "SELECT kind, text, checksum FROM remarks WHERE row = ?"),
        any_remarks(in.execAndGet("SELECT EXISTS(SELECT 1 FROM remarks)").getInt() != 0) {
    if (!written_to) return;
    insert.emplace(in, fmt::format("INSERT INTO matches({}) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", columns));
    insert_remark.emplace(in, "INSERT INTO remarks(row, kind, text, checksum) VALUES(?, ?, ?, ?)");
  }

  Decided decided_of(SQLite::Statement& cursor, Metrics wanted) {
    const std::int64_t row = cursor.getColumn(0).getInt64();
    const MatchKey key = key_of(cursor);
    Decided out;
    out.score = {cursor.getColumn(3).getInt(), cursor.getColumn(4).getInt()};
    out.ended = cursor.getColumn(5).getString();
    out.hash = text_of(cursor.getColumn(6));
    const std::string failure = text_of(cursor.getColumn(7));
    out.seconds = cursor.getColumn(8).getDouble();
    if (checksum_of(row, key, out, failure, cursor.getColumn(9).getInt64()) != cursor.getColumn(10).getInt64()) {
      throw DamagedRow(row, "its checksum does not fit");
    }
    if (std::ranges::any_of(out.score, [](int goals) { return goals < 0 || goals > most_goals; })) {
      throw DamagedRow(row, "a score that no match has");
    }
    try {
      if (!failure.empty()) out.failure = failure_from_json(failure);
    } catch (const std::invalid_argument& error) {
      throw DamagedRow(row, error.what());
    }
    if (any_remarks) read_remarks(row, out);
    if ((out.ended == "set_aside") != out.set_aside()) throw DamagedRow(row, "a match set aside without a reason");
    if (wanted == Metrics::wanted && !out.hash.empty()) {
      out.metrics = metrics.read(row);
      if (out.metrics.empty()) throw DamagedRow(row, "its metrics are missing");
    }
    cursor.reset();
    return out;
  }

  void read_remarks(std::int64_t row, Decided& out) {
    remarks.tryReset();
    remarks.bind(1, row);
    while (remarks.executeStep()) {
      const std::string kind = remarks.getColumn(0).getString(), said = remarks.getColumn(1).getString();
      if (RowChecksum().whole(row).bytes(kind).bytes(said).value() != remarks.getColumn(2).getInt64()) {
        throw DamagedRow(row, "the checksum of a remark does not fit");
      }
      for (const auto& [name, text] : remarks_of(out)) {
        if (kind == name) *text = said;
      }
    }
    remarks.reset();
  }

  void write_remarks(std::int64_t row, Decided decided) {
    for (const auto& [name, text] : remarks_of(decided)) {
      if (text->empty()) continue;
      insert_remark->tryReset();
      insert_remark->bind(1, row);
      insert_remark->bind(2, name);
      insert_remark->bindNoCopy(3, *text);
      insert_remark->bind(4, RowChecksum().whole(row).bytes(name).bytes(*text).value());
      insert_remark->exec();
      insert_remark->reset();
      any_remarks = true;
    }
  }

  SQLite::Database& database;
  StoredMetrics metrics;
  SQLite::Statement by_row, by_key, remarks;
  std::optional<SQLite::Statement> insert, insert_remark;
  bool any_remarks;
};

std::string StoredMatches::tables() { return std::string(own_tables) + StoredMetrics::tables; }

StoredMatches::StoredMatches(SQLite::Database& database, bool written_to)
    : parts_(std::make_unique<Parts>(database, written_to)) {}
StoredMatches::~StoredMatches() = default;

std::optional<Decided> StoredMatches::find(std::int64_t row, const MatchKey& key, Metrics metrics) {
  SQLite::Statement& first = parts_->by_row;
  first.tryReset();
  first.bind(1, row);
  if (first.executeStep()) {
    const bool wanted = key_of(first) == key;
    // Another match stands there, or its key is damaged.
    Decided found = parts_->decided_of(first, wanted ? metrics : Metrics::left_out);
    if (wanted) return found;
  }
  SQLite::Statement& second = parts_->by_key;
  second.tryReset();
  second.bind(1, key.fixture);
  second.bind(2, std::bit_cast<std::int64_t>(key.seed));
  if (!second.executeStep()) return std::nullopt;
  return parts_->decided_of(second, metrics);
}

std::optional<StoredMatches::Row> StoredMatches::row(std::int64_t row) {
  SQLite::Statement& select = parts_->by_row;
  select.tryReset();
  select.bind(1, row);
  if (!select.executeStep()) return std::nullopt;
  const MatchKey key = key_of(select);
  return Row{key, parts_->decided_of(select, Metrics::wanted)};
}

std::int64_t StoredMatches::rows() { return parts_->database.execAndGet("SELECT count(*) FROM matches").getInt64(); }

match::MetricPaths StoredMatches::metric_paths(std::int64_t rows) { return parts_->metrics.paths(rows); }

void StoredMatches::insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts) {
  const std::string failure = decided.failure ? to_json(*decided.failure) : std::string();
  SQLite::Statement& insert = *parts_->insert;
  insert.tryReset();  // reset would report once more what went wrong last time
  insert.bind(1, row);
  insert.bind(2, key.fixture);
  insert.bind(3, std::bit_cast<std::int64_t>(key.seed));
  insert.bind(4, decided.score[0]);
  insert.bind(5, decided.score[1]);
  insert.bindNoCopy(6, decided.ended);
  bind_or_null(insert, 7, decided.hash);
  bind_or_null(insert, 8, failure);
  insert.bind(9, decided.seconds);
  insert.bind(10, attempts);
  insert.bind(11, checksum_of(row, key, decided, failure, attempts));
  insert.exec();
  insert.reset();
  if (!decided.metrics.empty()) parts_->metrics.write(row, decided.metrics);
  parts_->write_remarks(row, decided);
}

std::vector<std::int64_t> StoredMatches::damaged_rows() {
  std::vector<std::int64_t> out;
  SQLite::Statement each(parts_->database, "SELECT row FROM matches ORDER BY row");
  while (each.executeStep()) {
    const std::int64_t place = each.getColumn(0).getInt64();
    try {
      row(place);
    } catch (const DamagedRow&) {
      out.push_back(place);
    }
  }
  return out;
}

void StoredMatches::reset() {
  parts_->by_row.tryReset();
  parts_->by_key.tryReset();
  parts_->metrics.reset();
  parts_->remarks.tryReset();
}

}  // namespace regista::campaign
