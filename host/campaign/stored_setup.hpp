// SPDX-License-Identifier: MIT
// Stores the fixtures and the documents of a study in a file of results. Prepares a stored match for a replay: from the
// current files if the files are unchanged, otherwise from copies of the stored documents.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "plugin/catalogue.hpp"
#include "process/file_descriptor.hpp"

namespace SQLite {
class Database;
}  // namespace SQLite

namespace regista::campaign {

// A file as it was when the study began. The stored content allows a replay of a match after the file was edited.
struct Document {
  std::string path;                    // absolute
  std::optional<std::string> content;  // empty for a file that was too large, and for a shared object
  friend bool operator==(const Document&, const Document&) = default;
};

// The table of documents. All functions throw SQLite::Exception.
inline constexpr auto documents_table = R"(
    CREATE TABLE IF NOT EXISTS documents(
      path TEXT PRIMARY KEY,
      size INTEGER,
      content BLOB,
      checksum INTEGER NOT NULL
    ) WITHOUT ROWID;)";
// Replaces all stored documents, within a transaction of the caller. A study that begins again calls it again.
void write_documents(SQLite::Database& database, std::span<const Document> documents);
// Returns all documents, sorted by path; none from older files. Throws std::invalid_argument if a document is damaged.
std::vector<Document> read_documents(SQLite::Database& database);

// A match without its seed. key: see fixture_key(). The seed in `job` has no meaning.
struct Fixture {
  std::string key;
  Job job;
};

class StoredFixtures {
 public:
  static constexpr auto tables = R"(
    CREATE TABLE fixtures(
      id INTEGER PRIMARY KEY,
      key TEXT NOT NULL UNIQUE,
      job TEXT NOT NULL,
      checksum INTEGER NOT NULL
    );)";

  // `database` must have this table and outlive this object. All functions throw SQLite::Exception. numbers(), keys()
  // and all() throw std::invalid_argument for a damaged fixture, whose matches would count as not played.
  explicit StoredFixtures(SQLite::Database& database) : database_(database) {}

  // Adds the fixtures whose keys are new.
  void add(std::span<const Fixture> fixtures);
  // Returns for each key the number of its fixture; 0 if the key is not stored.
  std::vector<std::int64_t> numbers(std::span<const std::string> keys);
  // Return all fixtures in the order of their numbers: keys() as number and key, all() as key and job.
  std::vector<std::pair<std::int64_t, std::string>> keys();
  std::vector<Fixture> all();
  // Returns the job of the fixture with this number. Throws a DamagedRow for `row`, the match that needs the job.
  Job job(std::int64_t number, std::int64_t row);

 private:
  void check();

  SQLite::Database& database_;
  bool checked_ = false;
};

// Reads these files. The result has each file once, sorted by path. Shared objects, files above 16 MiB, and files after
// the first 64 MiB get no content. The hashes in the inputs of a match still show whether such a file has changed.
std::vector<Document> documents_in(std::span<const std::filesystem::path> files);

// Returns the job with paths of copies. The copy of the file /a/b is `root`/a/b. An absolute path becomes the path of
// the copy, if the copy exists. A relative path stays: the caller must read the job in the copy of `given_in`, the
// folder in which the user gave the path. Folders of plugins are not copied, so their paths become absolute.
Job in_copies(Job job, const std::filesystem::path& root, const std::filesystem::path& given_in);

// Copies of documents in a temporary folder: the copy of /a/b is root()/a/b. A relative name in a document or a job
// leads to a copy. An absolute name in a document leads to the original file.
class DocumentCopies {
 public:
  // Writes the copies. A document without content becomes a link to the current file. Throws std::system_error, and
  // std::invalid_argument for a path that this program never stores: relative, not normal, or below another document.
  explicit DocumentCopies(std::vector<Document> documents);

  const std::filesystem::path& root() const { return root_.path(); }

  // Returns the copy of the folder `given_in`, an absolute path; creates the copy if it is missing: see in_copies().
  std::filesystem::path folder(const std::filesystem::path& given_in) const;

 private:
  std::filesystem::path at(const std::filesystem::path& path) const;
  process::TemporaryFolder root_;
};

class StoredSetup {
 public:
  // Prepares the stored match from the files that its job names; relative names start at the current folder. If these
  // files have changed, prepares the match from copies of the documents that `documents` returns, and makes the copy of
  // the current folder the current folder of the process. So the folders of `catalogue` must be absolute. Throws what
  // `documents` and DocumentCopies throw.
  StoredSetup(const Job& stored, const plugin::Catalogue& catalogue,
              const std::function<std::vector<Document>()>& documents);

  // Returns the changes of the files in words; empty if all files are unchanged, and so no copies were made.
  const std::string& changed() const { return changed_; }
  // Returns the differences from the stored match that remain even with copies, in words; usually empty.
  const std::string& missing() const { return missing_; }
  // Returns whether a match can be played. This match may differ from the stored match if missing() is not empty.
  bool playable() const { return prepared_.plans[0] != nullptr; }
  // Returns the job to play. During the play, this object must exist, and the current folder must be the folder that
  // the constructor set.
  const Job& job() const { return job_; }
  MatchSetup take() { return std::move(prepared_); }

 private:
  std::string set_up();

  const plugin::Catalogue& catalogue_;
  Job job_;
  MatchSetup prepared_;
  std::optional<DocumentCopies> copies_;
  std::string changed_, missing_;
};

}  // namespace regista::campaign
