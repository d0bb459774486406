// SPDX-License-Identifier: MIT
// Results of matches in an SQLite file: a row per match, and what was to be played. Written through a log (WAL) row by
// row, so that a coordinator killed at any moment loses the matches under way and no other.
//
//   fixtures(id, key, job)            all that a match is a function of, but its seed: see inputs.hpp
//   matches(row, fixture, seed, ...)  one row per fixture and seed, never two; row: its place in the schedule, from 1
//   metric_names(id, names, ...)      what numbers of matches are called: see metric_bytes.hpp
//   metrics(row, names, size, ...)    numbers of matches played to their end, under such names
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
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"

namespace regista::campaign {

inline constexpr int store_schema = 2;

// The file cannot be used as it is: what() is one line that names it and says why.
class StoreRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Writing or reading failed later on, such as on a full disk.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A StoreError that is the disk's: it is full, or fails.
class StoreDiskError : public StoreError {
  using StoreError::StoreError;
};

// A StoreError that no other try mends: what stands there is not what was written. what() names the matches.
class StoreDamaged : public StoreError {
  using StoreError::StoreError;
};

// A StoreError after which there is nothing to go on with: the file was deleted, replaced or moved while it was open.
class StoreGone : public StoreError {
  using StoreError::StoreError;
};

// What a stored match is found by: the number that the store gave to a fixture, and the seed.
struct MatchKey {
  std::int64_t fixture = 0;
  std::uint64_t seed = 0;
  friend bool operator==(const MatchKey&, const MatchKey&) = default;
};

enum class Metrics { wanted, left_out };  // they are some kilobytes a match

class Store {
 public:
  enum class Mode {
    create,  // a new file; refuses one that exists
    open,    // an existing one
    read,    // an existing one that is not written to, even while another process does
  };
  // Holds the file for itself until its end, but for Mode::read. Throws StoreRefusal: another program's database,
  // another schema, no permission, in use by another process; StoreDiskError when it cannot be made for lack of room.
  Store(const std::filesystem::path& file, Mode mode, const std::string& program_version);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) = delete;

  // All of these throw StoreError.

  // A text of the table meta; empty when it is not there.
  std::string meta(const std::string& name) const;
  void set_meta(const std::string& name, const std::string& value);

  // The numbers of fixtures, in this order; those that are new are added, all at once.
  struct Fixture {
    std::string key;
    Job job;  // with any seed
  };
  std::vector<std::int64_t> add(std::span<const Fixture> fixtures);
  // The same of those that there are; 0 for others.
  std::vector<std::int64_t> numbers(std::span<const std::string> keys) const;

  // The match of a key. `row`: where it is looked for first.
  std::optional<Decided> find(std::int64_t row, const MatchKey& key, Metrics metrics) const;
  // Also refuses a key that there is already, and a row that is taken. attempts: workers it took.
  void insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts);
  std::int64_t rows() const;
  // Throws StoreGone when the name does not lead to the file that is written to any more; so does insert().
  void require_file() const;

  // Paths of sides that the first rows have numbers under, each once, in the order in which they come up.
  std::vector<std::string> metric_paths(std::int64_t rows) const;

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
