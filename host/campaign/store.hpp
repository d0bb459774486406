// SPDX-License-Identifier: MIT
// Results of matches in an SQLite file: a row per match, and what was to be played. Written through a log (WAL) row by
// row, so that a coordinator killed at any moment loses the matches under way and no other.
//
//   fixtures(id, key, description)      all that a match is a function of, but its seed: see inputs.hpp
//   matches(row, fixture, seed, ...)    one row per fixture and seed, never two
//   meta(name, value)                   "program": version that made the file; "schedule": JSON, whatever the study
//   says
//
// A seed stands there as the signed number with the same bits. What a forfeit has not is null.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "campaign/job.hpp"

namespace regista::campaign {

inline constexpr int store_schema = 1;

// The file cannot be used as it is: what() is one line that names it and says why.
class StoreRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Writing or reading failed later on, such as on a full disk.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Store {
 public:
  enum class Mode {
    create,  // a new file; refuses one that exists
    open,    // an existing one
  };
  // Holds the file for itself until its end. Throws StoreRefusal: another program's database, a newer schema, no
  // permission, in use by another process.
  Store(const std::filesystem::path& file, Mode mode, const std::string& program_version);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) = delete;

  // A text of the table meta; empty when it is not there.
  std::string meta(const std::string& name) const;
  void set_meta(const std::string& name, const std::string& value);

  // The number of a fixture; it is added when it is new.
  std::int64_t fixture(const std::string& key, const std::string& description);

  std::optional<Decided> find(std::int64_t fixture, std::uint64_t seed) const;
  // attempts: workers it took. Throws StoreError, also when there is such a row already.
  void insert(std::int64_t fixture, std::uint64_t seed, const Decided& decided, int attempts);
  std::int64_t rows() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::campaign
