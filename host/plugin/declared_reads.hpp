// SPDX-License-Identifier: MIT
// A frame as somebody sees it who reads only what it declares (REGISTA_READS_*): the rest is null, empty or NaN. So a
// plugin that reads more than it says is found out before a host leaves that out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <regista/abi.h>

namespace regista::plugin {

class DeclaredReads {
 public:
  explicit DeclaredReads(std::uint32_t reads) : reads_(reads) {}

  // A copy that leads to copies where something is left out. Valid until the next call.
  const regista_frame* of(const regista_frame& frame);

 private:
  struct World {
    regista_world raw{};
    regista_ball ball{};
    std::vector<regista_robot> robots;
    std::vector<regista_opponent> opponents;
  };
  bool reads(std::uint32_t part) const { return (reads_ & part) != 0; }
  const regista_world* shown(const regista_world& whole, std::uint32_t opponents, World& copy) const;

  std::uint32_t reads_;
  regista_frame frame_{};
  std::array<World, 2> worlds_;
  std::vector<regista_task> tasks_;
};

}  // namespace regista::plugin
