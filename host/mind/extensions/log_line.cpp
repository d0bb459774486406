// SPDX-License-Identifier: MIT
#include "mind/extensions/log_line.hpp"

#include <fmt/format.h>

#include <regista/extensions/log.h>

#include <cstdio>

namespace regista::mind {

const char* level_name(std::int32_t level) {
  switch (level) {
    case REGISTA_LOG_DEBUG:
      return "debug";
    case REGISTA_LOG_WARNING:
      return "warning";
    case REGISTA_LOG_ERROR:
      return "error";
    default:
      return "info";
  }
}

std::string to_string(const LogLine& line) {
  return fmt::format("[{}] {} {}, tick {}, {}: {}", level_name(line.level), line.side == 0 ? "home" : "away",
                     line.robot, line.tick, line.plugin, line.text);
}

std::optional<std::int32_t> level_of(std::string_view name) {
  for (std::int32_t level = REGISTA_LOG_DEBUG; level <= REGISTA_LOG_ERROR; ++level) {
    if (name == level_name(level)) return level;
  }
  return std::nullopt;
}

LogSink to_standard_error(std::int32_t least_level) {
  return [least_level](const LogLine& line) {
    if (line.level < least_level) return;
    const std::string text = to_string(line) + '\n';  // in one piece, as others may write there too
    std::fwrite(text.data(), 1, text.size(), stderr);
  };
}

}  // namespace regista::mind
