// SPDX-License-Identifier: MIT
#include "match/radio.hpp"

#include <algorithm>
#include <utility>

#include "match/chance.hpp"

namespace regista::match {

Radio::Radio(const config::Radio& profile, const Disturbances& trouble, int team_size, std::uint64_t seed, Side side)
    : profile_(profile), trouble_(&trouble), team_size_(team_size), seed_(seed), side_(side) {
  const config::Disturbance::Radio& disturbance = trouble.disturbance().radio;
  profile_.delay += disturbance.delay;
  profile_.jitter += disturbance.jitter;
  profile_.loss = either(profile.loss, disturbance.loss);
  // The pool is larger than the usual number of packets in the air, so send() allocates no memory in the game.
  constexpr std::size_t longest = 512, per_robot = 8;
  packets_.resize(per_robot * at(team_size));
  for (std::size_t slot = packets_.size(); slot-- > 0;) {
    packets_[slot].bytes.reserve(longest);
    free_.push_back(slot);
  }
  in_flight_.reserve(packets_.size());
  senders_.reserve(packets_.size());
}

void Radio::send(int sender, std::span<const std::uint8_t> bytes, double time, std::uint32_t tick) {
  const Affliction& here = trouble_->of(sender);
  if (here.silent) return;
  if (free_.empty()) {
    free_.push_back(packets_.size());
    packets_.emplace_back();
  }
  const std::size_t slot = free_.back();
  Packet& packet = packets_[slot];
  packet.waiting = 0;
  for (int number = 1; number <= team_size_; ++number) {
    if (number == sender) continue;
    const Affliction& there = trouble_->of(number);
    if (there.silent) continue;
    if (const double lost = either(profile_.loss, there.loss); lost > 0.0) {
      Chance loss(seed_, Purpose::radio_loss, side_, number, sender, tick);
      if (loss.bernoulli(lost)) continue;
    }
    Chance chance(seed_, Purpose::radio_delay, side_, number, sender, tick);
    const double delay = profile_.delay + std::max(here.delay, there.delay);
    const double jitter = profile_.jitter + std::max(here.jitter, there.jitter);
    packet.heard[at(number - 1)] = time + delay + jitter * chance.uniform();
    packet.waiting |= 1u << (number - 1);
  }
  if (packet.waiting == 0) return;
  packet.bytes.assign(bytes.begin(), bytes.end());
  packet.sender = sender;
  packet.tick = tick;
  free_.pop_back();
  in_flight_.push_back(slot);
}

void Radio::deliver(int receiver, double time, std::uint32_t tick, std::vector<mind::HeardPacket>& out) {
  if (in_flight_.empty()) return;
  const std::uint32_t bit = 1u << (receiver - 1);
  const bool deaf = trouble_->of(receiver).silent;
  const std::size_t first = out.size();
  senders_.clear();
  std::size_t kept = 0;
  for (const std::size_t slot : in_flight_) {
    Packet& packet = packets_[slot];
    const double heard = packet.heard[static_cast<std::size_t>(receiver - 1)];
    if ((packet.waiting & bit) != 0 && heard <= time && packet.tick != tick) {
      packet.waiting &= ~bit;
      if (!deaf) {
        out.push_back({heard, packet.bytes});
        senders_.push_back(packet.sender);
      }
      for (std::size_t i = senders_.size(); i-- > 1;) {
        mind::HeardPacket &before = out[first + i - 1], &after = out[first + i];
        if (std::pair(before.time_heard, senders_[i - 1]) <= std::pair(after.time_heard, senders_[i])) break;
        std::swap(before, after);
        std::swap(senders_[i - 1], senders_[i]);
      }
    }
    if (packet.waiting != 0) {
      in_flight_[kept++] = slot;
    } else {
      free_.push_back(slot);
    }
  }
  in_flight_.resize(kept);
}

}  // namespace regista::match
