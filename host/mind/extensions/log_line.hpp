// SPDX-License-Identifier: MIT
// A line that a plugin wrote for people: extension regista.log.
#pragma once

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
  std::uint64_t tick = 0;   // of the robot: its decisions, from 0
  double time = 0.0;        // s since the start of the match, of the decision
  const char* plugin = "";  // id; lives as long as the team's plan
  std::string_view text;    // well-formed UTF-8 in one line; valid until the robot's next decision
};

// Whoever is told each line when it is written: what comes before a crash is not lost.
using LogSink = std::function<void(const LogLine&)>;

// "debug", "info", "warning", "error"
const char* level_name(std::int32_t level);

// Of its name; nothing for another word.
std::optional<std::int32_t> level_of(std::string_view name);

// "[warning] home 3, tick 124, voronoi: two points coincide"
std::string to_string(const LogLine& line);

// Writes lines of this level and above to the process's standard error.
LogSink to_standard_error(std::int32_t least_level);

}  // namespace regista::mind
