// SPDX-License-Identifier: MIT
#include "mind/extensions/plugin_log.hpp"

#include <fmt/format.h>

#include <regista/extensions/log.h>

#include <utility>

#include "mind/extensions/cut_text.hpp"
#include "texts/visible.hpp"

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
  constexpr std::size_t most_bytes = REGISTA_LOG_MOST_OF_MATCH;
  if (!is_level(level)) level = REGISTA_LOG_INFO;
  text = cut_text(text, REGISTA_LOG_MOST_BYTES);
  const bool too_many = ++use.lines > most_lines;
  if (too_many || use.bytes + text.size() > most_bytes) {
    if (std::exchange(use.told, true)) return;
    remark(use.plugin, use.place,
           too_many
               ? fmt::format("log: wrote more than {} lines in one decision; what is more is left out", most_lines)
               : fmt::format("log: wrote more than {} KiB in this match; what is more is left out", most_bytes >> 10));
    return;
  }
  use.bytes += text.size();
  if (keeps_ || sink_.wants(level)) add(use.plugin, use.place, level, text);
}

void PluginLog::remark(const char* plugin, int place, std::string_view text) {
  if (keeps_ || sink_.wants(REGISTA_LOG_WARNING)) add(plugin, place, REGISTA_LOG_WARNING, text);
}

void PluginLog::add(const char* plugin, int place, std::int32_t level, std::string_view text) {
  const std::string shown = texts::visible(text);
  LogLine line{level, caller_->noting.side, caller_->robot, place, caller_->tick, time_, plugin, shown};
  if (sink_.wants(level)) sink_.tell(line);
  if (!keeps_) return;
  line.text = texts_.emplace_back(shown);
  lines_.push_back(line);
}

}  // namespace regista::mind
