// SPDX-License-Identifier: MIT
// The files that a study was begun with, as a file of results holds them: the table documents. So a match can be
// played again after they were edited.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace regista::campaign {

struct Document {
  std::string path;                    // absolute
  std::optional<std::string> content;  // none: it was too large, or a shared object
  friend bool operator==(const Document&, const Document&) = default;
};

class StoredDocuments {
 public:
  static constexpr auto tables = R"(
    CREATE TABLE IF NOT EXISTS documents(
      path TEXT PRIMARY KEY,
      size INTEGER,
      content BLOB,
      checksum INTEGER NOT NULL
    ) WITHOUT ROWID;)";

  // In a database that outlives this. All throw SQLite::Exception.
  explicit StoredDocuments(SQLite::Database& database) : database_(database) {}

  // Within a transaction. Replaces what is stored: a study that was killed before its first match begins anew.
  void keep(std::span<const Document> documents);
  // By path; none where the file was made by a program that kept none. Throws std::invalid_argument when one is
  // damaged.
  std::vector<Document> all();

 private:
  SQLite::Database& database_;
};

}  // namespace regista::campaign
