// SPDX-License-Identifier: MIT
// What plugins answered in all decisions of a match, in a file without a name that a worker writes and its coordinator
// reads: of two plays of the same match it shows the first call that was answered otherwise.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "match/match.hpp"
#include "plugin/call_trail.hpp"

namespace regista::campaign {

// The worker's end: writes to a descriptor that it inherited, through memory of its own.
class TrailWriter {
 public:
  explicit TrailWriter(int descriptor) : descriptor_(descriptor) {}
  void add(const match::Decision& decision, std::span<const plugin::CallAnswer> answers);
  void close() { flush(); }

 private:
  void flush();
  int descriptor_;
  std::string waiting_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> names_;  // of plugin and call, by their first use
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

// "home, robot 3, tick 41 (4.12 s): plugin greedy answered assign otherwise"; empty when the trails are equal.
std::string first_difference(std::string_view first, std::string_view second);

}  // namespace regista::campaign
