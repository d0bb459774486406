// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>

namespace regista::campaign {
namespace {

constexpr int application = 0x52475354;  // "RGST": tells our files from those of other programs
constexpr int patience = 5000;           // ms to wait for somebody who is writing
constexpr auto tables = R"(
  CREATE TABLE meta(name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE fixtures(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, description TEXT NOT NULL);
  CREATE TABLE matches(
    row INTEGER PRIMARY KEY,
    fixture INTEGER NOT NULL REFERENCES fixtures(id),
    seed INTEGER NOT NULL,
    home_goals INTEGER NOT NULL,
    away_goals INTEGER NOT NULL,
    ended TEXT NOT NULL,
    hash TEXT,
    metrics TEXT,
    failure TEXT,
    seconds REAL NOT NULL,
    attempts INTEGER NOT NULL,
    UNIQUE(fixture, seed)
  );)";

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
    default:
      return error.what();
  }
}

template <class Work>
auto guarded(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw StoreError(fmt::format("results in {}: {}", file, reason(error)));
  }
}

void bind_or_null(SQLite::Statement& statement, int index, const std::string& text) {
  if (text.empty())
    statement.bind(index);
  else
    statement.bindNoCopy(index, text);
}

std::string text_of(const SQLite::Column& column) { return column.isNull() ? std::string() : column.getString(); }

}  // namespace

struct Store::Parts {
  Parts(const std::filesystem::path& path, bool create, const std::string& version)
      : file(path.string()), hold(path, create), database(open_database(path)) {
    try {
      prepare(create, version);
    } catch (const SQLite::Exception& error) {
      throw StoreRefusal(fmt::format("{}: {}", file, reason(error)));
    }
  }

  static SQLite::Database open_database(const std::filesystem::path& path) {
    try {
      return {path.string(), SQLite::OPEN_READWRITE, patience};
    } catch (const SQLite::Exception& error) {
      throw StoreRefusal(fmt::format("cannot open {}: {}", path.string(), reason(error)));
    }
  }

  int pragma(const char* name) { return database.execAndGet(fmt::format("PRAGMA {}", name)).getInt(); }

  void prepare(bool create, const std::string& version) {
    if (create) begin(version);
    // Killed between the creation of the file and that of its tables: as good as new.
    if (!create && pragma("application_id") == 0 && pragma("page_count") == 0) begin(version);
    if (pragma("application_id") != application) {
      throw StoreRefusal(fmt::format("{} is a database of another program, not results of Regista", file));
    }
    const int schema = pragma("user_version");
    if (schema > store_schema) {
      throw StoreRefusal(fmt::format("{} was written by a newer Regista: schema {}, this program knows up to {}", file,
                                     schema, store_schema));
    }
    database.exec("PRAGMA journal_mode=WAL");
    database.exec("PRAGMA synchronous=NORMAL");
    find.emplace(database,
                 "SELECT home_goals, away_goals, ended, hash, metrics, failure, seconds FROM matches "
                 "WHERE fixture = ? AND seed = ?");
    insert.emplace(database,
                   "INSERT INTO matches(fixture, seed, home_goals, away_goals, ended, hash, metrics, failure, seconds, "
                   "attempts) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  }

  void begin(const std::string& version) {
    SQLite::Transaction transaction(database);
    database.exec(tables);
    database.exec(fmt::format("PRAGMA application_id={}", application));
    database.exec(fmt::format("PRAGMA user_version={}", store_schema));
    SQLite::Statement insert_version(database, "INSERT INTO meta VALUES('program', ?)");
    insert_version.bind(1, version);
    insert_version.exec();
    transaction.commit();
  }

  std::string file;
  Hold hold;
  SQLite::Database database;
  std::optional<SQLite::Statement> find, insert;
};

Store::Store(const std::filesystem::path& file, Mode mode, const std::string& program_version)
    : parts_(std::make_unique<Parts>(file, mode == Mode::create, program_version)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

std::string Store::meta(const std::string& name) const {
  return guarded(parts_->file, [&] {
    SQLite::Statement select(parts_->database, "SELECT value FROM meta WHERE name = ?");
    select.bindNoCopy(1, name);
    return select.executeStep() ? select.getColumn(0).getString() : std::string();
  });
}

void Store::set_meta(const std::string& name, const std::string& value) {
  guarded(parts_->file, [&] {
    SQLite::Statement put(parts_->database, "INSERT OR REPLACE INTO meta VALUES(?, ?)");
    put.bindNoCopy(1, name);
    put.bindNoCopy(2, value);
    put.exec();
  });
}

std::int64_t Store::fixture(const std::string& key, const std::string& description) {
  return guarded(parts_->file, [&] {
    SQLite::Statement add(parts_->database, "INSERT OR IGNORE INTO fixtures(key, description) VALUES(?, ?)");
    add.bindNoCopy(1, key);
    add.bindNoCopy(2, description);
    add.exec();
    SQLite::Statement select(parts_->database, "SELECT id FROM fixtures WHERE key = ?");
    select.bindNoCopy(1, key);
    select.executeStep();
    return select.getColumn(0).getInt64();
  });
}

std::optional<Decided> Store::find(std::int64_t fixture, std::uint64_t seed) const {
  return guarded(parts_->file, [&]() -> std::optional<Decided> {
    SQLite::Statement& select = *parts_->find;
    select.tryReset();
    select.bind(1, fixture);
    select.bind(2, std::bit_cast<std::int64_t>(seed));
    if (!select.executeStep()) return std::nullopt;
    Decided out;
    out.score = {select.getColumn(0).getInt(), select.getColumn(1).getInt()};
    out.ended = select.getColumn(2).getString();
    out.hash = text_of(select.getColumn(3));
    out.metrics = text_of(select.getColumn(4));
    const std::string failure = text_of(select.getColumn(5));
    if (!failure.empty()) out.failure = failure_from_json(failure);
    out.seconds = select.getColumn(6).getDouble();
    select.reset();
    return out;
  });
}

void Store::insert(std::int64_t fixture, std::uint64_t seed, const Decided& decided, int attempts) {
  guarded(parts_->file, [&] {
    const std::string failure = decided.failure ? to_json(*decided.failure) : std::string();
    SQLite::Statement& insert = *parts_->insert;
    insert.tryReset();  // reset would tell once more of what went wrong last time
    insert.bind(1, fixture);
    insert.bind(2, std::bit_cast<std::int64_t>(seed));
    insert.bind(3, decided.score[0]);
    insert.bind(4, decided.score[1]);
    insert.bindNoCopy(5, decided.ended);
    bind_or_null(insert, 6, decided.hash);
    bind_or_null(insert, 7, decided.metrics);
    bind_or_null(insert, 8, failure);
    insert.bind(9, decided.seconds);
    insert.bind(10, attempts);
    insert.exec();
    insert.reset();
  });
}

std::int64_t Store::rows() const {
  return guarded(parts_->file, [&] { return parts_->database.execAndGet("SELECT count(*) FROM matches").getInt64(); });
}

}  // namespace regista::campaign
