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
#include <string_view>
#include <system_error>

#include "campaign/stored_row.hpp"
#include "process/file_descriptor.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

constexpr int application = 0x52475354;          // "RGST": marks files of this program
constexpr int one_thread = SQLITE_OPEN_NOMUTEX;  // each database is used by one thread
constexpr auto gone = "the file is no longer there, or is another one, so nothing more can be kept";
constexpr auto overwritten = "something else has written into the file: ";

// Must be called before a file is opened, because opening a pipe may wait forever. Throws StoreRefusal.
void refuse_what_is_no_file(const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw StoreRefusal(std::filesystem::is_directory(status)
                         ? fmt::format("{} is a folder, not a file of results", file.string())
                         : fmt::format("{} is no ordinary file, so it holds no results", file.string()));
}

constexpr std::size_t head_size = 72;  // bytes

// Returns whether the head has this program's application number, at byte 68 ("Database File Format", sqlite.org).
bool is_head(std::string_view head) {
  int number = 0;
  for (const char each : head.substr(68, 4)) number = number << 8 | static_cast<unsigned char>(each);
  return head.starts_with("SQLite format 3") && number == application;
}

// Escapes the characters that have a meaning in a URI.
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

std::string meaning_of_meta(const std::string& name) {
  if (name == "schedule") return "the plan of its study";
  if (name == "documents") return "the teams' documents";
  return fmt::format("the text {} of the table meta", texts::in_quotes(name));
}

}  // namespace

// The lock on the file. It must exist before the database is opened and until the database is closed, because closing
// any descriptor of a file releases the locks of SQLite on this file.
class StoreFile::Hold {
 public:
  Hold(const std::filesystem::path& file, bool create) {
    file_.reset(::open(file.c_str(), O_RDWR | O_CLOEXEC | (create ? O_CREAT | O_EXCL : 0), 0666));
    if (!file_.is_open() && errno == EEXIST) {
      throw StoreRefusal(
          fmt::format("{} exists already; --resume continues it, --results names another", file.string()));
    }
    if (!file_.is_open())
      throw StoreRefusal(fmt::format("cannot write results to {}: {}", file.string(), std::strerror(errno)));
    const std::error_code error = process::lock_file(file_.number, process::FileLock::exclusive);
    if (!error) return;
    if (create && error != std::errc::operation_would_block) ::unlink(file.c_str());
    if (error == std::errc::operation_would_block)
      throw StoreInUse(fmt::format("{} is in use by another process", file.string()));
    throw StoreRefusal(fmt::format("cannot lock {}: {}", file.string(), error.message()));
  }
  // Locks the file for a reader. Only a file without a log needs this lock against writers.
  explicit Hold(const std::string& file) {
    file_.reset(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file_.is_open()) throw StoreRefusal(fmt::format("cannot read {}: {}", file, std::strerror(errno)));
    unsigned char version = 0;  // write version: 1 without a log, 2 with a log ("Database File Format", sqlite.org)
    if (pread(file_.number, &version, 1, 18) != 1 || version != 1) {
      file_.reset();  // closed now, because closing would later release the locks of SQLite
      return;
    }
    if (process::lock_file(file_.number, process::FileLock::shared) == std::errc::operation_would_block)
      throw StoreInUse(fmt::format("{} is written to just now", file));
    std::error_code none;
    if (const auto size = std::filesystem::file_size(file + "-journal", none); !none && size > 0) {
      throw StoreRefusal(
          fmt::format("{}: the process that wrote to it was killed; open it for writing to repair it, "
                      "as regista resume and gather do",
                      file));
    }
  }
  ~Hold() {
    if (file_.is_open()) process::unlock_file(file_.number);
  }

  // Returns whether the file has the head of a file of this program ("Database File Format", sqlite.org).
  bool begins_as_ours() const {
    std::array<char, head_size> head{};
    return pread(file_.number, head.data(), head.size(), 0) == head_size && is_head({head.data(), head.size()});
  }

 private:
  process::FileDescriptor file_;
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
    : name_(file.string()), mode_(mode), journal_(journal) {
  open();
  try {
    prepare(program_version, tables);
    remember();
  } catch (const SQLite::Exception& error) {
    refuse(error);
  }
}

void StoreFile::refuse(const SQLite::Exception& error) const {
  if (mode_ == StoreMode::read && error.getErrorCode() == SQLITE_CANTOPEN && std::filesystem::exists(name_ + "-wal")) {
    throw StoreRefusal(fmt::format(
        "{0}: its log {0}-wal can only be read where {0}-shm may be written; copy both to a folder that may be written",
        name_));
  }
  const std::string text = fmt::format("{}: {}", name_, reason(error));
  if (mode_ == StoreMode::read || !is_of_the_disk(error)) throw StoreRefusal(text);
  if (mode_ == StoreMode::create) {  // this object created the file, which holds no results
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
  const bool writes = mode_ != StoreMode::read;
  hold_ =
      writes ? std::make_unique<const Hold>(name_, mode_ == StoreMode::create) : std::make_unique<const Hold>(name_);
  try {
    // The path is absolute, because SQLite takes a file called ":memory:" for a database without a file.
    const std::string path = std::filesystem::absolute(name_).string();
    // hold_ locks a file that this object writes. SQLite's own locks would cost requests to the file server, so
    // Journal::rollback switches them off. A file that is only read and has no log is immutable: SQLite makes no log.
    const bool no_lock = writes && journal_ == Journal::rollback;
    const bool immutable = !writes && !std::filesystem::exists(path + "-wal");
    const bool by_address = no_lock || immutable;
    database_ = std::make_unique<SQLite::Database>(
        by_address ? "file:" + in_address(path) + (no_lock ? "?nolock=1" : "?immutable=1") : path,
        (writes ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY) | one_thread | (by_address ? SQLite::OPEN_URI : 0),
        wait_for_writers);
  } catch (const SQLite::Exception& error) {
    throw StoreRefusal(fmt::format("cannot open {}: {}", name_, reason(error)));
  }
}

int StoreFile::pragma(const char* name) { return database_->execAndGet(fmt::format("PRAGMA {}", name)).getInt(); }

void StoreFile::prepare(const std::string& version, const std::string& tables) {
  if (mode_ == StoreMode::create) begin(version, tables);
  // A program that was killed before it created the tables leaves an empty file, which is used like a new file.
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
  SQLite::Statement replace(*database_, "INSERT OR REPLACE INTO meta(name, value, checksum) VALUES(?, ?, ?)");
  put(replace, name, value, checksum_of_meta(name, value));
}

void StoreFile::require_same(const std::string& name, std::optional<Identity>& known) {
  struct stat about {};
  std::optional<Identity> now;
  if (::stat(name.c_str(), &about) == 0) now = {about.st_dev, about.st_ino, about.st_size};
  if (known && (!now || now->device != known->device || now->number != known->number))
    throw StoreGone(fmt::format("results in {}: {}", name, gone));
  known = now;
}

void StoreFile::remember() {
  require_same(name_, identity_);
  require_same(name_ + "-wal", log_identity_);  // the log exists after the first written row
}

void StoreFile::require() {
  const off_t size = identity_ ? identity_->size : 0;
  remember();
  if (identity_ && identity_->size < size) {
    throw StoreGone(
        fmt::format("results in {}: {}it had {} bytes and has {}", name_, overwritten, size, identity_->size));
  }
  if (written_to() && !hold_->begins_as_ours()) {
    throw StoreGone(fmt::format("results in {}: {}it does not begin as a file of results", name_, overwritten));
  }
}

void StoreFile::require_whole() {
  require();
  database_->exec("PRAGMA shrink_memory");  // empties the cache, which may be sound even if the file is not
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
