// SPDX-License-Identifier: MIT
// The air between the robots of one team: a broadcast with a fixed delay, jitter by a uniform law, and loss, each drawn
// per receiver. Whether a packet may be sent and what it costs is the referee's business.
//
// What goes wrong with it besides: a packet is late by the worse of what ails its sender and its receiver, and is lost
// by what ails its receiver. It does not exist where either is silent when it is sent, and passes by a receiver that is
// silent at the decision at which it would hear it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "match/side.hpp"
#include "match/trouble.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

class Radio {
 public:
  // trouble: of this side; the caller's, and must live as long.
  Radio(const config::Radio& profile, const Trouble& trouble, int team_size, std::uint64_t seed, Side side);

  // Robot `sender` (number) sends; the bytes are copied.
  void send(int sender, std::span<const std::uint8_t> bytes, double time, std::uint32_t tick);

  // Appends to `out` what robot `receiver` has heard by `time`, ordered by (time heard, sender). A packet is never
  // heard in the tick in which it was sent. The bytes live until the next send.
  void deliver(int receiver, double time, std::uint32_t tick, std::vector<mind::HeardPacket>& out);

 private:
  struct Packet {
    std::vector<std::uint8_t> bytes;
    int sender = 0;
    std::uint32_t tick = 0;
    std::uint32_t waiting = 0;  // bit n - 1: robot n has yet to hear it
    std::array<double, largest_team> heard{};
  };

  config::Radio profile_;  // with what disturbs all robots all the time
  const Trouble* trouble_;
  int team_size_;
  std::uint64_t seed_;
  Side side_;
  std::vector<Packet> packets_;  // pool
  std::vector<std::size_t> in_flight_, free_;
  std::vector<int> senders_;  // of the packets of one delivery
};

}  // namespace regista::match
