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
#include "campaign/rows_in_order.hpp"
#include "campaign/stored_metrics.hpp"
#include "campaign/stored_packets.hpp"

namespace regista::campaign {
namespace {

// Where matches are taken over from one file of results into another, an error of the database may be of either; this
// is one of the file that is read.
class OtherFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  // Does `work`, which reads the other file. Throws OtherFile for SQLite::Exception, and what else `work` throws.
  template <class Work>
  static auto reading(Work work) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw OtherFile(error.what());
    }
  }
};

constexpr int most_goals = 100'000;  // of a row that can be believed
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

void bind_or_null(SQLite::Statement& statement, int index, const std::string& text) {
  if (text.empty())
    statement.bind(index);
  else
    statement.bindNoCopy(index, text);
}

std::string text_of(const SQLite::Column& column) { return column.isNull() ? std::string() : column.getString(); }

// The match under a cursor.
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
std::array<std::pair<const char*, std::string*>, 7> remarks_of(Decided& decided) {
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

// Numbers of names of metrics in this file, by those in another.
using NameNumbers = std::map<std::int64_t, std::int64_t>;

}  // namespace

struct StoredMatches::Parts {
  Parts(SQLite::Database& in, bool written_to)
      : database(in),
        metrics(in, written_to),
        packets(in, written_to),
        by_row(in, select_where("row = ?")),
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
    if (wanted != Metrics::left_out && !out.hash.empty()) out.metrics = numbers_of(row, wanted);
    return out;
  }

  // Of a match played to its end.
  match::MetricNumbers numbers_of(std::int64_t row, Metrics wanted) {
    if (wanted == Metrics::packets) {
      if (auto found = packets.read(row)) return *std::move(found);
    }
    match::MetricNumbers out = metrics.read(row);
    if (out.empty()) throw DamagedRow(row, "its metrics are missing");
    return out;
  }

  std::optional<Decided> by_its_key(const MatchKey& key, Metrics wanted) {
    by_key.tryReset();
    by_key.bind(1, key.fixture);
    by_key.bind(2, std::bit_cast<std::int64_t>(key.seed));
    if (!by_key.executeStep()) return std::nullopt;
    Decided out = decided_of(by_key, wanted);
    by_key.reset();
    return out;
  }

  // With all but its metrics. Whether it was added, which `statement` decides.
  bool put(SQLite::Statement& statement, std::int64_t row, const MatchKey& key, const Decided& decided,
           std::int64_t attempts) {
    const std::string failure = decided.failure ? to_json(*decided.failure) : std::string();
    statement.tryReset();  // reset would report once more what went wrong last time
    statement.bind(1, row);
    statement.bind(2, key.fixture);
    statement.bind(3, std::bit_cast<std::int64_t>(key.seed));
    statement.bind(4, decided.score[0]);
    statement.bind(5, decided.score[1]);
    statement.bindNoCopy(6, decided.ended);
    bind_or_null(statement, 7, decided.hash);
    bind_or_null(statement, 8, failure);
    statement.bind(9, decided.seconds);
    statement.bind(10, attempts);
    statement.bind(11, checksum_of(row, key, decided, failure, attempts));
    const bool added = statement.exec() == 1;
    statement.reset();
    if (added) write_remarks(row, decided);
    return added;
  }

  std::int64_t number_of_names(std::int64_t row, const std::string& text) {
    try {
      return metrics.number_of_names(text);
    } catch (const std::invalid_argument& error) {
      throw DamagedRow(row, std::string("metrics: ") + error.what());
    }
  }

  // The match under `cursor` of another file. Throws DamagedRow for one that does not fit, OtherFile.
  void take(Parts& other, SQLite::Statement& cursor, const FixtureNumbers& fixtures, NameNumbers& names, Taken& out) {
    std::int64_t row = 0, attempts = 0;
    MatchKey theirs;
    Decided decided;
    std::optional<StoredMetrics::Packed> numbers;
    std::optional<std::string_view> spent;
    std::optional<std::string> text;  // of their names, where they are new
    OtherFile::reading([&] {
      row = cursor.getColumn(0).getInt64();
      theirs = key_of(cursor);
      attempts = cursor.getColumn(9).getInt64();
      decided = other.decided_of(cursor, Metrics::left_out);
      if (decided.hash.empty()) return;
      numbers = other.metrics.packed(row);
      spent = other.packets.packed(row);
      if (!names.contains(numbers->names)) text = other.metrics.text_of_names(row, numbers->names);
    });
    const auto fixture = fixtures.find(theirs.fixture);
    if (fixture == fixtures.end()) throw DamagedRow(row, "nothing like it was planned");
    const MatchKey key{fixture->second, theirs.seed};
    if (text) names.emplace(numbers->names, number_of_names(row, *text));
    if (put(*insert_new, row, key, decided, attempts)) {
      if (numbers) metrics.write(row, *numbers, names.at(numbers->names));
      if (spent) packets.write(row, *spent);
      ++out.rows;
      return;
    }
    std::optional<Decided> ours;
    try {
      ours = by_its_key(key, Metrics::left_out);
    } catch (const DamagedRow& error) {  // here, not there
      throw std::invalid_argument(fmt::format("match {}: {}", error.row(), error.what()));
    }
    if (!ours) throw DamagedRow(row, "its row holds another match");
    // Who forfeits for want of time may not do so elsewhere.
    if (ours->hash != decided.hash && !ours->hash.empty() && !decided.hash.empty()) {
      throw DamagedRow(row, fmt::format("the same match has the hash {} there and {} here", decided.hash, ours->hash));
    }
    ++out.known;
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
  StoredPackets packets;
  SQLite::Statement by_row;
  RowsInOrder in_order;
  SQLite::Statement by_key, remarks;
  std::optional<SQLite::Statement> insert, insert_new, insert_remark;
  bool any_remarks;
};

std::string StoredMatches::tables() { return std::string(own_tables) + StoredMetrics::tables + StoredPackets::table; }

StoredMatches::StoredMatches(SQLite::Database& database, bool written_to)
    : parts_(std::make_unique<Parts>(database, written_to)) {}
StoredMatches::~StoredMatches() = default;

std::optional<Decided> StoredMatches::find(std::int64_t row, const MatchKey& key, Metrics metrics) {
  if (SQLite::Statement* const first = parts_->in_order.at(row)) {
    const bool wanted = key_of(*first) == key;
    // Another match stands there, or its key is damaged.
    Decided found = parts_->decided_of(*first, wanted ? metrics : Metrics::left_out);
    if (wanted) return found;
  }
  return parts_->by_its_key(key, metrics);
}

std::optional<StoredMatches::Row> StoredMatches::row(std::int64_t row) {
  SQLite::Statement& select = parts_->by_row;
  select.tryReset();
  select.bind(1, row);
  if (!select.executeStep()) return std::nullopt;
  const MatchKey key = key_of(select);
  Row out{key, parts_->decided_of(select, Metrics::wanted)};
  select.reset();
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
    row(place);  // it may be damaged
    return place;
  }
  return std::nullopt;
}

match::MetricPaths StoredMatches::metric_paths(std::int64_t rows) { return parts_->metrics.paths(rows); }

void StoredMatches::insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts) {
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
      if (!OtherFile::reading([&] { return each.executeStep(); })) return out;
      parts_->take(*other.parts_, each, fixtures, names, out);
    } catch (const DamagedRow& error) {
      refuse(fmt::format("match {}: {}", error.row(), error.what()));
    } catch (const OtherFile& error) {  // what was read before it is sound
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
  parts_->by_row.tryReset();
  parts_->in_order.reset();
  parts_->by_key.tryReset();
  parts_->metrics.reset();
  parts_->packets.reset();
  parts_->remarks.tryReset();
}

}  // namespace regista::campaign
