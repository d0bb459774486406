// SPDX-License-Identifier: MIT
#include "mind/extensions/plugin_log.hpp"

#include <fmt/format.h>

#include <regista/extensions/log.h>

#include <utility>

#include "config/visible_text.hpp"

namespace regista::mind {
namespace {

bool is_level(std::int32_t level) { return level >= REGISTA_LOG_DEBUG && level <= REGISTA_LOG_ERROR; }

}  // namespace

PluginLog::PluginLog(const plugin::Caller& caller, LogSink sink, bool keeps)
    : caller_(&caller), sink_(std::move(sink)), keeps_(keeps) {}

// What plugins wrote while they were created stands with the first decision.
void PluginLog::begin(double time) {
  time_ = time;
  if (begun_) {
    lines_.clear();
    texts_.clear();
  }
  begun_ = true;
}

void PluginLog::write(LogUse& use, std::int32_t level, std::string_view text) {
  constexpr std::uint32_t most_lines = REGISTA_LOG_MOST_LINES;
  if (++use.lines > most_lines) {
    if (!std::exchange(use.told, true)) {
      remark(use.plugin,
             fmt::format("log: wrote more than {} lines in one decision; what is more is left out", most_lines));
    }
    return;
  }
  if (!sink_ && !keeps_) return;
  add(use.plugin, is_level(level) ? level : REGISTA_LOG_INFO, text.substr(0, REGISTA_LOG_MOST_BYTES));
}

void PluginLog::remark(const char* plugin, std::string_view text) {
  if (sink_ || keeps_) add(plugin, REGISTA_LOG_WARNING, text);
}

void PluginLog::add(const char* plugin, std::int32_t level, std::string_view text) {
  const std::string shown = config::visible(text);
  LogLine line{level, caller_->noting.side, caller_->robot, caller_->tick, time_, plugin, shown};
  if (sink_) sink_(line);
  if (!keeps_) return;
  line.text = texts_.emplace_back(shown);
  lines_.push_back(line);
}

}  // namespace regista::mind
