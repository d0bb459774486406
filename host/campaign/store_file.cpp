// SPDX-License-Identifier: MIT
#include "campaign/store_file.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "campaign/row_checksum.hpp"
#include "process/descriptor.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

constexpr int application = 0x52475354;          // "RGST": tells our files from those of other programs
constexpr int one_thread = SQLITE_OPEN_NOMUTEX;  // each is used by one thread
constexpr auto gone = "the file is no longer there, or is another one, so nothing more can be kept";
constexpr auto overwritten = "something else has written into the file: ";

// Before it is opened: a pipe would wait for ever.
void refuse_what_is_no_file(const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw StoreRefusal(std::filesystem::is_directory(status)
                         ? fmt::format("{} is a folder, not a file of results", file.string())
                         : fmt::format("{} is no ordinary file, so it holds no results", file.string()));
}

constexpr std::size_t head_size = 72;  // bytes

// "Database File Format", sqlite.org: the application's number stands at byte 68, most significant byte first.
bool is_head(std::string_view head) {
  int number = 0;
  for (const char each : head.substr(68, 4)) number = number << 8 | static_cast<unsigned char>(each);
  return head.starts_with("SQLite format 3") && number == application;
}

// What would mean something in an address of a file.
std::string in_address(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#')
      out += fmt::format("%{:02x}", static_cast<int>(c));
    else
      out += c;
  }
  return out;
}

std::int64_t checksum_of_meta(const std::string& name, const std::string& value) {
  return RowChecksum().bytes(name).bytes(value).value();
}

// For messages.
std::string meaning_of_meta(const std::string& name) {
  if (name == "schedule") return "the plan of its study";
  if (name == "documents") return "the teams' documents";
  return fmt::format("the text {} of the table meta", texts::in_quotes(name));
}

}  // namespace

// What a name leads to.
struct StoreFile::Identity {
  dev_t device = 0;
  ino_t number = 0;
  off_t size = 0;  // the file of results does not become shorter while it is open
  bool same_file(const Identity& other) const { return device == other.device && number == other.number; }
};

std::optional<StoreFile::Identity> StoreFile::identity_of(const std::string& name) {
  struct stat about {};
  if (::stat(name.c_str(), &about) != 0) return std::nullopt;
  return Identity{about.st_dev, about.st_ino, about.st_size};
}

// Held from before the database is opened until after it is closed: closing any descriptor of a file gives up the
// locks that SQLite itself has on it.
class StoreFile::Hold {
 public:
  Hold(const std::filesystem::path& file, bool create) {
    const int flags = O_RDWR | O_CLOEXEC | (create ? O_CREAT | O_EXCL : 0);
    descriptor_ = ::open(file.c_str(), flags, 0666);
    if (descriptor_ == -1 && errno == EEXIST) {
      throw StoreRefusal(
          fmt::format("{} exists already; --resume continues it, --results names another", file.string()));
    }
    if (descriptor_ == -1) {
      throw StoreRefusal(fmt::format("cannot write results to {}: {}", file.string(), std::strerror(errno)));
    }
    const std::error_code error = process::lock_file(descriptor_, process::FileLock::exclusive);
    if (!error) return;
    close(descriptor_);
    if (error == std::errc::operation_would_block)
      throw StoreInUse(fmt::format("{} is in use by another process", file.string()));
    throw StoreRefusal(fmt::format("cannot lock {}: {}", file.string(), error.message()));
  }
  // Of a reader. A file with a log is read while it is written to, and is not held; one without a log is read only
  // while nobody writes to it.
  explicit Hold(const std::string& file) {
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ == -1) throw StoreRefusal(fmt::format("cannot read {}: {}", file, std::strerror(errno)));
    std::array<unsigned char, 1>
        version{};  // to write: 1 without a log, 2 with one ("Database File Format", sqlite.org)
    const bool without_log = pread(descriptor_, version.data(), version.size(), 18) == 1 && version[0] == 1;
    if (!without_log) {
      close(std::exchange(descriptor_, -1));  // before SQLite has locks on it
      return;
    }
    if (process::lock_file(descriptor_, process::FileLock::shared) == std::errc::operation_would_block) {
      close(descriptor_);
      throw StoreInUse(fmt::format("{} is written to just now", file));
    }
    std::error_code none;
    if (const auto size = std::filesystem::file_size(file + "-journal", none); !none && size > 0) {
      close(descriptor_);
      throw StoreRefusal(
          fmt::format("{}: who wrote to it was killed; opened for writing, as by regista resume or gather, "
                      "it is whole again",
                      file));
    }
  }
  ~Hold() {
    if (descriptor_ == -1) return;
    process::unlock_file(descriptor_);
    close(descriptor_);
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

  // Whether the file begins as those of this program do ("Database File Format", sqlite.org).
  bool begins_as_ours() const {
    std::array<char, head_size> head{};
    return pread(descriptor_, head.data(), head.size(), 0) == head_size && is_head({head.data(), head.size()});
  }

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

bool is_store(const std::filesystem::path& file) {
  std::array<char, head_size> head{};
  std::ifstream in(file, std::ios::binary);
  return in.read(head.data(), head.size()) && is_head({head.data(), head.size()});
}

StoreFile::StoreFile(const std::filesystem::path& file, StoreMode mode, const std::string& program_version,
                     const std::string& tables, Journal journal)
    : name_(file.string()),
      mode_(mode),
      journal_(journal),
      identity_(std::make_unique<std::optional<Identity>>()),
      log_identity_(std::make_unique<std::optional<Identity>>()) {
  open();
  try {
    prepare(program_version, tables);
    remember();
  } catch (const SQLite::Exception& error) {
    refuse(error);
  }
}

void StoreFile::refuse(const SQLite::Exception& error) const {
  const std::string text = fmt::format("{}: {}", name_, reason(error));
  if (mode_ == StoreMode::read || !is_of_the_disk(error)) throw StoreRefusal(text);
  if (mode_ == StoreMode::create) {  // ours, and nothing is in it
    for (const char* const each : {"", "-wal", "-shm"}) {
      std::error_code none;
      std::filesystem::remove(name_ + each, none);
    }
  }
  throw StoreDiskError("cannot write results to " + text);
}

StoreFile::~StoreFile() = default;

void StoreFile::open() {
  if (mode_ != StoreMode::create) refuse_what_is_no_file(name_);
  if (mode_ != StoreMode::read) {
    hold_ = std::make_unique<const Hold>(name_, mode_ == StoreMode::create);
  } else {
    hold_ = std::make_unique<const Hold>(name_);
  }
  try {
    // A file in the current folder may be called ":memory:", which SQLite takes for no file at all.
    const std::string path = std::filesystem::absolute(name_).string();
    if (mode_ != StoreMode::read && journal_ == Journal::rollback) {
      // We hold the file; SQLite's own locks cost a question to the server each.
      database_ =
          std::make_unique<SQLite::Database>("file:" + in_address(path) + "?nolock=1",
                                             SQLite::OPEN_READWRITE | one_thread | SQLite::OPEN_URI, wait_for_writers);
    } else if (mode_ != StoreMode::read) {
      database_ = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | one_thread, wait_for_writers);
    } else if (std::filesystem::exists(path + "-wal")) {
      // A log beside it holds what was written last. Where there is none nobody writes, and none need be made.
      database_ = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READONLY | one_thread, wait_for_writers);
    } else {
      database_ =
          std::make_unique<SQLite::Database>("file:" + in_address(path) + "?immutable=1",
                                             SQLite::OPEN_READONLY | one_thread | SQLite::OPEN_URI, wait_for_writers);
    }
  } catch (const SQLite::Exception& error) {
    throw StoreRefusal(fmt::format("cannot open {}: {}", name_, reason(error)));
  }
}

int StoreFile::pragma(const char* name) { return database_->execAndGet(fmt::format("PRAGMA {}", name)).getInt(); }

void StoreFile::prepare(const std::string& version, const std::string& tables) {
  if (mode_ == StoreMode::create) begin(version, tables);
  // Killed between the creation of the file and that of its tables: as good as new.
  const bool blank = pragma("application_id") == 0 && pragma("page_count") == 0;
  if (mode_ == StoreMode::open && blank) begin(version, tables);
  if (mode_ == StoreMode::read && blank) throw StoreRefusal(fmt::format("{} holds no results yet", name_));
  if (pragma("application_id") != application) {
    throw StoreRefusal(fmt::format("{} is a database of another program, not results of Regista", name_));
  }
  const int schema = pragma("user_version");
  if (schema != store_schema) {
    const std::string by = database_->tableExists("meta") ? meta("program") : "";
    throw StoreRefusal(fmt::format("{} was written by {} Regista{}: its schema is {}, this program reads {}", name_,
                                   schema > store_schema ? "a newer" : "an older", by.empty() ? "" : ", " + by, schema,
                                   store_schema));
  }
  meta_is_checked_ =
      database_->execAndGet("SELECT count(*) FROM pragma_table_info('meta') WHERE name = 'checksum'").getInt() != 0;
  if (mode_ == StoreMode::read) return;
  if (!meta_is_checked_) add_meta_checksums();
  database_->exec(journal_ == Journal::log ? "PRAGMA journal_mode=WAL" : "PRAGMA journal_mode=DELETE");
  database_->exec(journal_ == Journal::log ? "PRAGMA synchronous=NORMAL" : "PRAGMA synchronous=FULL");
}

void StoreFile::begin(const std::string& version, const std::string& tables) {
  SQLite::Transaction transaction(*database_);
  database_->exec(
      "CREATE TABLE meta(name TEXT PRIMARY KEY, value TEXT NOT NULL, checksum INTEGER NOT NULL) WITHOUT ROWID;");
  database_->exec(tables);
  database_->exec(fmt::format("PRAGMA application_id={}", application));
  database_->exec(fmt::format("PRAGMA user_version={}", store_schema));
  set_meta("program", version);
  transaction.commit();
}

// Of a file that an older program made.
void StoreFile::add_meta_checksums() {
  SQLite::Transaction transaction(*database_);
  database_->exec("ALTER TABLE meta ADD COLUMN checksum INTEGER NOT NULL DEFAULT 0");
  std::map<std::string, std::string> texts;
  SQLite::Statement each(*database_, "SELECT name, value FROM meta");
  while (each.executeStep()) texts.emplace(each.getColumn(0).getString(), each.getColumn(1).getString());
  for (const auto& [name, value] : texts) set_meta(name, value);
  transaction.commit();
}

std::string StoreFile::meta(const std::string& name) {
  SQLite::Statement select(*database_, meta_is_checked_ ? "SELECT value, checksum FROM meta WHERE name = ?"
                                                        : "SELECT value FROM meta WHERE name = ?");
  select.bindNoCopy(1, name);
  if (!select.executeStep()) return {};
  std::string value = select.getColumn(0).getString();
  if (meta_is_checked_ && select.getColumn(1).getInt64() != checksum_of_meta(name, value)) {
    throw std::invalid_argument(fmt::format("the checksum of {} does not fit", meaning_of_meta(name)));
  }
  return value;
}

void StoreFile::set_meta(const std::string& name, const std::string& value) {
  SQLite::Statement put(*database_, "INSERT OR REPLACE INTO meta(name, value, checksum) VALUES(?, ?, ?)");
  put.bindNoCopy(1, name);
  put.bindNoCopy(2, value);
  put.bind(3, checksum_of_meta(name, value));
  put.exec();
}

void StoreFile::require_same(const std::string& name, std::optional<Identity>& known) {
  const std::optional<Identity> now = identity_of(name);
  if (known && (!now || !now->same_file(*known))) throw StoreGone(fmt::format("results in {}: {}", name, gone));
  known = now;
}

void StoreFile::remember() {
  require_same(name_, *identity_);
  require_same(name_ + "-wal", *log_identity_);  // is there from the first row that is written on
}

void StoreFile::require() {
  const off_t size = *identity_ ? (*identity_)->size : 0;
  remember();
  if (*identity_ && (*identity_)->size < size) {
    throw StoreGone(
        fmt::format("results in {}: {}it had {} bytes and has {}", name_, overwritten, size, (*identity_)->size));
  }
  if (written_to() && !hold_->begins_as_ours()) {
    throw StoreGone(fmt::format("results in {}: {}it does not begin as a file of results", name_, overwritten));
  }
}

void StoreFile::require_whole() {
  require();
  database_->exec("PRAGMA shrink_memory");  // what is in memory may be whole though the file is not
  std::string said;
  try {
    said = database_->execAndGet("PRAGMA quick_check(1)").getString();
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_CORRUPT && error.getErrorCode() != SQLITE_NOTADB) throw;
    said = reason(error);
  }
  if (said != "ok") throw StoreGone(fmt::format("results in {}: {}{}", name_, overwritten, texts::one_line(said)));
}

}  // namespace regista::campaign
