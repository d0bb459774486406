// SPDX-License-Identifier: MIT
// The tokens that a robot answers for, as bytes: in a team of seven with 19 roles five bytes each. How many there are
// follows from the length. A receiver bears any bytes. It takes no token of a message in which one makes no sense; of a
// message that was cut off it takes the tokens that are whole, if the bits left over happen to be 0.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/bits.hpp"
#include "token.hpp"

namespace token_passing {

// Both sides must have the same: it follows from team and parameters.
struct Layout {
  int team_size = 0, tokens = 0, rounds = 0;  // ids are 0..tokens - 1, rounds 0..rounds

  unsigned id_bits() const { return width(tokens - 1); }
  unsigned number_bits() const { return width(team_size - 1); }
  unsigned round_bits() const { return width(rounds); }
  unsigned told_bits() const {
    return id_bits() + 2 * number_bits() + round_bits() + 8 + 8 + 2 + static_cast<unsigned>(team_size);
  }
  std::size_t bytes(std::size_t told) const { return (told * told_bits() + 7) / 8; }
  // Most tokens that fit.
  std::size_t most(std::size_t bytes) const { return 8 * bytes / told_bits(); }

 private:
  static unsigned width(int largest) {
    return static_cast<unsigned>(std::bit_width(static_cast<unsigned>(std::max(largest, 0))));
  }
};

// Fills `bytes` from its beginning.
inline void write(const Layout& layout, std::span<const Told> all, std::vector<std::uint8_t>& bytes) {
  negotiation::BitWriter out(bytes);
  for (const Told& each : all) {
    const Token& token = each.token;
    out.put(static_cast<std::uint32_t>(each.id), layout.id_bits());
    out.put(token.creator - 1u, layout.number_bits());
    out.put(token.holder - 1u, layout.number_bits());
    out.put(token.generation, 8);
    out.put(token.hop, 8);
    out.put(token.round, layout.round_bits());
    out.put(token.kept ? 1 : 0, 1);
    out.put(token.done ? 1 : 0, 1);
    out.put(token.visited, static_cast<unsigned>(layout.team_size));
  }
}

// False: these bytes are no message of `sender`. sender 0: anybody's. Only the holder can say that it does the task or
// that there is none.
inline bool read(const Layout& layout, int sender, std::span<const std::uint8_t> bytes, std::vector<Told>& all) {
  all.clear();
  const std::size_t count = layout.most(bytes.size());
  if (count == 0 || count > static_cast<std::size_t>(layout.tokens)) return false;
  negotiation::BitReader in(bytes);
  for (std::size_t i = 0; i < count; ++i) {
    Told each;
    each.id = static_cast<int>(in.get(layout.id_bits()));
    each.token.creator = static_cast<std::uint8_t>(in.get(layout.number_bits()) + 1);
    each.token.holder = static_cast<std::uint8_t>(in.get(layout.number_bits()) + 1);
    each.token.generation = static_cast<std::uint8_t>(in.get(8));
    each.token.hop = static_cast<std::uint8_t>(in.get(8));
    each.token.round = static_cast<std::uint8_t>(in.get(layout.round_bits()));
    each.token.kept = in.get(1) != 0;
    each.token.done = in.get(1) != 0;
    each.token.visited = in.get(static_cast<unsigned>(layout.team_size));
    const Token& token = each.token;
    const bool fits = each.id < layout.tokens && token.creator <= layout.team_size &&
                      token.holder <= layout.team_size && token.round <= layout.rounds && !(token.kept && token.done);
    const bool may_say = sender == 0 || token.holder == sender || !(token.kept || token.done);
    const bool first = std::ranges::none_of(all, [&](const Told& other) { return other.id == each.id; });
    if (!fits || !may_say || !first) {
      all.clear();
      return false;
    }
    all.push_back(each);
  }
  if (!in.complete()) all.clear();
  return !all.empty();
}

}  // namespace token_passing
