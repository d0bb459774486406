// SPDX-License-Identifier: MIT
// What a robot says of itself in every packet, as the assignment needs it: where it is, what it sees of the ball, which
// task it does and which tasks it has to choose from. The same numbers but for the list of tasks are in the packet's
// core. A frame shows the core only after a predictor has carried it forward, and of the ball only what all robots
// together make of it. The extension regista.told shows it as it was said; this plugin is older and does not use it.
//
// x y mm:16 | heading:8 | speed cm/s:8 | ball age ds:8, 255 = no ball | ball x y mm:16 | task:8, 255 = none | a bit for
// each role, set when it is a task now. 12 bytes and one for eight roles; lowest byte first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "active_player.hpp"

namespace b_human {

inline constexpr std::size_t most_roles = 254;  // of a team, by the host's packets

struct Statement {
  std::int32_t x = 0, y = 0;            // mm
  std::uint8_t heading = 0;             // in turns / 256
  std::uint8_t speed = 0;               // cm/s
  std::uint8_t ball_age = 255;          // 0.1 s; 255: it has seen none of late
  std::int32_t ball_x = 0, ball_y = 0;  // mm
  std::int32_t task = -1;               // role that it plays
  std::array<std::uint8_t, (most_roles + 7) / 8> tasks{};

  bool has_task(std::int32_t id) const {
    const auto row = static_cast<std::size_t>(id);
    return id >= 0 && row < most_roles && (tasks[row / 8] >> row % 8 & 1u) != 0;
  }
  void add_task(std::int32_t id) {
    const auto row = static_cast<std::size_t>(id);
    if (id >= 0 && row < most_roles) tasks[row / 8] = static_cast<std::uint8_t>(tasks[row / 8] | 1u << row % 8);
  }
  Pose pose() const { return {x / 1000.0, y / 1000.0, heading * heading_step}; }
  Point ball() const { return {ball_x / 1000.0, ball_y / 1000.0}; }
  bool knows_ball() const { return ball_age != 255; }
  double ball_seconds() const { return ball_age / 10.0; }

  static constexpr double heading_step = 6.283185307179586 / 256.0;
};

// To the nearest that can be said.
inline std::int32_t millimetres(double metres) {
  return static_cast<std::int32_t>(std::clamp(std::round(1000.0 * metres), -32767.0, 32767.0));
}
inline std::uint8_t heading_byte(double heading) {
  const auto steps = static_cast<std::int64_t>(std::llround(heading / Statement::heading_step));
  return static_cast<std::uint8_t>(steps & 255);
}
inline std::uint8_t speed_byte(double metres_per_second) {
  return static_cast<std::uint8_t>(std::clamp(std::round(100.0 * metres_per_second), 0.0, 255.0));
}
inline std::uint8_t age_byte(double seconds) {
  return static_cast<std::uint8_t>(std::clamp(std::round(10.0 * seconds), 0.0, 254.0));
}

constexpr std::size_t statement_bytes(std::size_t roles) { return 12 + (roles + 7) / 8; }

// roles: rows of the team's table, at most most_roles. Replaces `out`.
inline void write(const Statement& said, std::size_t roles, std::vector<std::uint8_t>& out) {
  out.clear();
  const auto pair = [&](std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    out.push_back(static_cast<std::uint8_t>(bits & 255u));
    out.push_back(static_cast<std::uint8_t>(bits >> 8 & 255u));
  };
  pair(said.x);
  pair(said.y);
  out.push_back(said.heading);
  out.push_back(said.speed);
  out.push_back(said.ball_age);
  pair(said.ball_x);
  pair(said.ball_y);
  out.push_back(said.task < 0 ? std::uint8_t{255} : static_cast<std::uint8_t>(said.task));
  for (std::size_t k = 0; k < (roles + 7) / 8; ++k) out.push_back(said.tasks[k]);
}

// Nothing, if that are no bytes of this team: a wrong length, or roles that it does not have.
inline std::optional<Statement> read(std::span<const std::uint8_t> bytes, std::size_t roles) {
  if (bytes.size() != statement_bytes(roles)) return std::nullopt;
  const auto pair = [&](std::size_t at) {
    const auto value = static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
    return static_cast<std::int32_t>(static_cast<std::int16_t>(value));
  };
  Statement said;
  said.x = pair(0);
  said.y = pair(2);
  said.heading = bytes[4];
  said.speed = bytes[5];
  said.ball_age = bytes[6];
  said.ball_x = pair(7);
  said.ball_y = pair(9);
  said.task = bytes[11] == 255 ? -1 : bytes[11];
  if (said.task >= static_cast<std::int32_t>(roles)) return std::nullopt;
  for (std::size_t k = 0; k < (roles + 7) / 8; ++k) said.tasks[k] = bytes[12 + k];
  if (roles % 8 != 0 && said.tasks[roles / 8] >> roles % 8 != 0) return std::nullopt;
  return said;
}

}  // namespace b_human
