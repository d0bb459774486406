// SPDX-License-Identifier: MIT
#include "plugin/failure.hpp"

#include <fmt/format.h>

#include <utility>

#include "texts/message.hpp"

namespace regista::plugin {
namespace {

std::string line(const Found& plugin, const Caller* caller, const std::string& call, const std::string& message) {
  const std::string who = fmt::format("plugin {} ({})", plugin.descriptor->id, plugin.file.string());
  if (caller == nullptr) return fmt::format("{}: {}: {}", who, call, message);
  return fmt::format("{} of team {}, robot {}, tick {}: {}: {}", who, caller->team, caller->robot, caller->tick, call,
                     message);
}

}  // namespace

Failure::Failure(const Found& plugin, const Caller* caller, std::string call, std::string message)
    : std::runtime_error(texts::one_line(line(plugin, caller, call, message))),
      id_(plugin.descriptor->id),
      file_(plugin.file),
      caller_(caller == nullptr ? std::nullopt : std::optional<Caller>(*caller)),
      call_(std::move(call)),
      message_(std::move(message)) {}

}  // namespace regista::plugin
