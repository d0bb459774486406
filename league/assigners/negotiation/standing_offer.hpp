// SPDX-License-Identifier: MIT
// One segment that says how things stand now: it goes along with every packet, always in its newest form. So a packet
// that is lost costs time and nothing else, and nothing that is out of date waits in a queue.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <regista/mailbox.hpp>

namespace negotiation {

class StandingOffer {
 public:
  void setup(const regista::Mailbox& mailbox, std::size_t most_bytes) {
    mailbox_ = mailbox;
    said_.reserve(most_bytes);
  }
  // A new match: the host has forgotten all offers.
  void forget() {
    said_.clear();
    handle_ = 0;
  }
  // To be called at every decision. `urgency` 1: worth a packet of its own; `now`: time of the frame.
  void say(std::span<const std::uint8_t> bytes, double now, double urgency = 0.0) {
    constexpr double lasts = 10.0;  // s; then the next decision offers it again
    const bool same = urgency == urgency_ && std::equal(bytes.begin(), bytes.end(), said_.begin(), said_.end());
    if (handle_ != 0 && same) return;
    said_.assign(bytes.begin(), bytes.end());
    urgency_ = urgency;
    handle_ = mailbox_.offer(said_, urgency, now + lasts, handle_);
  }
  void withdraw() {
    if (handle_ != 0) mailbox_.withdraw(handle_);
    handle_ = 0;
  }
  // The plugin's transmitted() and dropped(): whether it was this offer.
  bool gone(std::uint64_t handle) {
    if (handle == 0 || handle != handle_) return false;
    handle_ = 0;
    return true;
  }
  // What was offered last.
  std::span<const std::uint8_t> said() const { return said_; }

 private:
  regista::Mailbox mailbox_;
  std::vector<std::uint8_t> said_;
  double urgency_ = 0.0;
  std::uint64_t handle_ = 0;  // 0: nothing is pending
};

}  // namespace negotiation
