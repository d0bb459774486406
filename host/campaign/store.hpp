// SPDX-License-Identifier: MIT
// Results of matches in an SQLite file: a row per match, and what was to be played. Written through a log (WAL) row by
// row, so that a coordinator killed at any moment loses the matches under way and no other.
//
//   fixtures(id, key, job)            all that a match is a function of, but its seed: see inputs.hpp
//   matches(row, fixture, seed, ...)  one row per fixture and seed, never two; row: its place in the schedule, from 1
//   metric_names(id, names, ...)      what numbers of matches are called: see metric_bytes.hpp
//   metrics(row, names, size, ...)    numbers of matches played to their end, under such names
//   packets(row, numbers, ...)        those of them that reports of short games need: see stored_packets.hpp
//   documents(path, size, content)    the files that the study was begun with
//   remarks(row, kind, text)          why a match was set aside, where it was not reproducible, what plugins wrote
//   meta(name, value)                 "program": version that made the file; "schedule": JSON, whatever the study says
//
// A seed stands there as the signed number with the same bits. What a forfeit has not is null. All rows carry a
// checksum; one that does not fit is found when it is read. docs/results.md describes the file for other programs.
//
// Another program may hold the lock for writing, as somebody who looks at the file with SQLite's own shell does. Then
// matches that have ended wait in memory, and are written as soon as it is free.
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
#include "campaign/match_key.hpp"
#include "campaign/store_error.hpp"
#include "campaign/store_file.hpp"
#include "campaign/stored_documents.hpp"
#include "campaign/stored_fixtures.hpp"
#include "campaign/stored_matches.hpp"

namespace regista::campaign {

// Another program keeps us from writing.
struct Locked {
  std::chrono::milliseconds since{};  // so long already
  std::size_t matches = 0;            // that wait in memory
  bool over = false;                  // it does so no longer: all is written
};

class Store {
 public:
  using Mode = StoreMode;
  static constexpr std::size_t most_waiting_bytes = std::size_t{64} << 20;

  // Holds the file for itself until its end, but for Mode::read. Throws StoreRefusal: another program's database,
  // another schema, no permission, in use by another process; StoreDiskError when it cannot be made for lack of room.
  Store(const std::filesystem::path& file, Mode mode, const std::string& program_version,
        Journal journal = Journal::log);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) = delete;

  // All of these throw StoreError.

  // A text of the table meta; empty when it is not there.
  std::string meta(const std::string& name) const;
  void set_meta(const std::string& name, const std::string& value);

  // The numbers of fixtures, in this order; those that are new are added, all at once.
  using Fixture = campaign::Fixture;
  std::vector<std::int64_t> add(std::span<const Fixture> fixtures);
  // The same of those that there are; 0 for others.
  std::vector<std::int64_t> numbers(std::span<const std::string> keys) const;

  // The files that the study was begun with.
  void keep(std::span<const Document> documents);
  std::vector<Document> documents() const;

  // The match of a key. `row`: where it is looked for first.
  std::optional<Decided> find(std::int64_t row, const MatchKey& key, Metrics metrics) const;
  // Refuses a key that is stored already, and a row that is taken. attempts: workers it took. Where another program
  // holds the lock the match waits in memory, in which find() sees it, until write_waiting() or settle().
  void insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts);
  // Tries to write what waits. False: something still does.
  bool write_waiting();
  // Writes all that waits, as soon as that can be.
  void settle();
  bool waiting_is_full() const;
  // Is called again and again while another program holds the lock: whether to go on waiting for it; and once when that
  // is over. Where it says no, what must be written is given up; without it, after 5 s.
  void when_locked(std::function<bool(const Locked& locked)> go_on);

  std::int64_t rows() const;
  // Throws StoreGone when the name does not lead to the file that is written to any more, or something else wrote into
  // it, for which the whole file is read. What writes throws it, too, as far as that is seen without.
  void require_whole_file() const;
  // What a reader of results must know of this file, one line; mostly empty.
  std::string remark() const;

  // Throws StoreDamaged for the first match in the rows from `from` to `to` that is none of the plan: for which
  // `planned` is false.
  using Planned = std::function<bool(std::int64_t row, const MatchKey& key)>;
  void require_planned(std::int64_t from, std::int64_t to, const Planned& planned) const;

  // Takes over the matches of another file of the same study that are not here yet, in their rows; all at once.
  // unknown: matches of which nothing like them was planned here are refused, or planned from then on.
  enum class Unknown { refused, planned };
  Taken take(const Store& other, Unknown unknown = Unknown::refused);

  // Paths that the first rows have numbers under, each once, in the order in which they come up.
  match::MetricPaths metric_paths(std::int64_t rows) const;

  // A stored match and what it was.
  struct Row {
    Job job;
    Decided decided;
  };
  std::optional<Row> row(std::int64_t row) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::campaign
