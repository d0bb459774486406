// SPDX-License-Identifier: MIT
// Who does what, as robots tell each other: for every robot of the team the id of its task, or that it has none, or
// that it does not play. Ids are rows of the team's table of roles, so a map says the same to a robot that does not
// know all of the tasks. As few bits for each robot as the largest id needs: seven robots and 19 roles are 35 bits.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "bits.hpp"

namespace scram {

// In place of an id.
inline constexpr std::int32_t away = -2, idle = -1;

class MapCode {
 public:
  MapCode() = default;
  MapCode(std::size_t team_size, std::size_t roles) : team_size_(team_size), roles_(roles) {}

  std::size_t robots() const { return team_size_; }
  // Bytes of a map behind so many other bits.
  std::size_t bytes(std::size_t bits_before = 0) const { return (bits_before + team_size_ * bits_each() + 7) / 8; }

  // map[n - 1]: of robot n.
  void write(std::span<const std::int32_t> map, negotiation::BitWriter& out) const {
    assert(map.size() == team_size_);
    for (const std::int32_t task : map) out.put(static_cast<std::uint32_t>(task + 2), bits_each());
  }
  // Reads whatever was sent. False: no map of this team, which has such ids only and each once.
  bool read(negotiation::BitReader& in, std::span<std::int32_t> map) const {
    assert(map.size() == team_size_);
    bool sound = true;
    for (std::size_t robot = 0; robot < team_size_; ++robot) {
      map[robot] = static_cast<std::int32_t>(in.get(bits_each())) - 2;
      if (map[robot] < 0) continue;
      const auto before = map.first(robot);
      sound = sound && map[robot] < static_cast<std::int32_t>(roles_) &&
              std::find(before.begin(), before.end(), map[robot]) == before.end();
    }
    return sound && in.complete();
  }

 private:
  unsigned bits_each() const { return static_cast<unsigned>(std::bit_width(roles_ + 1)); }

  std::size_t team_size_ = 0, roles_ = 0;
};

}  // namespace scram
