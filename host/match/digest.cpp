// SPDX-License-Identifier: MIT
#include "match/digest.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace regista::match {

struct alignas(64) Digest::State {
  XXH3_state_t hash;
};

Digest::Digest() : state_(std::make_unique<State>()) { XXH3_64bits_reset(&state_->hash); }
Digest::~Digest() = default;

void Digest::add(std::span<const std::byte> bytes) { XXH3_64bits_update(&state_->hash, bytes.data(), bytes.size()); }

std::uint64_t Digest::value() const { return XXH3_64bits_digest(&state_->hash); }

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string unsound(const mind::Outcome& outcome, const config::Robot& robot, const TeamCounts& team) {
  const mind::Command& command = outcome.command;
  const auto finite = [](auto... values) { return (std::isfinite(values) && ...); };
  if (!finite(command.walk.forward, command.walk.sideways, command.walk.turn)) return "walk command is not finite";
  if (!std::isfinite(command.head_yaw)) return "head yaw is not finite";
  if (command.kick) {
    const mind::KickRequest& kick = *command.kick;
    const int kinds = static_cast<int>(robot.kicks.size());
    if (kick.kind < 0 || kick.kind >= kinds) {
      return fmt::format("kick {}, but the profile '{}' has {}", kick.kind, robot.name, kinds);
    }
    if (!finite(kick.direction, kick.distance)) return "kick is not finite";
  }
  const auto lacks = [&team](int row) { return row >= static_cast<int>(team.roles); };
  if (outcome.role < -1 || lacks(outcome.role)) {
    return fmt::format("role {}, but the table of roles has {}", outcome.role, team.roles);
  }
  for (std::size_t i = 0; i < outcome.assignment.size(); ++i) {
    const int role = outcome.assignment[i];
    if (lacks(role)) return fmt::format("role {} for robot {}, but the table of roles has {}", role, i + 1, team.roles);
  }
  for (const int task : outcome.kept) {
    if (task < 0 || lacks(task)) return fmt::format("task {}, but the table of roles has {}", task, team.roles);
  }
  if (outcome.target && !finite(outcome.target->x, outcome.target->y)) return "target is not finite";
  if (outcome.send && (outcome.send_reason < 0 || outcome.send_reason >= static_cast<int>(team.reasons))) {
    return fmt::format("no reason to send has number {}", outcome.send_reason);
  }
  for (const mind::MetricReport& each : outcome.metrics) {
    if (each.metric < 0 || each.metric >= static_cast<int>(team.plugin_metrics)) {
      return fmt::format("no metric has number {}", each.metric);
    }
    const double most = mind::largest_report;
    const auto within = [](double value, double largest) { return std::abs(value) <= largest; };
    if (!within(each.least, most) || !within(each.greatest, most) || !within(each.last, most) ||
        !within(each.sum, most * static_cast<double>(each.count))) {
      return fmt::format("metric {} is out of range", each.metric);
    }
  }
  const mind::SegmentCounts& counts = outcome.segments;
  constexpr std::int64_t most_segments = std::int64_t{1} << 32;  // of a decision
  for (const std::int64_t count :
       {counts.offered, counts.refused, counts.sent, counts.dropped, counts.heard, counts.bytes}) {
    if (count < 0 || count > most_segments) return "counts of segments are out of range";
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
