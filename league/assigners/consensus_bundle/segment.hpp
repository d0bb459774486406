// SPDX-License-Identifier: MIT
// What a robot says in each of its packets: whom it takes for the winner of each task, and how old its news of each
// robot are. Segments are read as a stranger may have written them.
//
//   epoch                      8 bits
//   for each robot             8 bits: age of the newest news of it in ticks of 0.1 s, 255 = older or none; the sender
//                              in its own place: the lowest bits of the tick at which it wrote this
//   for each role of the team  1 bit: somebody wins it
//   for each won task          its winner's number, and a bid of 12 bits, >= 1
//
// A number has 4 bits, more in teams of more than 15. Tasks are named by their rows in the table of roles, so the bits
// for each role leave out those that nobody wins: seven robots that win a task each, of nineteen roles, take 25 bytes.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../negotiation/bits.hpp"
#include "consensus.hpp"

namespace consensus_bundle {

// Ticks are common to all robots, so that they compare ages without rounding.
inline std::int64_t tick_of(double time) { return std::llround(10.0 * time); }

class Segment {
 public:
  static constexpr unsigned bid_bits = 12;
  static constexpr std::uint32_t most_bid = (1u << bid_bits) - 1u;

  void setup(std::size_t robots, std::size_t tasks) {
    robots_ = robots;
    tasks_ = tasks;
    winner_bits_ = std::max(4u, static_cast<unsigned>(std::bit_width(robots)));
  }
  // Of a segment with so many won tasks.
  std::size_t bytes(std::size_t won) const {
    return (8 + 8 * robots_ + tasks_ + won * (winner_bits_ + bid_bits) + 7) / 8;
  }

  // now: tick of the decision, >= all stamps.
  void write(std::uint8_t epoch, int own, std::int64_t now, std::span<const Claim> claims,
             std::span<const std::int64_t> stamps, std::vector<std::uint8_t>& out) const {
    negotiation::BitWriter writer(out);
    writer.put(epoch, 8);
    for (std::size_t k = 0; k < robots_; ++k) {
      const bool is_own = static_cast<int>(k) + 1 == own;
      writer.put(is_own ? static_cast<std::uint32_t>(now & 255) : age_of(now, stamps[k]), 8);
    }
    for (const Claim& claim : claims) writer.put(claim.winner == nobody ? 0 : 1, 1);
    for (const Claim& claim : claims) {
      if (claim.winner == nobody) continue;
      writer.put(static_cast<std::uint32_t>(claim.winner), winner_bits_);
      writer.put(claim.bid, bid_bits);
    }
  }

  // sent: tick of the packet. False: not what a robot of this team would say.
  bool read(std::span<const std::uint8_t> bytes, int sender, std::int64_t sent, std::uint8_t& epoch, Told& out) const {
    if (sender < 1 || sender > static_cast<int>(robots_) || bytes.size() < this->bytes(0)) return false;
    negotiation::BitReader reader(bytes);
    epoch = static_cast<std::uint8_t>(reader.get(8));
    out.sender = sender;
    out.stamps.resize(robots_);
    for (std::int64_t& stamp : out.stamps) stamp = reader.get(8);
    const std::int64_t low = out.stamps[static_cast<std::size_t>(sender - 1)];
    out.sent = sent - ((sent - low) & 255);  // written at most 25 s before it was sent: an offer does not wait so long
    for (std::int64_t& stamp : out.stamps) stamp = stamp == older ? never : out.sent - stamp;
    out.stamps[static_cast<std::size_t>(sender - 1)] = out.sent;
    out.claims.resize(tasks_);
    for (Claim& claim : out.claims) claim = {static_cast<int>(reader.get(1)), 0};
    for (Claim& claim : out.claims) {
      if (claim.winner == 0) continue;
      claim.winner = static_cast<int>(reader.get(winner_bits_));
      claim.bid = reader.get(bid_bits);
      if (claim.winner == nobody || claim.winner > static_cast<int>(robots_) || claim.bid == 0) return false;
    }
    return reader.complete();
  }

 private:
  static constexpr std::uint32_t older = 255;
  static std::uint32_t age_of(std::int64_t now, std::int64_t stamp) {
    if (stamp == never || now - stamp >= older) return older;
    return static_cast<std::uint32_t>(std::max<std::int64_t>(0, now - stamp));
  }

  std::size_t robots_ = 0, tasks_ = 0;
  unsigned winner_bits_ = 4;
};

}  // namespace consensus_bundle
