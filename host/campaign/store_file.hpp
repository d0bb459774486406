// SPDX-License-Identifier: MIT
// The file of results as a database, and the errors of such a file. StoreFile creates or opens the file, checks its
// schema, locks the file against other processes, and notices when the file is moved or replaced. docs/results.md
// describes the layout. stored_setup.hpp, stored_matches.cpp and stored_metrics.hpp define the tables.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace regista::campaign {

// Thrown if the file cannot be used as it is. what() is one line that names the file and says why.
class StoreRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Thrown if another process has the file open for writing.
class StoreInUse : public StoreRefusal {
  using StoreRefusal::StoreRefusal;
};

// Thrown if reading or writing failed after the file was opened, for example on a full disk.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Thrown if the disk is full or fails.
class StoreDiskError : public StoreError {
  using StoreError::StoreError;
};

// Thrown if something changed the bytes that this program stored. A retry fails, too. what() names the matches.
class StoreDamaged : public StoreError {
  using StoreError::StoreError;
};

// Thrown if the file was deleted, replaced or moved while it was open. Nothing more can be stored in the file.
class StoreGone : public StoreError {
  using StoreError::StoreError;
};

inline constexpr int store_schema = 2;

enum class StoreMode {
  create,  // a new file; refuses a file that exists
  open,    // an existing file, for reading and writing
  read,    // an existing file for reading only, even while another process writes to it
};

// How SQLite can undo a change that a crash has interrupted.
enum class Journal {
  log,       // SQLite writes changes into a log beside the file (WAL): fastest; other processes can read meanwhile
  rollback,  // SQLite first copies old contents to a second file: for file systems that several machines share
};

// Returns whether the first bytes of a file mark a database of this program; false for an unreadable file.
bool is_store(const std::filesystem::path& file);

class StoreFile {
 public:
  static constexpr int wait_for_writers = 5000;  // ms to wait while another program writes
  // tables: SQL that creates the tables of a new file. Throws the same errors as the constructor of Store.
  StoreFile(const std::filesystem::path& file, StoreMode mode, const std::string& program_version,
            const std::string& tables, Journal journal);
  ~StoreFile();

  const std::string& name() const { return name_; }
  SQLite::Database& database() { return *database_; }
  bool written_to() const { return mode_ != StoreMode::read; }

  // Converts an SQLite error. If the disk is full or fails, removes a file that this object created and throws
  // StoreDiskError. Throws StoreRefusal for any other error.
  [[noreturn]] void refuse(const SQLite::Exception& error) const;

  // meta() reads and set_meta() writes a text of the table meta; a missing text is empty. Both throw SQLite::Exception.
  // meta() throws std::invalid_argument if the checksum does not fit.
  std::string meta(const std::string& name);
  void set_meta(const std::string& name, const std::string& value);
  // Returns whether texts of the table meta have checksums. Opening an older file for writing adds missing checksums.
  bool meta_is_checked() const { return meta_is_checked_; }

  // Throws StoreGone if the file or its log was moved, deleted or replaced, or if the file is shorter than before or
  // has another head. Rows in a deleted file are lost. Rows in a deleted log are lost if this process dies.
  void require();
  // Notes the state of the file for require(), after each write. Throws StoreGone for another file or log in its place.
  void remember();
  // Calls require() and reads the whole file. Throws StoreGone if the file is no longer a sound database.
  void require_whole();

 private:
  struct Identity {
    dev_t device = 0;
    ino_t number = 0;
    off_t size = 0;  // the file of results must not become shorter while it is open
  };
  class Hold;
  void open();
  void prepare(const std::string& version, const std::string& tables);
  void begin(const std::string& version, const std::string& tables);
  void add_meta_checksums();
  int pragma(const char* name);
  static void require_same(const std::string& name, std::optional<Identity>& known);

  std::string name_;
  StoreMode mode_;
  Journal journal_;
  std::unique_ptr<const Hold> hold_;  // the lock; declared before database_, so it outlasts the open database
  std::unique_ptr<SQLite::Database> database_;
  std::optional<Identity> identity_, log_identity_;
  bool meta_is_checked_ = false;
};

std::string reason(const SQLite::Exception& error);
bool is_of_the_disk(const SQLite::Exception& error);

}  // namespace regista::campaign
