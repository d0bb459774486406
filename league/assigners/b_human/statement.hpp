// SPDX-License-Identifier: MIT
// What a robot says beside the core of its packet: which tasks it has to choose from. All else that the assignment
// needs is in the core, which the extension regista.told shows as it was sent.
//
// A bit for each role, set when it is a task now; a byte for eight roles, lowest bit first.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace b_human {

inline constexpr std::size_t most_roles = 254;  // of a team, by the host's packets

struct TaskList {
  std::array<std::uint8_t, (most_roles + 7) / 8> bits{};

  bool has(std::int32_t id) const {
    const auto row = static_cast<std::size_t>(id);
    return id >= 0 && row < most_roles && (bits[row / 8] >> row % 8 & 1u) != 0;
  }
  void add(std::int32_t id) {
    const auto row = static_cast<std::size_t>(id);
    if (id >= 0 && row < most_roles) bits[row / 8] = static_cast<std::uint8_t>(bits[row / 8] | 1u << row % 8);
  }
};

constexpr std::size_t statement_bytes(std::size_t roles) { return (roles + 7) / 8; }

// roles: rows of the team's table, at most most_roles. Replaces `out`.
inline void write(const TaskList& tasks, std::size_t roles, std::vector<std::uint8_t>& out) {
  out.assign(tasks.bits.begin(), tasks.bits.begin() + static_cast<std::ptrdiff_t>(statement_bytes(roles)));
}

// Nothing, if that are no bytes of this team: a wrong length, or roles that it does not have.
inline std::optional<TaskList> read(std::span<const std::uint8_t> bytes, std::size_t roles) {
  if (bytes.size() != statement_bytes(roles)) return std::nullopt;
  TaskList tasks;
  std::copy(bytes.begin(), bytes.end(), tasks.bits.begin());
  if (roles % 8 != 0 && tasks.bits[roles / 8] >> roles % 8 != 0) return std::nullopt;
  return tasks;
}

// What is compared or weighed is rounded as in a packet: all have the same numbers, and a robot at rest those that its
// teammates have of it.
inline std::int32_t millimetres(double metres) {
  return static_cast<std::int32_t>(std::clamp(std::round(1000.0 * metres), -32767.0, 32767.0));
}
inline double whole_hundredths(double seconds) { return std::round(100.0 * seconds) / 100.0; }

}  // namespace b_human
