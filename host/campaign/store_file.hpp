// SPDX-License-Identifier: MIT
// The file of results as a database: created or opened if its version is ours, held against other processes, and known
// again should its name come to mean another file. docs/results.md describes its layout; its tables are made by
// stored_documents.hpp, stored_fixtures.hpp, stored_matches.cpp and stored_metrics.hpp.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "campaign/store_error.hpp"

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace regista::campaign {

inline constexpr int store_schema = 2;

enum class StoreMode {
  create,  // a new file; refuses one that exists
  open,    // an existing one
  read,    // an existing one that is not written to, even while another process does
};

// How what is under way is kept apart from what has been written.
enum class Journal {
  log,       // a log beside the file (WAL): fastest, and read while it is written
  rollback,  // what it was before, beside it while a row is written: for file systems that several machines share
};

// Whether a file is a database of this program, as far as its head tells. False for one that cannot be read.
bool is_store(const std::filesystem::path& file);

class StoreFile {
 public:
  static constexpr int wait_for_writers = 5000;  // ms, while another program writes
  // tables: what a new file begins with. Throws StoreRefusal and StoreDiskError, as Store does.
  StoreFile(const std::filesystem::path& file, StoreMode mode, const std::string& program_version,
            const std::string& tables, Journal journal);
  ~StoreFile();
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  const std::string& name() const { return name_; }
  SQLite::Database& database() { return *database_; }
  bool written_to() const { return mode_ != StoreMode::read; }

  // Throws StoreRefusal, or StoreDiskError where the disk is full; then a new file is removed again.
  [[noreturn]] void refuse(const SQLite::Exception& error) const;

  // A text of the table meta; empty when it is not there. Throw SQLite::Exception; std::invalid_argument where its
  // checksum does not fit.
  std::string meta(const std::string& name);
  void set_meta(const std::string& name, const std::string& value);
  // Whether texts of the table meta carry checksums: files of older programs are without, until they are written to.
  bool meta_is_checked() const { return meta_is_checked_; }

  // Throws StoreGone when the name does not lead to this file any more, or something else wrote into it: it is shorter
  // than it was, or begins otherwise. What is written to a file that nobody finds by its name is lost, and so is a log
  // that was deleted should we die.
  void require();
  // After each write of ours: what require() compares with. Throws StoreGone as it does.
  void remember();
  // require(), and reads the whole file: throws StoreGone where it is no sound database any more.
  void require_whole();

 private:
  struct Identity;
  class Hold;
  void open();
  void prepare(const std::string& version, const std::string& tables);
  void begin(const std::string& version, const std::string& tables);
  void add_meta_checksums();
  int pragma(const char* name);
  static std::optional<Identity> identity_of(const std::string& name);
  static void require_same(const std::string& name, std::optional<Identity>& known);

  std::string name_;
  StoreMode mode_;
  Journal journal_;
  std::unique_ptr<const Hold> hold_;  // until the database is closed
  std::unique_ptr<SQLite::Database> database_;
  std::unique_ptr<std::optional<Identity>> identity_, log_identity_;
  bool meta_is_checked_ = false;
};

// Why something failed, in words.
std::string reason(const SQLite::Exception& error);
bool is_of_the_disk(const SQLite::Exception& error);

}  // namespace regista::campaign
