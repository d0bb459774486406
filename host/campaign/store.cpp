// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <deque>
#include <thread>
#include <utility>

#include "campaign/stored_row.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

constexpr std::size_t most_named = 10;  // largest number of damaged rows that a message names

constexpr auto between_tries = std::chrono::milliseconds(100);
constexpr auto usual_patience = std::chrono::seconds(5);
constexpr auto least_patience = std::chrono::milliseconds(500);  // shortest wait, even if go_on returns false

struct Waiting {
  std::int64_t row;
  MatchKey key;
  MatchResult decided;
  int attempts;
};

// While this object exists, SQLite does not wait for a lock of another program, but immediately reports an error.
class NoPatience {
 public:
  explicit NoPatience(SQLite::Database& database) : database_(database) { database.setBusyTimeout(0); }
  ~NoPatience() { sqlite3_busy_timeout(database_.getHandle(), StoreFile::wait_for_writers); }
  NoPatience(const NoPatience&) = delete;
  NoPatience& operator=(const NoPatience&) = delete;

 private:
  SQLite::Database& database_;
};

// Returns the approximate size of a waiting match in memory, in bytes.
std::size_t size_of(const MatchResult& decided) {
  const auto texts = {&decided.why_set_aside, &decided.irreproducible, &decided.shared, &decided.broken,
                      &decided.kept,          &decided.unproven,       &decided.output};
  std::size_t out = sizeof(Waiting) + decided.metrics.values().size_bytes();
  for (const std::string* each : texts) out += each->size();
  return out;
}

// Runs `work` and converts its exceptions, including those for damaged contents, into StoreError.
template <class Impl, class Work>
auto guarded(Impl& parts, Work work) {
  const auto about = [&](const SQLite::Exception& error) {
    const std::string text = fmt::format("results in {}: {}", parts.file.name(), reason(error));
    const std::size_t lost = std::exchange(parts.lost, 0);
    if (lost == 0) return text;
    return fmt::format("{}, so that {} lost", text,
                       lost == 1 ? "a match that was played is" : fmt::format("{} matches that were played are", lost));
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
    throw StoreDamaged(fmt::format("results in {} are damaged: {}", parts.file.name(), error.what()));
  }
}

}  // namespace

struct Store::Impl {
  Impl(const std::filesystem::path& path, Mode mode, const std::string& version, Journal journal)
      : file(path, mode, version, StoredFixtures::tables + StoredMatches::tables() + documents_table, journal),
        fixtures(file.database()),
        matches(opened(file)) {}

  // Refuses a file of this program in which another program has changed the tables.
  static StoredMatches opened(StoreFile& file) {
    try {
      return StoredMatches(file.database(), file.written_to());
    } catch (const SQLite::Exception& error) {
      file.refuse(error);
    }
  }

  // Returns the message for a damaged row: the row, the reason, and the other damaged rows.
  std::string damage(const DamagedRow& found) {
    std::string out = fmt::format("results in {} are damaged: match {}: {}", file.name(), found.row, found.what());
    std::vector<std::int64_t> others = matches.damaged_rows();
    std::erase(others, found.row);
    if (others.empty()) return out;
    const std::size_t named = std::min(others.size(), most_named);
    out += fmt::format("; {} {} cannot be read either", others.size() == 1 ? "match" : "matches",
                       fmt::join(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(named), ", "));
    return named == others.size() ? out : out + fmt::format(", nor can {} more", others.size() - named);
  }

  // Begins the transaction of all reads before the next write, so that SQLite does not lock the file for each row.
  void begin_reading() {
    if (std::exchange(reading, true)) return;
    file.database().exec("BEGIN");
  }
  void end_reading() {
    if (!std::exchange(reading, false)) return;
    matches.reset();
    file.database().exec("COMMIT");
  }

  // Runs `work`, which writes, in one transaction. Throws SQLite::Exception if another program holds the lock.
  template <class Work>
  void write_now(Work work) {
    file.require();
    end_reading();
    const NoPatience at_once(file.database());
    SQLite::Transaction transaction(file.database(), SQLite::TransactionBehavior::IMMEDIATE);
    work();
    transaction.commit();
    file.remember();
  }

  // Writes each waiting match in its own transaction, because a match may need metric names that an earlier match adds.
  void write_waiting_now() {
    while (!waiting.empty()) {
      const Waiting& first = waiting.front();
      write_now([&] { matches.insert(first.row, first.key, first.decided, first.attempts); });
      waiting_bytes -= size_of(first.decided);
      waiting.pop_front();
    }
  }

  // Waits for the lock, writes all waiting matches and runs `work`. Loses the waiting matches if go_on stops the wait.
  template <class Work>
  void write(Work work) {
    for (;;) {
      try {
        write_waiting_now();
        write_now(work);
        no_longer_locked();
        return;
      } catch (const SQLite::Exception& error) {
        if (error.getErrorCode() != SQLITE_BUSY || !goes_on_waiting()) {
          give_up();
          throw;
        }
        std::this_thread::sleep_for(between_tries);
      }
    }
  }

  void give_up() {
    lost = std::exchange(waiting, {}).size();
    waiting_bytes = 0;
  }

  std::chrono::milliseconds locked_for() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - *locked_since);
  }

  // Called when another program holds the lock. Returns whether the store continues to wait.
  bool goes_on_waiting() {
    if (!locked_since) locked_since = std::chrono::steady_clock::now();
    if (!go_on) return locked_for() < usual_patience;
    return go_on({locked_for(), waiting.size(), false}) || locked_for() < least_patience;
  }

  void no_longer_locked() {
    if (!locked_since) return;
    if (go_on) go_on({locked_for(), 0, true});
    locked_since.reset();
  }

  StoreFile file;
  StoredFixtures fixtures;
  StoredMatches matches;
  bool reading = false;
  std::deque<Waiting> waiting;
  std::size_t waiting_bytes = 0;
  std::size_t lost = 0;  // number of waiting matches that the store has dropped
  std::function<bool(const Locked&)> go_on;
  std::optional<std::chrono::steady_clock::time_point> locked_since;
};

Store::Store(const std::filesystem::path& file, Mode mode, const std::string& program_version, Journal journal)
    : parts_(std::make_unique<Impl>(file, mode, program_version, journal)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

std::string Store::meta(const std::string& name) const {
  return guarded(*parts_, [&] { return parts_->file.meta(name); });
}

void Store::set_meta(const std::string& name, const std::string& value) {
  guarded(*parts_, [&] { parts_->write([&] { parts_->file.set_meta(name, value); }); });
}

std::vector<std::int64_t> Store::numbers(std::span<const std::string> keys) const {
  return guarded(*parts_, [&] { return parts_->fixtures.numbers(keys); });
}

std::vector<std::int64_t> Store::add(std::span<const Fixture> fixtures) {
  guarded(*parts_, [&] { parts_->write([&] { parts_->fixtures.add(fixtures); }); });
  return numbers(texts::names_of(fixtures, &Fixture::key));
}

void Store::keep(std::span<const Document> documents) {
  guarded(*parts_, [&] { parts_->write([&] { write_documents(parts_->file.database(), documents); }); });
}

std::vector<Document> Store::documents() const {
  return guarded(*parts_, [&] { return read_documents(parts_->file.database()); });
}

std::optional<MatchResult> Store::find(std::int64_t row, const MatchKey& key, Metrics metrics) const {
  const auto waits = std::ranges::find(parts_->waiting, key, &Waiting::key);
  if (waits != parts_->waiting.end()) return waits->decided;
  return guarded(*parts_, [&] {
    parts_->begin_reading();
    return parts_->matches.find(row, key, metrics);
  });
}

void Store::insert(std::int64_t row, const MatchKey& key, const MatchResult& decided, int attempts) {
  parts_->waiting.push_back({row, key, decided, attempts});
  parts_->waiting_bytes += size_of(decided);
  write_waiting();
}

bool Store::write_waiting() {
  if (parts_->waiting.empty()) return true;
  return guarded(*parts_, [&] {
    try {
      parts_->write_waiting_now();
      parts_->no_longer_locked();
      return true;
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_BUSY) {
        parts_->give_up();                                       // a retry does not help
        parts_->lost = parts_->lost > 0 ? parts_->lost - 1 : 0;  // the newest match never waited, so it is not lost
        throw;
      }
      parts_->goes_on_waiting();  // calls go_on, which may report the lock
      return false;
    }
  });
}

void Store::settle() {
  if (parts_->waiting.empty()) return;
  guarded(*parts_, [&] { parts_->write([] {}); });
}

bool Store::waiting_is_full() const { return parts_->waiting_bytes > most_waiting_bytes; }

void Store::when_locked(std::function<bool(const Locked&)> go_on) { parts_->go_on = std::move(go_on); }

Taken Store::take(const Store& other, Unknown unknown) {
  Impl& there = *other.parts_;
  const auto theirs = guarded(there, [&] {
    there.begin_reading();
    return there.fixtures.keys();
  });
  if (unknown == Unknown::planned) add(guarded(there, [&] { return there.fixtures.all(); }));
  const std::vector<std::int64_t> ours = numbers(texts::names_of(theirs, [](const auto& each) { return each.second; }));
  FixtureNumbers mine;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    if (ours[i] != 0) mine.emplace(theirs[i].first, ours[i]);
  }
  Taken out;
  guarded(*parts_, [&] { parts_->write([&] { out = parts_->matches.take(there.matches, mine); }); });
  return out;
}

std::optional<Store::Row> Store::row(std::int64_t row) const {
  return guarded(*parts_, [&]() -> std::optional<Row> {
    parts_->begin_reading();
    const auto found = parts_->matches.row(row);
    if (!found) return std::nullopt;
    Row out{parts_->fixtures.job(found->key.fixture, row), found->decided};
    out.job.seed = found->key.seed;
    return out;
  });
}

match::MetricPaths Store::metric_paths(std::int64_t rows) const {
  return guarded(*parts_, [&] { return parts_->matches.metric_paths(rows); });
}

void Store::require_planned(std::int64_t from, std::int64_t to, const Planned& planned) const {
  guarded(*parts_, [&] {
    parts_->begin_reading();
    const auto stray = parts_->matches.first_not_planned(from, to, planned);
    if (stray) throw DamagedRow(*stray, "the study did not plan it");
  });
}

std::string Store::remark() const {
  if (parts_->file.meta_is_checked()) return {};
  return fmt::format("{}: an older Regista wrote it: its plan has no checksum, so that a change of it is not noticed",
                     parts_->file.name());
}

void Store::require_whole_file() const {
  guarded(*parts_, [&] {
    parts_->end_reading();
    parts_->file.require_whole();
  });
}

std::int64_t Store::rows() const {
  return guarded(*parts_, [&] { return parts_->matches.rows(); });
}

}  // namespace regista::campaign
