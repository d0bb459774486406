// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "campaign/row_checksum.hpp"
#include "campaign/stored_metrics.hpp"

namespace regista::campaign {
namespace {

constexpr int application = 0x52475354;  // "RGST": tells our files from those of other programs
constexpr int most_goals = 100'000;      // of a row that can be believed
constexpr int patience = 5000;           // ms to wait for somebody who is writing
constexpr auto tables = R"(
  CREATE TABLE meta(name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE fixtures(
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE,
    job TEXT NOT NULL,
    checksum INTEGER NOT NULL
  );
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
constexpr auto gone = "the file is no longer there, or is another one, so nothing more can be kept";
constexpr auto columns =
    "row, fixture, seed, home_goals, away_goals, ended, hash, failure, seconds, attempts, checksum";
constexpr std::size_t most_named = 10;  // damaged rows

// What a name leads to.
struct Identity {
  dev_t device = 0;
  ino_t number = 0;
  friend bool operator==(const Identity&, const Identity&) = default;
};

std::optional<Identity> identity_of(const std::string& name) {
  struct stat about {};
  if (::stat(name.c_str(), &about) != 0) return std::nullopt;
  return Identity{about.st_dev, about.st_ino};
}

// Before it is opened: a pipe would wait for ever.
void refuse_what_is_no_file(const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw StoreRefusal(std::filesystem::is_directory(status)
                         ? fmt::format("{} is a folder, not a file of results", file.string())
                         : fmt::format("{} is no ordinary file, so it holds no results", file.string()));
}

// Held from before the database is opened until after it is closed: closing any descriptor of a file gives up the
// locks that SQLite itself has on it.
class Hold {
 public:
  Hold(const std::filesystem::path& file, bool create) {
    const int flags = O_RDWR | O_CLOEXEC | (create ? O_CREAT | O_EXCL : 0);
    descriptor_ = open(file.c_str(), flags, 0666);
    if (descriptor_ == -1 && errno == EEXIST) {
      throw StoreRefusal(
          fmt::format("{} exists already; --resume continues it, --results names another", file.string()));
    }
    if (descriptor_ == -1) {
      throw StoreRefusal(fmt::format("cannot write results to {}: {}", file.string(), std::strerror(errno)));
    }
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int error = errno;
    close(descriptor_);
    throw StoreRefusal(error == EWOULDBLOCK ? fmt::format("{} is in use by another process", file.string())
                                            : fmt::format("cannot lock {}: {}", file.string(), std::strerror(error)));
  }
  ~Hold() { close(descriptor_); }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

 private:
  int descriptor_ = -1;
};

std::string reason(const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "locked by another process";
    case SQLITE_NOTADB:
      return "is no database";
    case SQLITE_FULL:
      return "the disk is full";
    case SQLITE_IOERR:
      if (error.getExtendedErrorCode() == SQLITE_IOERR_SHMSIZE) return "the disk is full";
      return error.what();
    default:
      return error.what();
  }
}

bool is_of_the_disk(const SQLite::Exception& error) {
  return error.getErrorCode() == SQLITE_FULL || error.getErrorCode() == SQLITE_IOERR;
}

void bind_or_null(SQLite::Statement& statement, int index, const std::string& text) {
  if (text.empty())
    statement.bind(index);
  else
    statement.bindNoCopy(index, text);
}

// Also for what stands in the file but was not written by this program.
template <class Parts, class Work>
auto guarded(Parts& parts, Work work) {
  const auto about = [&](const SQLite::Exception& error) {
    return fmt::format("results in {}: {}", parts.file, reason(error));
  };
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    if (is_of_the_disk(error)) throw StoreDiskError(about(error));
    throw StoreError(about(error));
  } catch (const DamagedRow& row) {
    std::string text;
    try {
      text = parts.damage(row);
    } catch (const SQLite::Exception& error) {
      text = about(error);
    }
    throw StoreDamaged(text);
  } catch (const std::invalid_argument& error) {
    throw StoreDamaged(fmt::format("results in {} are damaged: {}", parts.file, error.what()));
  }
}

std::string text_of(const SQLite::Column& column) { return column.isNull() ? std::string() : column.getString(); }

}  // namespace

struct Store::Parts {
  Parts(const std::filesystem::path& path, Mode mode, const std::string& version)
      : file(path.string()), hold(held(path, mode)), database(open_database(path, mode)) {
    try {
      prepare(mode, version);
      identity = identity_of(file);
    } catch (const SQLite::Exception& error) {
      const std::string text = fmt::format("{}: {}", file, reason(error));
      if (mode == Mode::read || !is_of_the_disk(error)) throw StoreRefusal(text);
      if (mode == Mode::create) std::filesystem::remove(path);  // ours, and nothing is in it
      throw StoreDiskError("cannot write results to " + text);
    }
  }

  static std::unique_ptr<const Hold> held(const std::filesystem::path& path, Mode mode) {
    if (mode != Mode::create) refuse_what_is_no_file(path);
    if (mode != Mode::read) return std::make_unique<const Hold>(path, mode == Mode::create);
    if (const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC); descriptor != -1) {
      close(descriptor);  // before SQLite has locks on it
    } else {
      throw StoreRefusal(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    }
    return nullptr;
  }

  static SQLite::Database open_database(const std::filesystem::path& path, Mode mode) {
    try {
      // A file in the current folder may be called ":memory:", which SQLite takes for no file at all.
      const std::string name = std::filesystem::absolute(path).string();
      if (mode != Mode::read) return {name, SQLite::OPEN_READWRITE, patience};
      // A log beside it holds what was written last. Where there is none nobody writes, and none need be made.
      if (std::filesystem::exists(name + "-wal")) return {name, SQLite::OPEN_READONLY, patience};
      return {"file:" + in_address(name) + "?immutable=1", SQLite::OPEN_READONLY | SQLite::OPEN_URI, patience};
    } catch (const SQLite::Exception& error) {
      throw StoreRefusal(fmt::format("cannot open {}: {}", path.string(), reason(error)));
    }
  }

  // What would mean something in an address of a file.
  static std::string in_address(const std::string& path) {
    std::string out;
    for (const char c : path) {
      if (c == '%' || c == '?' || c == '#')
        out += fmt::format("%{:02x}", static_cast<int>(c));
      else
        out += c;
    }
    return out;
  }

  int pragma(const char* name) { return database.execAndGet(fmt::format("PRAGMA {}", name)).getInt(); }

  void prepare(Mode mode, const std::string& version) {
    if (mode == Mode::create) begin(version);
    // Killed between the creation of the file and that of its tables: as good as new.
    const bool blank = pragma("application_id") == 0 && pragma("page_count") == 0;
    if (mode == Mode::open && blank) begin(version);
    if (mode == Mode::read && blank) throw StoreRefusal(fmt::format("{} holds no results yet", file));
    if (pragma("application_id") != application) {
      throw StoreRefusal(fmt::format("{} is a database of another program, not results of Regista", file));
    }
    const int schema = pragma("user_version");
    if (schema != store_schema) {
      const std::string by = database.tableExists("meta") ? text_in_meta("program") : "";
      throw StoreRefusal(fmt::format("{} was written by {} Regista{}: its schema is {}, this program reads {}", file,
                                     schema > store_schema ? "a newer" : "an older", by.empty() ? "" : ", " + by,
                                     schema, store_schema));
    }
    by_row.emplace(database, fmt::format("SELECT {} FROM matches WHERE row = ?", columns));
    by_key.emplace(database, fmt::format("SELECT {} FROM matches WHERE fixture = ? AND seed = ?", columns));
    metrics.emplace(database, mode != Mode::read);
    remarks.emplace(database, "SELECT kind, text, checksum FROM remarks WHERE row = ?");
    any_remarks = database.execAndGet("SELECT EXISTS(SELECT 1 FROM remarks)").getInt() != 0;
    if (mode == Mode::read) return;
    database.exec("PRAGMA journal_mode=WAL");
    database.exec("PRAGMA synchronous=NORMAL");
    insert.emplace(database, fmt::format("INSERT INTO matches({}) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", columns));
    insert_remark.emplace(database, "INSERT INTO remarks(row, kind, text, checksum) VALUES(?, ?, ?, ?)");
  }

  void begin(const std::string& version) {
    SQLite::Transaction transaction(database);
    database.exec(tables);
    database.exec(StoredMetrics::tables);
    database.exec(fmt::format("PRAGMA application_id={}", application));
    database.exec(fmt::format("PRAGMA user_version={}", store_schema));
    SQLite::Statement insert_version(database, "INSERT INTO meta VALUES('program', ?)");
    insert_version.bind(1, version);
    insert_version.exec();
    transaction.commit();
  }

  std::string text_in_meta(const std::string& name) {
    SQLite::Statement select(database, "SELECT value FROM meta WHERE name = ?");
    select.bindNoCopy(1, name);
    return select.executeStep() ? select.getColumn(0).getString() : std::string();
  }

  // The match under the cursor of by_row or by_key.
  static MatchKey key_of(SQLite::Statement& row) {
    return {row.getColumn(1).getInt64(), std::bit_cast<std::uint64_t>(row.getColumn(2).getInt64())};
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
      out.metrics = metrics->read(row);
      if (out.metrics.empty()) throw DamagedRow(row, "its metrics are missing");
    }
    cursor.reset();
    return out;
  }

  static std::int64_t checksum_of(std::int64_t row, const MatchKey& key, const Decided& decided,
                                  const std::string& failure, std::int64_t attempts) {
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

  // Once: one whose key is damaged would not be found, and its matches would count as not played.
  void check_fixtures() {
    if (std::exchange(fixtures_checked, true)) return;
    SQLite::Statement each(database, "SELECT id, key, job, checksum FROM fixtures");
    while (each.executeStep()) {
      const std::string key = each.getColumn(1).getString(), job = each.getColumn(2).getString();
      if (RowChecksum().bytes(key).bytes(job).value() == each.getColumn(3).getInt64()) continue;
      throw std::invalid_argument(fmt::format("the checksum of fixture {} does not fit", each.getColumn(0).getInt64()));
    }
  }

  void read_remarks(std::int64_t row, Decided& out) {
    remarks->tryReset();
    remarks->bind(1, row);
    while (remarks->executeStep()) {
      const std::string kind = remarks->getColumn(0).getString(), said = remarks->getColumn(1).getString();
      if (RowChecksum().whole(row).bytes(kind).bytes(said).value() != remarks->getColumn(2).getInt64()) {
        throw DamagedRow(row, "the checksum of a remark does not fit");
      }
      for (const auto& [name, text] : remarks_of(out)) {
        if (kind == name) *text = said;
      }
    }
    remarks->reset();
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

  // All matches that cannot be read, by their rows.
  std::vector<std::int64_t> damaged_rows() {
    std::vector<std::int64_t> out;
    SQLite::Statement each(database, fmt::format("SELECT {} FROM matches ORDER BY row", columns));
    while (each.executeStep()) {
      const std::int64_t row = each.getColumn(0).getInt64();
      SQLite::Statement one(database, fmt::format("SELECT {} FROM matches WHERE row = ?", columns));
      one.bind(1, row);
      one.executeStep();
      try {
        decided_of(one, Metrics::wanted);
      } catch (const DamagedRow&) {
        out.push_back(row);
      }
    }
    return out;
  }

  // What is said of one of them: which one, why, and how many there are.
  std::string damage(const DamagedRow& found) {
    std::string out = fmt::format("results in {} are damaged: match {}: {}", file, found.row(), found.what());
    std::vector<std::int64_t> others = damaged_rows();
    std::erase(others, found.row());
    if (others.empty()) return out;
    const std::size_t named = std::min(others.size(), most_named);
    out += fmt::format("; {} {} cannot be read either", others.size() == 1 ? "match" : "matches",
                       fmt::join(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(named), ", "));
    return named == others.size() ? out : out + fmt::format(", nor can {} more", others.size() - named);
  }

  static std::array<std::pair<const char*, std::string*>, 3> remarks_of(Decided& decided) {
    return {{{"set_aside", &decided.why_set_aside},
             {"irreproducible", &decided.irreproducible},
             {"output", &decided.output}}};
  }

  static void bind(SQLite::Statement& statement, const MatchKey& key) {
    statement.bind(1, key.fixture);
    statement.bind(2, std::bit_cast<std::int64_t>(key.seed));
  }

  // What is written to a file that nobody finds by its name is lost, and so is a log that was deleted should we die.
  // The log is there from the first row that is written on.
  void require_file() {
    if (identity_of(file) != identity) throw StoreGone(fmt::format("results in {}: {}", file, gone));
    const std::string log = file + "-wal";
    if (log_identity && identity_of(log) != log_identity) throw StoreGone(fmt::format("results in {}: {}", log, gone));
    log_identity = identity_of(log);
  }

  // All that is read between two rows written is read in one transaction: without one, SQLite locks and unlocks the
  // file for every single row.
  void begin_reading() {
    if (std::exchange(reading, true)) return;
    database.exec("BEGIN");
  }
  void end_reading() {
    if (!std::exchange(reading, false)) return;
    by_row->tryReset();
    by_key->tryReset();
    metrics->reset();
    remarks->tryReset();
    database.exec("COMMIT");
  }

  std::string file;
  std::optional<Identity> identity, log_identity;
  std::unique_ptr<const Hold> hold;
  SQLite::Database database;
  std::optional<StoredMetrics> metrics;
  std::optional<SQLite::Statement> by_row, by_key, remarks, insert, insert_remark;
  bool any_remarks = false, fixtures_checked = false;
  bool reading = false;
};

Store::Store(const std::filesystem::path& file, Mode mode, const std::string& program_version)
    : parts_(std::make_unique<Parts>(file, mode, program_version)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

std::string Store::meta(const std::string& name) const {
  return guarded(*parts_, [&] { return parts_->text_in_meta(name); });
}

void Store::set_meta(const std::string& name, const std::string& value) {
  guarded(*parts_, [&] {
    parts_->end_reading();
    SQLite::Statement put(parts_->database, "INSERT OR REPLACE INTO meta VALUES(?, ?)");
    put.bindNoCopy(1, name);
    put.bindNoCopy(2, value);
    put.exec();
  });
}

std::vector<std::int64_t> Store::numbers(std::span<const std::string> keys) const {
  return guarded(*parts_, [&] {
    parts_->check_fixtures();
    std::vector<std::int64_t> out;
    SQLite::Statement select(parts_->database, "SELECT id FROM fixtures WHERE key = ?");
    for (const std::string& key : keys) {
      select.bindNoCopy(1, key);
      out.push_back(select.executeStep() ? select.getColumn(0).getInt64() : 0);
      select.reset();
    }
    return out;
  });
}

std::vector<std::int64_t> Store::add(std::span<const Fixture> fixtures) {
  guarded(*parts_, [&] {
    parts_->end_reading();
    SQLite::Transaction transaction(parts_->database);
    SQLite::Statement add(parts_->database, "INSERT OR IGNORE INTO fixtures(key, job, checksum) VALUES(?, ?, ?)");
    for (const Fixture& fixture : fixtures) {
      const std::string job = to_json(fixture.job);
      add.bindNoCopy(1, fixture.key);
      add.bindNoCopy(2, job);
      add.bind(3, RowChecksum().bytes(fixture.key).bytes(job).value());
      add.exec();
      add.reset();
    }
    transaction.commit();
  });
  std::vector<std::string> keys;
  for (const Fixture& fixture : fixtures) keys.push_back(fixture.key);
  return numbers(keys);
}

std::optional<Decided> Store::find(std::int64_t row, const MatchKey& key, Metrics metrics) const {
  return guarded(*parts_, [&]() -> std::optional<Decided> {
    parts_->begin_reading();
    SQLite::Statement& first = *parts_->by_row;
    first.tryReset();
    first.bind(1, row);
    if (first.executeStep()) {
      const bool wanted = Parts::key_of(first) == key;
      // Another match stands there, or its key is damaged.
      Decided found = parts_->decided_of(first, wanted ? metrics : Metrics::left_out);
      if (wanted) return found;
    }
    SQLite::Statement& second = *parts_->by_key;
    second.tryReset();
    Parts::bind(second, key);
    if (!second.executeStep()) return std::nullopt;
    return parts_->decided_of(second, metrics);
  });
}

void Store::insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts) {
  guarded(*parts_, [&] {
    parts_->require_file();
    const std::string failure = decided.failure ? to_json(*decided.failure) : std::string();
    parts_->end_reading();
    SQLite::Transaction transaction(parts_->database);
    SQLite::Statement& insert = *parts_->insert;
    insert.tryReset();  // reset would tell once more of what went wrong last time
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
    insert.bind(11, Parts::checksum_of(row, key, decided, failure, attempts));
    insert.exec();
    insert.reset();
    if (!decided.metrics.empty()) parts_->metrics->write(row, decided.metrics);
    parts_->write_remarks(row, decided);
    transaction.commit();
  });
}

std::optional<Store::Row> Store::row(std::int64_t row) const {
  return guarded(*parts_, [&]() -> std::optional<Row> {
    SQLite::Statement& select = *parts_->by_row;
    select.tryReset();
    select.bind(1, row);
    if (!select.executeStep()) return std::nullopt;
    const MatchKey key = Parts::key_of(select);
    Row out;
    out.decided = parts_->decided_of(select, Metrics::wanted);
    SQLite::Statement fixture(parts_->database, "SELECT key, job, checksum FROM fixtures WHERE id = ?");
    fixture.bind(1, key.fixture);
    if (!fixture.executeStep()) throw DamagedRow(row, "what was to be played is missing");
    const std::string name = fixture.getColumn(0).getString(), job = fixture.getColumn(1).getString();
    if (RowChecksum().bytes(name).bytes(job).value() != fixture.getColumn(2).getInt64()) {
      throw DamagedRow(row, "the checksum of what was to be played does not fit");
    }
    try {
      out.job = job_from_json(job);
    } catch (const std::invalid_argument& error) {
      throw DamagedRow(row, error.what());
    }
    out.job.seed = key.seed;
    return out;
  });
}

std::vector<std::string> Store::metric_paths(std::int64_t rows) const {
  return guarded(*parts_, [&] { return parts_->metrics->paths(rows); });
}

void Store::require_file() const { parts_->require_file(); }

std::int64_t Store::rows() const {
  return guarded(*parts_, [&] { return parts_->database.execAndGet("SELECT count(*) FROM matches").getInt64(); });
}

}  // namespace regista::campaign
