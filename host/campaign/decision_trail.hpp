// SPDX-License-Identifier: MIT
// The trail of a match: the answers of plugins in all decisions. A worker writes the trail into a file without a name,
// and the coordinator reads this file. A comparison of two trails of one match finds the first different answer.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "match/match.hpp"
#include "plugin/call_inputs.hpp"
#include "process/file_descriptor.hpp"

namespace regista::campaign {

// The worker's object for a trail: collects bytes in memory and writes the bytes to an inherited file descriptor.
class TrailWriter {
 public:
  explicit TrailWriter(int descriptor) : descriptor_(descriptor) {}
  void add(const match::Decision& decision, std::span<const plugin::CallAnswer> answers);
  void flush();  // writes the collected bytes; must be called at the end of the match

 private:
  int descriptor_;
  std::string waiting_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> names_;  // (plugin, call) -> number in the trail
};

// For the coordinator: make the file without a name, and empty it for another play. Both throw std::system_error.
process::FileDescriptor trail_file();
void empty_trail(int descriptor);

// Returns the first difference between two trails, such as "home, robot 3, tick 41 (4.12 s): plugin greedy answered
// assign otherwise"; empty for equal trails.
std::string first_difference(std::string_view first, std::string_view second);

}  // namespace regista::campaign
