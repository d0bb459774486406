// SPDX-License-Identifier: MIT
#include "mind/world/mailbox.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace regista::mind {
namespace {
constexpr std::size_t longest_core = 24 + 11 + 4 * Report::most_opponents;
constexpr std::size_t most_places = 256;
constexpr std::size_t most_pending = 64;  // offers of one instance
constexpr std::size_t longest_bytes = 255;
}  // namespace

struct Mailboxes::Endpoint {
  Mailboxes* owner = nullptr;
  std::size_t place = 0;
  regista_host host{};
  std::optional<plugin::Mailbox> mailbox;  // none when the plugin takes no messages
};

Mailboxes::Mailboxes(std::size_t packet_size) : packet_size_(packet_size) {
  constexpr std::size_t usual = 64;  // offers that wait; more take more memory
  waiting_.reserve(usual);
  dropped_.reserve(usual);
  telling_.reserve(usual);
  listed_.reserve(usual);
}
Mailboxes::~Mailboxes() = default;

const regista_host* Mailboxes::open() {
  Endpoint& endpoint = *endpoints_.emplace_back(std::make_unique<Endpoint>());
  endpoint.owner = this;
  endpoint.place = endpoints_.size() - 1;
  endpoint.host.size = sizeof endpoint.host;
  endpoint.host.context = &endpoint;
  endpoint.host.offer = [](void* context, const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                           std::int32_t medium, std::uint64_t replaces) {
    const auto* self = static_cast<Endpoint*>(context);
    return self->owner->offer(self->place, {bytes, count}, urgency, expiry, medium, replaces);
  };
  endpoint.host.withdraw = [](void* context, std::uint64_t handle) {
    const auto* self = static_cast<Endpoint*>(context);
    auto& waiting = self->owner->waiting_;
    const auto found = std::ranges::find_if(
        waiting, [&](const Waiting& each) { return each.offer.handle == handle && each.place == self->place; });
    if (found != waiting.end()) self->owner->drop(found);
  };
  endpoint.host.bytes_free = [](void* context) {
    return static_cast<std::uint32_t>(static_cast<Endpoint*>(context)->owner->longest_segment());
  };
  endpoint.host.extension = [](void*, const char*) -> const void* { return nullptr; };
  return &endpoint.host;
}

void Mailboxes::connect(const std::shared_ptr<plugin::Instance>& instance) {
  assert(!endpoints_.empty());
  endpoints_.back()->mailbox = plugin::Mailbox::of(instance);
}

std::size_t Mailboxes::longest_segment() const {
  const std::size_t used = longest_core + segment_heading;
  return packet_size_ > used ? std::min(packet_size_ - used, longest_bytes) : 0;
}

std::uint64_t Mailboxes::offer(std::size_t place, std::span<const std::uint8_t> bytes, double urgency, double expiry,
                               int medium, std::uint64_t replaces) {
  const bool sensible = place < most_places && bytes.size() <= longest_segment() && urgency >= 0.0 && urgency <= 1.0 &&
                        medium == REGISTA_MEDIUM_RADIO && expiry > now_ && (bytes.data() != nullptr || bytes.empty());
  if (!sensible) return 0;
  const auto replaced = std::ranges::find_if(waiting_, [&](const Waiting& each) {
    return replaces != 0 && each.offer.handle == replaces && each.place == place;
  });
  if (replaced != waiting_.end()) drop(replaced);
  const auto pending = std::ranges::count_if(waiting_, [&](const Waiting& each) { return each.place == place; });
  if (static_cast<std::size_t>(pending) >= most_pending) return 0;
  Waiting& waiting = waiting_.emplace_back();
  waiting.offer = {++last_handle_, static_cast<std::uint32_t>(bytes.size() + segment_heading), medium, urgency, expiry};
  waiting.place = place;
  std::ranges::copy(bytes, waiting.bytes.begin());
  return last_handle_;
}

// A plugin replaces and withdraws from within its own calls, and calls are never re-entrant: it is told later.
void Mailboxes::drop(std::vector<Waiting>::iterator offer) {
  dropped_.push_back({offer->offer.handle, offer->place});
  waiting_.erase(offer);
}

// What plugins drop while they are told is for the next time.
void Mailboxes::tell_dropped() {
  telling_.swap(dropped_);
  for (const Dropped& each : telling_) {
    Endpoint& endpoint = *endpoints_[each.place];
    if (endpoint.mailbox) endpoint.mailbox->dropped(each.handle);
  }
  telling_.clear();
}

void Mailboxes::begin(double now) {
  now_ = now;
  for (auto each = waiting_.begin(); each != waiting_.end();) {
    if (each->offer.expiry > now) {
      ++each;
      continue;
    }
    dropped_.push_back({each->offer.handle, each->place});
    each = waiting_.erase(each);
  }
  tell_dropped();
}

std::span<const regista_offer> Mailboxes::pending() {
  tell_dropped();
  listed_.clear();
  for (const Waiting& waiting : waiting_) listed_.push_back(waiting.offer);
  return listed_;
}

std::uint32_t Mailboxes::bytes_free() const {
  return static_cast<std::uint32_t>(packet_size_ > longest_core ? packet_size_ - longest_core : 0);
}

void Mailboxes::load(std::span<const std::uint64_t> granted, std::vector<std::uint8_t>& packet) {
  for (const std::uint64_t handle : granted) {
    const auto found = std::ranges::find_if(waiting_, [&](const Waiting& each) { return each.offer.handle == handle; });
    if (found == waiting_.end() || packet.size() + found->offer.bytes > packet_size_) continue;
    const std::span<const std::uint8_t> bytes(found->bytes.data(), found->offer.bytes - segment_heading);
    append_segment({static_cast<int>(found->place), bytes}, packet);
    Endpoint& endpoint = *endpoints_[found->place];
    waiting_.erase(found);
    if (endpoint.mailbox) endpoint.mailbox->transmitted(handle);
  }
}

void Mailboxes::deliver(const Segment& segment, int sender, double time_sent, double time_heard) {
  const auto place = static_cast<std::size_t>(segment.place);
  if (place >= endpoints_.size() || !endpoints_[place]->mailbox) return;
  regista_message message{};
  message.sender = sender;
  message.medium = REGISTA_MEDIUM_RADIO;
  message.time_sent = time_sent;
  message.time_heard = time_heard;
  message.bytes = segment.bytes.data();
  message.count = static_cast<std::uint32_t>(segment.bytes.size());
  endpoints_[place]->mailbox->receive(message);
}

}  // namespace regista::mind
