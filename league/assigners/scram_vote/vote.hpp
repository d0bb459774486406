// SPDX-License-Identifier: MIT
// The vote on a map of MacAlpine, Barrera and Stone, "Positioning to Win" (RoboCup 2012): robots whose beliefs differ
// compute different maps of robots to tasks; each tells its own, and all play the one that most of the newest maps
// name.
//
// Ours: of equally many votes the map wins that has the voter with the lowest number; and which votes do not count.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "../negotiation/told_map.hpp"

namespace scram {

// The newest map of every teammate.
class BallotBox {
 public:
  void reserve(const MapCode& code) {
    code_ = code;
    maps_.assign(code.robots() * code.robots(), away);
    heard_.reserve(code.robots());
    times_.assign(code.robots(), never);
    counted_.assign(code.robots(), 0);
  }
  void clear() { std::fill(times_.begin(), times_.end(), never); }

  // Bytes that are no map of this team, overtaken ones and those of nobody are ignored.
  void put(int sender, std::span<const std::uint8_t> bytes, double time_sent) {
    if (sender < 1 || sender > static_cast<int>(code_.robots())) return;
    double& time = times_[static_cast<std::size_t>(sender - 1)];
    if (time_sent < time) return;
    negotiation::BitReader in(bytes);
    heard_.resize(code_.robots());
    if (!code_.read(in, heard_)) return;
    time = time_sent;
    std::copy(heard_.begin(), heard_.end(), map_of(sender).begin());
  }

  // own_map := the map with the most votes, the own one and those of teammates that were sent at or after `since` and
  // of which counts(voter, map) holds.
  template <class Counts>
  void elect(int own, std::span<std::int32_t> own_map, double since, const Counts& counts) {
    const int voters = static_cast<int>(code_.robots());
    assert(own >= 1 && own <= voters && own_map.size() == code_.robots());
    std::copy(own_map.begin(), own_map.end(), map_of(own).begin());
    for (int voter = 1; voter <= voters; ++voter) {
      counted_[static_cast<std::size_t>(voter - 1)] =
          voter == own || (times_[static_cast<std::size_t>(voter - 1)] >= since && counts(voter, as_read(voter)));
    }
    int most = 0;
    for (int voter = 1; voter <= voters; ++voter) {  // ascending: the first of equals has the lowest voter
      if (const int votes = votes_for(voter); votes > most) {
        most = votes;
        const std::span<const std::int32_t> map = as_read(voter);
        std::copy(map.begin(), map.end(), own_map.begin());
      }
    }
  }

 private:
  static constexpr double never = -std::numeric_limits<double>::infinity();

  std::span<std::int32_t> map_of(int voter) {
    return std::span(maps_).subspan(static_cast<std::size_t>(voter - 1) * code_.robots(), code_.robots());
  }
  std::span<const std::int32_t> as_read(int voter) { return map_of(voter); }
  int votes_for(int candidate) {
    if (counted_[static_cast<std::size_t>(candidate - 1)] == 0) return 0;
    const std::span<const std::int32_t> map = map_of(candidate);
    int votes = 0;
    for (int voter = 1; voter <= static_cast<int>(code_.robots()); ++voter) {
      const std::span<const std::int32_t> other = map_of(voter);
      const bool same = std::equal(map.begin(), map.end(), other.begin());
      votes += same && counted_[static_cast<std::size_t>(voter - 1)] != 0 ? 1 : 0;
    }
    return votes;
  }

  MapCode code_;
  std::vector<std::int32_t> maps_, heard_;  // maps: voter by voter
  std::vector<double> times_;               // when they were sent
  std::vector<std::uint8_t> counted_;
};

}  // namespace scram
