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
// A seed stands there as the signed number with the same bits. What a forfeit has not is null. All rows but those
// of meta carry a checksum; one that does not fit is found when its match is read. docs/results.md describes the file
// for other programs.
#pragma once

#include <cstdint>
#include <filesystem>
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

class Store {
 public:
  using Mode = StoreMode;
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
  // Also refuses a key that there is already, and a row that is taken. attempts: workers it took.
  void insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts);
  std::int64_t rows() const;
  // Throws StoreGone when the name does not lead to the file that is written to any more; so does insert().
  void require_file() const;

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
