// SPDX-License-Identifier: MIT
#include "campaign/stored_matches.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>

#include "campaign/match_encoding.hpp"
#include "campaign/stored_metrics.hpp"
#include "campaign/stored_row.hpp"

namespace regista::campaign {
namespace {

// Thrown if the source file fails while matches are copied. An error of the target file stays an SQLite::Exception.
class OtherFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Runs `work`, which reads the source file. Converts an SQLite::Exception of `work` into an OtherFile.
template <class Work>
auto reading_other(Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw OtherFile(error.what());
  }
}

constexpr int most_goals = 100'000;  // a row with more goals is damaged
constexpr std::size_t most_reasons = 20;
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

std::optional<std::string> or_null(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string text_of(const SQLite::Column& column) { return column.isNull() ? std::string() : column.getString(); }

// The table packets: the packets that both teams spent. The table metrics also has these numbers, but reports of short
// games need only the packets, and the unpacking of all metrics made these reports slow. Older files lack this table.
class Packets {
 public:
  static constexpr auto table = R"(
    CREATE TABLE packets(
      row INTEGER PRIMARY KEY REFERENCES matches(row),
      numbers BLOB NOT NULL,
      checksum INTEGER NOT NULL
    );)";

  Packets(SQLite::Database& database, bool written_to) {
    if (!database.tableExists("packets")) return;
    rows_.emplace(database, "row, numbers, checksum FROM packets");
    // The statement is REPLACE: a program that changes the file but does not know this table may have left an old row.
    if (written_to) insert_.emplace(database, "INSERT OR REPLACE INTO packets(row, numbers, checksum) VALUES(?, ?, ?)");
  }

  // Returns the stored bytes of a row, for a copy to another file; valid until the next row is read.
  std::optional<std::string_view> packed(std::int64_t row) {
    SQLite::Statement* const found = rows_ ? rows_->at(row) : nullptr;
    if (found == nullptr) return std::nullopt;
    const std::string_view out = blob_of(found->getColumn(1));
    if (checksum_of(row, out) != found->getColumn(2).getInt64()) {
      throw DamagedRow(row, "the checksum of its packets does not fit");
    }
    return out;
  }
  // Returns the numbers of match::packet_metrics for both sides; nothing if the table has no such row.
  std::optional<match::MetricNumbers> read(std::int64_t row) {
    const std::optional<std::string_view> bytes = packed(row);
    if (!bytes) return std::nullopt;
    return reading_row(row,
                       "packets: ", [&] { return match::MetricNumbers(names_, numbers_of(*bytes, names_->size())); });
  }

  // Must be called within a transaction.
  void write(std::int64_t row, std::string_view packed) {
    if (insert_) put(*insert_, row, Blob{packed}, checksum_of(row, packed));
  }
  // numbers: all metrics of the match, not empty.
  void write(std::int64_t row, const match::MetricNumbers& numbers) {
    if (!insert_) return;
    std::vector<double> values;
    for (std::size_t i = 0; i < names_->size(); ++i) {
      const match::MetricName& name = (*names_)[i];
      const std::optional<std::size_t> place = numbers.names().find(name.side, name.name);
      values.push_back(place ? numbers.values()[*place] : std::numeric_limits<double>::quiet_NaN());
    }
    write(row, number_bytes(values));
  }

  void reset() {
    if (rows_) rows_->reset();
  }

 private:
  static std::int64_t checksum_of(std::int64_t row, std::string_view numbers) {
    return RowChecksum().whole(row).bytes(numbers).value();
  }
  static std::shared_ptr<const match::MetricNames> names() {
    std::vector<match::MetricName> out;
    for (const char* const name : match::packet_metrics) {
      for (const match::Side side : match::both_sides) out.push_back({.side = side, .name = name});
    }
    return std::make_shared<const match::MetricNames>(std::move(out));
  }

  std::optional<RowsInOrder> rows_;  // empty: the file lacks this table
  std::optional<SQLite::Statement> insert_;
  std::shared_ptr<const match::MetricNames> names_ = names();
};

MatchKey key_of(SQLite::Statement& row) {
  return {row.getColumn(1).getInt64(), std::bit_cast<std::uint64_t>(row.getColumn(2).getInt64())};
}

std::int64_t checksum_of(std::int64_t row, const MatchKey& key, const MatchResult& decided, const std::string& failure,
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

// Returns the kinds in the table remarks, each with the member of `decided` that holds the text.
std::array<std::pair<const char*, std::string*>, 7> remarks_of(MatchResult& decided) {
  return {{{"set_aside", &decided.why_set_aside},
           {"irreproducible", &decided.irreproducible},
           {"shared", &decided.shared},
           {"broken", &decided.broken},
           {"kept", &decided.kept},
           {"unproven", &decided.unproven},
           {"output", &decided.output}}};
}

std::string select_where(const char* condition) {
  return fmt::format("SELECT {} FROM matches WHERE {}", columns, condition);
}

// Maps the id of metric names in another file to the id of the same names in this file.
using NameNumbers = std::map<std::int64_t, std::int64_t>;

}  // namespace

struct StoredMatches::Impl {
  Impl(SQLite::Database& in, bool written_to)
      : database(in),
        metrics(in, written_to),
        packets(in, written_to),
        in_order(in, fmt::format("{} FROM matches", columns)),
        by_key(in, select_where("fixture = ? AND seed = ?")),
        remarks(in, "SELECT kind, text, checksum FROM remarks WHERE row = ?"),
        any_remarks(in.execAndGet("SELECT EXISTS(SELECT 1 FROM remarks)").getInt() != 0) {
    if (!written_to) return;
    insert.emplace(in, fmt::format("INSERT INTO matches({}) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", columns));
    insert_new.emplace(
        in, fmt::format("INSERT OR IGNORE INTO matches({}) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", columns));
    insert_remark.emplace(in, "INSERT INTO remarks(row, kind, text, checksum) VALUES(?, ?, ?, ?)");
  }

  MatchResult decided_of(SQLite::Statement& cursor, Metrics wanted) {
    const std::int64_t row = cursor.getColumn(0).getInt64();
    const MatchKey key = key_of(cursor);
    MatchResult out;
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
    if (!failure.empty()) out.failure = reading_row(row, "", [&] { return failure_from_json(failure); });
    if (any_remarks) read_remarks(row, out);
    if ((out.ended == "set_aside") != out.set_aside()) throw DamagedRow(row, "a match set aside without a reason");
    if (wanted != Metrics::left_out && !out.hash.empty()) out.metrics = numbers_of(row, wanted);
    return out;
  }

  // Precondition: the match was played to its end.
  match::MetricNumbers numbers_of(std::int64_t row, Metrics wanted) {
    if (wanted == Metrics::packets) {
      if (auto found = packets.read(row)) return *std::move(found);
    }
    match::MetricNumbers out = metrics.read(row);
    if (out.empty()) throw DamagedRow(row, "its metrics are missing");
    return out;
  }

  std::optional<MatchResult> by_its_key(const MatchKey& key, Metrics wanted) {
    by_key.tryReset();
    by_key.bind(1, key.fixture);
    by_key.bind(2, std::bit_cast<std::int64_t>(key.seed));
    if (!by_key.executeStep()) return std::nullopt;
    MatchResult out = decided_of(by_key, wanted);
    by_key.reset();
    return out;
  }

  // Writes a match without its metrics. Returns false if `statement` ignored a match that is stored already.
  bool put(SQLite::Statement& statement, std::int64_t row, const MatchKey& key, const MatchResult& decided,
           std::int64_t attempts) {
    const std::string failure = decided.failure ? to_json(*decided.failure) : std::string();
    const bool added =
        campaign::put(statement, row, key.fixture, std::bit_cast<std::int64_t>(key.seed), decided.score[0],
                      decided.score[1], decided.ended, or_null(decided.hash), or_null(failure), decided.seconds,
                      attempts, checksum_of(row, key, decided, failure, attempts));
    if (added) write_remarks(row, decided);
    return added;
  }

  // Copies the match in the current row of `cursor`, a statement of `other`. Throws OtherFile. Throws DamagedRow if the
  // match must be refused.
  void take(Impl& other, SQLite::Statement& cursor, const FixtureNumbers& fixtures, NameNumbers& names, Taken& out) {
    std::int64_t row = 0, attempts = 0;
    MatchKey theirs;
    MatchResult decided;
    std::optional<StoredMetrics::Packed> numbers;
    std::optional<std::string_view> spent;
    std::optional<std::string> text;  // text of the metric names, if the names are new
    reading_other([&] {
      row = cursor.getColumn(0).getInt64();
      theirs = key_of(cursor);
      attempts = cursor.getColumn(9).getInt64();
      decided = other.decided_of(cursor, Metrics::left_out);
      if (decided.hash.empty()) return;
      numbers = other.metrics.packed(row);
      if (!numbers) throw DamagedRow(row, "its metrics are missing");
      spent = other.packets.packed(row);
      if (names.contains(numbers->names)) return;
      text = reading_row(row, "metrics: ", [&] { return other.metrics.text_of_names(numbers->names); });
    });
    const auto fixture = fixtures.find(theirs.fixture);
    if (fixture == fixtures.end()) throw DamagedRow(row, "nothing like it was planned");
    const MatchKey key{fixture->second, theirs.seed};
    if (text) {
      names.emplace(numbers->names, reading_row(row, "metrics: ", [&] { return metrics.number_of_names(*text); }));
    }
    if (put(*insert_new, row, key, decided, attempts)) {
      if (numbers) metrics.write(row, {names.at(numbers->names), numbers->size, numbers->frame});
      if (spent) packets.write(row, *spent);
      ++out.rows;
      return;
    }
    std::optional<MatchResult> ours;
    try {
      ours = by_its_key(key, Metrics::left_out);
    } catch (const DamagedRow& error) {  // the damaged row is in this file, not in the other file
      throw std::invalid_argument(fmt::format("match {}: {}", error.row, error.what()));
    }
    if (!ours) throw DamagedRow(row, "its row holds another match");
    // A forfeit has no hash and contradicts no result, because a team may be too slow on only one machine.
    if (ours->hash != decided.hash && !ours->hash.empty() && !decided.hash.empty()) {
      throw DamagedRow(row, fmt::format("the same match has the hash {} there and {} here", decided.hash, ours->hash));
    }
    ++out.known;
  }

  void read_remarks(std::int64_t row, MatchResult& out) {
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

  void write_remarks(std::int64_t row, MatchResult decided) {
    for (const auto& [name, text] : remarks_of(decided)) {
      if (text->empty()) continue;
      campaign::put(*insert_remark, row, name, *text, RowChecksum().whole(row).bytes(name).bytes(*text).value());
      any_remarks = true;
    }
  }

  SQLite::Database& database;
  StoredMetrics metrics;
  Packets packets;
  RowsInOrder in_order;
  SQLite::Statement by_key, remarks;
  std::optional<SQLite::Statement> insert, insert_new, insert_remark;
  bool any_remarks;
};

std::string StoredMatches::tables() { return std::string(own_tables) + StoredMetrics::tables + Packets::table; }

StoredMatches::StoredMatches(SQLite::Database& database, bool written_to)
    : parts_(std::make_unique<Impl>(database, written_to)) {}
StoredMatches::~StoredMatches() = default;

std::optional<MatchResult> StoredMatches::find(std::int64_t row, const MatchKey& key, Metrics metrics) {
  if (SQLite::Statement* const first = parts_->in_order.at(row)) {
    const bool wanted = key_of(*first) == key;
    // If `wanted` is false, the row holds another match, or its key is damaged. For a damaged key, decided_of() throws.
    MatchResult found = parts_->decided_of(*first, wanted ? metrics : Metrics::left_out);
    if (wanted) return found;
  }
  return parts_->by_its_key(key, metrics);
}

std::optional<StoredMatches::Row> StoredMatches::row(std::int64_t row) {
  SQLite::Statement* const found = parts_->in_order.at(row);
  if (found == nullptr) return std::nullopt;
  Row out{key_of(*found), parts_->decided_of(*found, Metrics::wanted)};
  parts_->in_order.reset();
  return out;
}

std::int64_t StoredMatches::rows() { return parts_->database.execAndGet("SELECT count(*) FROM matches").getInt64(); }

std::optional<std::int64_t> StoredMatches::first_not_planned(
    std::int64_t from, std::int64_t to, const std::function<bool(std::int64_t, const MatchKey&)>& planned) {
  SQLite::Statement each(parts_->database,
                         "SELECT row, fixture, seed FROM matches WHERE row BETWEEN ? AND ? ORDER BY row");
  each.bind(1, from);
  each.bind(2, to);
  while (each.executeStep()) {
    const std::int64_t place = each.getColumn(0).getInt64();
    if (planned(place, key_of(each))) continue;
    row(place);  // throws if the row is damaged
    return place;
  }
  return std::nullopt;
}

match::MetricPaths StoredMatches::metric_paths(std::int64_t rows) { return parts_->metrics.paths(rows); }

void StoredMatches::insert(std::int64_t row, const MatchKey& key, const MatchResult& decided, int attempts) {
  parts_->put(*parts_->insert, row, key, decided, attempts);
  if (decided.metrics.empty()) return;
  parts_->metrics.write(row, decided.metrics);
  parts_->packets.write(row, decided.metrics);
}

Taken StoredMatches::take(StoredMatches& other, const FixtureNumbers& fixtures) {
  Taken out;
  const auto refuse = [&out](const std::string& why) {
    ++out.refused;
    if (out.why.size() < most_reasons) out.why.push_back(why);
  };
  NameNumbers names;
  SQLite::Statement each(other.parts_->database, select_where("row > 0 ORDER BY row"));
  for (;;) {
    try {
      if (!reading_other([&] { return each.executeStep(); })) return out;
      parts_->take(*other.parts_, each, fixtures, names, out);
    } catch (const DamagedRow& error) {
      refuse(fmt::format("match {}: {}", error.row, error.what()));
    } catch (const OtherFile& error) {  // rows before the error stay copied
      refuse(fmt::format("the rest cannot be read: {}", error.what()));
      return out;
    }
  }
}

std::vector<std::int64_t> StoredMatches::damaged_rows() {
  std::vector<std::int64_t> out;
  SQLite::Statement each(parts_->database, "SELECT row FROM matches ORDER BY row");
  while (each.executeStep()) {
    const std::int64_t place = each.getColumn(0).getInt64();
    try {
      row(place);
      parts_->packets.read(place);
    } catch (const DamagedRow&) {
      out.push_back(place);
    }
  }
  return out;
}

void StoredMatches::reset() {
  parts_->in_order.reset();
  parts_->by_key.tryReset();
  parts_->metrics.reset();
  parts_->packets.reset();
  parts_->remarks.tryReset();
}

}  // namespace regista::campaign
