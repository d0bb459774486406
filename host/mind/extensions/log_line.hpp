// SPDX-License-Identifier: MIT
// A line that a plugin wrote for people: extension regista.log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace regista::mind {

struct LogLine {
  std::int32_t level = 0;   // REGISTA_LOG_*
  int side = 0;             // 0 home, 1 away
  int robot = 0;            // shirt number
  int place = 0;            // of the plugin's instance in the robot's mind, in the order of the team's page
  std::uint64_t tick = 0;   // of the robot: its decisions, from 0
  double time = 0.0;        // s since the start of the match, of the decision
  const char* plugin = "";  // id; lives as long as the team's plan
  std::string_view text;    // well-formed UTF-8 in one line; valid until the robot's next decision
};

// Whoever is told each line from a level on when it is written: what comes before a crash is not lost.
struct LogSink {
  std::int32_t least_level = 0;
  std::function<void(const LogLine&)> tell{};  // empty: nobody

  bool wants(std::int32_t level) const { return tell && level >= least_level; }
};

// "debug", "info", "warning", "error"
const char* level_name(std::int32_t level);

// Of its name; nothing for another word.
std::optional<std::int32_t> level_of(std::string_view name);

// "[warning] home 3, tick 124, voronoi: two points coincide"
std::string to_string(const LogLine& line);

// Of each side, where a worker's standard error is kept with a match: so no team's lines take the place of the other's.
inline constexpr std::size_t most_kept_of_log = 1500;

// Writes lines of this level and above to the process's standard error. most_bytes: of each side, of which a last line
// says that there were more; 0: no limit.
LogSink to_standard_error(std::int32_t least_level, std::size_t most_bytes = 0);

}  // namespace regista::mind
