// SPDX-License-Identifier: MIT
#include "mind/extensions/log_line.hpp"

#include <fmt/format.h>

#include <regista/extensions/log.h>

#include <array>
#include <cstdio>
#include <memory>

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

LogSink to_standard_error(std::int32_t least_level, std::size_t most_bytes) {
  // Shared by all copies of the sink: by side, bytes that were written.
  const auto written = std::make_shared<std::array<std::size_t, 2>>();
  return {least_level, [most_bytes, written](const LogLine& line) {
            std::string text = to_string(line) + '\n';  // in one piece, as others may write there too
            std::size_t& bytes = (*written)[line.side == 0 ? 0 : 1];
            if (most_bytes != 0) {
              if (bytes > most_bytes) return;
              bytes += text.size();
              if (bytes > most_bytes) {
                text = fmt::format("[more lines of {} are left out]\n", line.side == 0 ? "home" : "away");
              }
            }
            std::fwrite(text.data(), 1, text.size(), stderr);
          }};
}

}  // namespace regista::mind
