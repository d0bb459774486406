// SPDX-License-Identifier: MIT
// What the plugins of one robot write for people: extension regista.log, <regista/extensions/log.h>. Holds its limits,
// so that no plugin can fill a disk, and says once of each instance that it went beyond them.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mind/extensions/log_line.hpp"
#include "plugin/failure.hpp"

namespace regista::mind {

// What one instance has said.
struct LogUse {
  const char* plugin = "";
  int place = 0;
  std::uint32_t lines = 0;  // in this decision
  std::size_t bytes = 0;    // in this match
  bool told = false;        // that it wrote more than is taken, in this match
};

class PluginLog {
 public:
  // caller outlives the log. sink: told each line at once; may be empty. keeps: for lines().
  PluginLog(const plugin::Caller& caller, LogSink sink, bool keeps);

  void begin(double time);
  void write(LogUse& use, std::int32_t level, std::string_view text);
  // The host's own word about what a plugin did; no limit holds for it.
  void remark(const char* plugin, int place, std::string_view text);

  // Of the last decision; nothing unless they are kept.
  std::span<const LogLine> lines() const { return lines_; }

 private:
  void add(const char* plugin, int place, std::int32_t level, std::string_view text);

  const plugin::Caller* caller_;
  LogSink sink_;
  bool keeps_;
  double time_ = 0.0;
  bool begun_ = false;
  std::deque<std::string> texts_;
  std::vector<LogLine> lines_;
};

}  // namespace regista::mind
