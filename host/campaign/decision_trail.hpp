// SPDX-License-Identifier: MIT
// The digests of all decisions of a match, in a file without a name that a worker writes and its coordinator reads: of
// two plays of the same match they show where the second first went another way.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "match/decision_digest.hpp"
#include "match/match.hpp"

namespace regista::campaign {

// The worker's end: writes to a descriptor that it inherited, through memory of its own.
class TrailWriter {
 public:
  // The teams' plugins stand at the beginning.
  TrailWriter(int descriptor, const std::array<const mind::TeamPlan*, 2>& plans);
  void add(const match::Decision& decision, const match::DecisionDigest& digest);
  void close();

 private:
  void flush();
  int descriptor_;
  std::string waiting_;
};

// The coordinator's end.
class TrailFile {
 public:
  TrailFile();  // throws std::system_error
  ~TrailFile();
  TrailFile(const TrailFile&) = delete;
  TrailFile& operator=(const TrailFile&) = delete;
  int descriptor() const { return descriptor_; }
  void clear();
  std::string content() const;

 private:
  int descriptor_;
};

// "home, robot 3, tick 41 (4.12 s): the utilities first differed, computed by distance, bearing"; empty when the trails
// are equal.
std::string first_difference(const std::string& first, const std::string& second);

}  // namespace regista::campaign
