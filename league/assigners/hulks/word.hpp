// SPDX-License-Identifier: MIT
// Words as bytes: one bit for the kind, the time, the id of the task in as few bits as the team's table of roles needs.
// Four bytes for up to 64 roles. Sender, pose, ball and its age, which are in the HULKs' message besides, are in every
// packet anyway.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../negotiation/bits.hpp"
#include "claims.hpp"

namespace hulks {

inline unsigned task_bits(std::size_t roles) {
  return static_cast<unsigned>(std::bit_width(roles > 0 ? roles - 1 : std::size_t{0}));
}

inline std::size_t word_bytes(std::size_t roles) { return (1 + time_bits + task_bits(roles) + 7) / 8; }

// word.time <= never; the task of a claim is in [0, roles).
inline void write(const Word& word, std::size_t roles, std::vector<std::uint8_t>& bytes) {
  negotiation::BitWriter out(bytes);
  out.put(word.claims ? 1 : 0, 1);
  out.put(word.claims ? word.time : 0, time_bits);
  out.put(word.claims ? static_cast<std::uint32_t>(word.task) : 0, task_bits(roles));
}

// Any bytes; nothing when they are no word of this team.
inline std::optional<Word> read(std::span<const std::uint8_t> bytes, std::size_t roles) {
  negotiation::BitReader in(bytes);
  Word word;
  word.claims = in.get(1) == 1;
  word.time = in.get(time_bits);
  const std::uint32_t task = in.get(task_bits(roles));
  if (!in.complete() || task >= roles) return std::nullopt;
  if (!word.claims && (word.time != 0 || task != 0)) return std::nullopt;
  if (word.claims) word.task = static_cast<int>(task);
  return word;
}

}  // namespace hulks
