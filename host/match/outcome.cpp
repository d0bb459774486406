// SPDX-License-Identifier: MIT
#include "match/outcome.hpp"

#include <regista/abi.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace regista::match {

std::string unsound(const mind::Outcome& outcome, const config::Robot& robot, const TeamCounts& team) {
  const mind::Command& command = outcome.command;
  if (!std::isfinite(command.walk.forward) || !std::isfinite(command.walk.sideways) ||
      !std::isfinite(command.walk.turn)) {
    return "walk command is not finite";
  }
  if (!std::isfinite(command.head_yaw)) return "head yaw is not finite";
  if (command.kick) {
    const mind::KickRequest& kick = *command.kick;
    const int kinds = static_cast<int>(robot.kicks.size());
    if (kick.kind < 0 || kick.kind >= kinds) {
      return "kick " + std::to_string(kick.kind) + ", but the profile '" + robot.name + "' has " +
             std::to_string(kinds);
    }
    if (!std::isfinite(kick.direction) || !std::isfinite(kick.distance)) return "kick is not finite";
  }
  const auto lacks = [&team](int row) { return row >= static_cast<int>(team.roles); };
  const auto but = [&team] { return ", but the table of roles has " + std::to_string(team.roles); };
  if (outcome.role < -1 || lacks(outcome.role)) {
    return "role " + std::to_string(outcome.role) + but();
  }
  for (std::size_t i = 0; i < outcome.assignment.size(); ++i) {
    const int role = outcome.assignment[i];
    if (lacks(role)) return "role " + std::to_string(role) + " for robot " + std::to_string(i + 1) + but();
  }
  for (const int task : outcome.kept) {
    if (task < 0 || lacks(task)) return "task " + std::to_string(task) + but();
  }
  if (outcome.target && !(std::isfinite(outcome.target->x) && std::isfinite(outcome.target->y))) {
    return "target is not finite";
  }
  if (outcome.send && (outcome.send_reason < 0 || outcome.send_reason >= static_cast<int>(team.reasons))) {
    return "no reason to send has number " + std::to_string(outcome.send_reason);
  }
  for (const mind::MetricReport& each : outcome.metrics) {
    if (each.metric < 0 || each.metric >= static_cast<int>(team.plugin_metrics)) {
      return "no metric has number " + std::to_string(each.metric);
    }
    const double most = mind::largest_report;
    const auto within = [](double value, double largest) { return std::abs(value) <= largest; };
    if (!within(each.least, most) || !within(each.greatest, most) || !within(each.last, most) ||
        !within(each.sum, most * each.count)) {
      return "metric " + std::to_string(each.metric) + " is out of range";
    }
  }
  return {};
}

void add(Digest& digest, const mind::Outcome& outcome) {
  const mind::Command& command = outcome.command;
  const mind::KickRequest kick = command.kick.value_or(mind::KickRequest{-1, 0.0, 0.0});
  const std::array<double, 6> values{command.walk.forward, command.walk.sideways, command.walk.turn,
                                     command.head_yaw,     kick.direction,        kick.distance};
  const std::array<std::int32_t, 4> choices{kick.kind, outcome.role, outcome.send ? outcome.send_reason : -1,
                                            static_cast<std::int32_t>(outcome.packet.size())};
  digest.add(std::as_bytes(std::span(values)));
  digest.add(std::as_bytes(std::span(choices)));
  digest.add(std::as_bytes(std::span(outcome.packet)));
}

}  // namespace regista::match
