// SPDX-License-Identifier: MIT
// Radio simulates the radio channel of one team. A packet goes to all teammates. For each receiver the delay has a
// fixed part and uniform jitter, and the packet may be lost. The referee says who may send, and counts packets.
//
// Disturbances of delay and jitter: the larger value of sender and receiver counts. Disturbances of loss: the
// receiver's value counts. A receiver does not get a packet if the sender or the receiver is silent at the time of
// sending, or if the receiver is silent at the time of hearing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "match/disturbances.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

class Radio {
 public:
  // trouble: disturbances of this side. The caller owns `trouble`, which must outlive the radio.
  Radio(const config::Radio& profile, const Disturbances& trouble, int team_size, std::uint64_t seed, Side side);

  // Robot number `sender` sends a packet. send() copies the bytes.
  void send(int sender, std::span<const std::uint8_t> bytes, double time, std::uint32_t tick);

  // Appends to `out` the packets that robot `receiver` has heard since the last call, ordered by (time heard, sender).
  // A packet is never heard in the physics step in which it was sent. The bytes are valid until the next send().
  void deliver(int receiver, double time, std::uint32_t tick, std::vector<mind::HeardPacket>& out);

 private:
  struct Packet {
    std::vector<std::uint8_t> bytes;
    int sender = 0;
    std::uint32_t tick = 0;
    std::uint32_t waiting = 0;                 // bit n - 1 is 1 if robot n will hear the packet later
    std::array<double, largest_team> heard{};  // by robot (n - 1): time of hearing, s
  };

  config::Radio profile_;  // radio profile plus the permanent radio disturbance of all robots
  const Disturbances* trouble_;
  int team_size_;
  std::uint64_t seed_;
  Side side_;
  std::vector<Packet> packets_;                // pool: a packet is reused after all receivers heard it
  std::vector<std::size_t> in_flight_, free_;  // indices into packets_
  std::vector<int> senders_;                   // senders of the packets that deliver() appends
};

}  // namespace regista::match
