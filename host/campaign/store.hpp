// SPDX-License-Identifier: MIT
// The SQLite file with the results of a study: the study's plan, and one row for each decided match. The store writes
// each row in its own transaction. A coordinator that is killed at any moment loses only the matches under way.
//
//   fixtures(id, key, job)            matches without their seeds: a key made of the inputs, and a job (job.hpp)
//   matches(row, fixture, seed, ...)  exactly one row per fixture and seed; row: place in the schedule, from 1
//   metric_names(id, names, ...)      the names of metrics: see match_encoding.hpp
//   metrics(row, names, size, ...)    the metrics of each match that was played to its end
//   packets(row, numbers, ...)        packets that both teams spent: reports of short games need no other metrics
//   documents(path, size, content)    the files as they were when the study began
//   remarks(row, kind, text)          why a match was set aside, where it was not reproducible, what plugins wrote
//   meta(name, value)                 "program": version that made the file; "schedule": the study's plan as JSON
//
// A seed is stored as the signed number with the same bits. In the row of a forfeit, columns without a value are null.
// Every row has a checksum, which the store checks when it reads the row. While another program, such as SQLite's own
// shell, holds the lock for writing, new results wait in memory. docs/results.md describes the file for other programs.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store_file.hpp"
#include "campaign/stored_matches.hpp"
#include "campaign/stored_setup.hpp"

namespace regista::campaign {

// The state of a store that could not write, because another program held the lock.
struct Locked {
  std::chrono::milliseconds since{};  // time since the store first found the file locked
  std::size_t matches = 0;            // matches that wait in memory
  bool over = false;                  // true: the lock is free again, and all matches are written
};

class Store {
 public:
  using Mode = StoreMode;
  static constexpr std::size_t most_waiting_bytes = std::size_t{64} << 20;

  // Opens or creates the file. Locks the file against other processes until this object is destroyed, except in
  // Mode::read. Throws StoreRefusal for a database of another program, another schema, missing permission, or a file in
  // use by another process. Throws StoreDiskError if a full or failing disk prevents the creation of a new file.
  Store(const std::filesystem::path& file, Mode mode, const std::string& program_version,
        Journal journal = Journal::log);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) = delete;

  // All following functions throw StoreError.

  // Returns the text with this name in the table meta; empty if the table has no such text.
  std::string meta(const std::string& name) const;
  void set_meta(const std::string& name, const std::string& value);

  // Adds the fixtures that are not stored yet, in one transaction. Returns the number of each fixture of `fixtures`.
  using Fixture = campaign::Fixture;
  std::vector<std::int64_t> add(std::span<const Fixture> fixtures);
  // Returns for each key the number of the stored fixture with this key; 0 if no stored fixture has this key.
  std::vector<std::int64_t> numbers(std::span<const std::string> keys) const;

  // Replaces the stored documents by `documents`, the files as they were when the study began.
  void keep(std::span<const Document> documents);
  std::vector<Document> documents() const;

  // Returns the match with this key, even if it still waits in memory; nothing if it is not stored. Reads `row` first,
  // where the match usually is.
  std::optional<MatchResult> find(std::int64_t row, const MatchKey& key, Metrics metrics) const;
  // Adds a match that took `attempts` plays. Throws StoreError if the key is already stored or the row is taken. While
  // another program holds the lock, the match waits in memory until write_waiting() or settle() writes the match.
  void insert(std::int64_t row, const MatchKey& key, const MatchResult& decided, int attempts);
  // Writes the waiting matches if no other program holds the lock. Returns false if matches still wait.
  bool write_waiting();
  // Waits until no other program holds the lock, then writes all waiting matches.
  void settle();
  bool waiting_is_full() const;
  // The store calls `go_on` repeatedly while another program holds the lock, and once when it is free again. If `go_on`
  // returns false, the store drops the waiting matches and throws StoreError. Without it, the store waits for 5 s.
  void when_locked(std::function<bool(const Locked& locked)> go_on);

  std::int64_t rows() const;
  // Reads the whole file. Throws StoreGone if the file was moved, deleted or replaced, or if another program wrote into
  // the file. Functions that write make a quicker check for the same faults and throw StoreGone, too.
  void require_whole_file() const;
  // Returns a warning about this file for readers of its results, one line; empty for most files.
  std::string remark() const;

  // Throws StoreDamaged for the first match in the rows from `from` to `to` for which `planned` returns false, which
  // means that the study's plan does not have this match in this row.
  using Planned = std::function<bool(std::int64_t row, const MatchKey& key)>;
  void require_planned(std::int64_t from, std::int64_t to, const Planned& planned) const;

  // Copies the matches of `other`, a file of this study, that this file lacks, to the same rows, in one transaction. If
  // this file lacks the fixture of a match, `refused` refuses the match, and `planned` adds it.
  enum class Unknown { refused, planned };
  Taken take(const Store& other, Unknown unknown = Unknown::refused);

  // Returns the paths of all metrics in rows 1 to `rows`, each path once, in the order of first appearance.
  match::MetricPaths metric_paths(std::int64_t rows) const;

  struct Row {
    Job job;
    MatchResult decided;
  };
  std::optional<Row> row(std::int64_t row) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> parts_;
};

}  // namespace regista::campaign
