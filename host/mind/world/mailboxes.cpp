// SPDX-License-Identifier: MIT
#include "mind/world/mailboxes.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace regista::mind {
namespace {
constexpr std::size_t longest_core = 24 + 11 + 4 * Report::most_opponents;
constexpr std::size_t most_places = 256;
constexpr std::size_t most_pending = 64;  // greatest number of waiting offers of one instance
constexpr std::size_t longest_bytes = 255;
constexpr std::size_t longest_journal = 1024;  // events of one decision; a plugin may make any number of offers

using Kind = SegmentEvent::Kind;
using Why = SegmentEvent::Why;
}  // namespace

struct Mailboxes::Endpoint {
  Mailboxes* owner = nullptr;
  std::size_t place = 0;
  regista_host host{};
  const char* plugin = "";
  const InstanceExtensions* extensions = nullptr;
  const plugin::Instance* instance = nullptr;
  std::optional<plugin::Mailbox> mailbox;  // empty: the plugin takes no messages
};

Mailboxes::Mailboxes(std::size_t packet_size, bool keeps_journal)
    : packet_size_(packet_size), keeps_journal_(keeps_journal) {
  constexpr std::size_t usual = 64;  // memory is reserved for this number of waiting offers
  waiting_.reserve(usual);
  dropped_.reserve(usual);
  telling_.reserve(usual);
  listed_.reserve(usual);
}
Mailboxes::~Mailboxes() = default;

const regista_host* Mailboxes::open(const InstanceExtensions* extensions) {
  Endpoint& endpoint = *endpoints_.emplace_back(std::make_unique<Endpoint>());
  endpoint.owner = this;
  endpoint.extensions = extensions;
  endpoint.place = endpoints_.size() - 1;
  endpoint.host.size = sizeof endpoint.host;
  endpoint.host.context = &endpoint;
  endpoint.host.offer = [](void* context, const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                           std::int32_t medium, std::uint64_t replaces) {
    const auto* self = static_cast<Endpoint*>(context);
    if (self->owner->describing_) return std::uint64_t{0};
    const std::span<const std::uint8_t> offered(bytes, count);
    const std::uint64_t handle = self->owner->offer(self->place, offered, urgency, expiry, medium, replaces);
    // The recording gets the bytes of an accepted offer only, because the bytes of a refused offer may be invalid.
    if (self->instance != nullptr)
      self->instance->used("offer", handle, offered.first(handle == 0 ? 0 : count), urgency, expiry, replaces);
    return handle;
  };
  endpoint.host.withdraw = [](void* context, std::uint64_t handle) {
    const auto* self = static_cast<Endpoint*>(context);
    if (self->owner->describing_) return;
    if (self->instance != nullptr) self->instance->used("withdraw", handle);
    auto& waiting = self->owner->waiting_;
    const auto found = std::ranges::find_if(
        waiting, [&](const Waiting& each) { return each.offer.handle == handle && each.place == self->place; });
    if (found != waiting.end()) self->owner->drop(found, Why::withdrawn);
  };
  endpoint.host.bytes_free = [](void* context) {
    return static_cast<std::uint32_t>(static_cast<Endpoint*>(context)->owner->longest_segment());
  };
  endpoint.host.extension = [](void* context, const char* id) -> const void* {
    const InstanceExtensions* const own = static_cast<Endpoint*>(context)->extensions;
    return own == nullptr || id == nullptr ? nullptr : own->find(id);
  };
  return &endpoint.host;
}

void Mailboxes::connect(const std::shared_ptr<plugin::Instance>& instance) {
  assert(!endpoints_.empty());
  endpoints_.back()->plugin = instance->plugin().descriptor->id;
  endpoints_.back()->instance = instance.get();
  endpoints_.back()->mailbox = plugin::Mailbox::of(instance);
}

std::size_t Mailboxes::longest_segment() const {
  const std::size_t used = longest_core + segment_heading;
  return packet_size_ > used ? std::min(packet_size_ - used, longest_bytes) : 0;
}

std::uint64_t Mailboxes::offer(std::size_t place, std::span<const std::uint8_t> bytes, double urgency, double expiry,
                               int medium, std::uint64_t replaces) {
  const auto replaced = std::ranges::find_if(waiting_, [&](const Waiting& each) {
    return replaces != 0 && each.offer.handle == replaces && each.place == place;
  });
  const bool replaces_one = replaced != waiting_.end();
  const auto pending = std::ranges::count(waiting_, place, &Waiting::place);
  Why wrong = Why::none;
  if (!replaces_one && static_cast<std::size_t>(pending) >= most_pending) wrong = Why::too_many_pending;
  if (place >= most_places) wrong = Why::too_many_places;
  if (bytes.size() > longest_segment()) wrong = Why::too_long;
  if (!(expiry > now_)) wrong = Why::expired;
  const bool sensible =
      urgency >= 0.0 && urgency <= 1.0 && medium == REGISTA_MEDIUM_RADIO && (bytes.data() != nullptr || bytes.empty());
  if (!sensible) wrong = Why::senseless;
  const auto note_offer = [&](Kind kind, std::uint64_t handle) {
    SegmentEvent* const event = note(kind, wrong, place);
    if (event == nullptr) return;
    event->handle = handle;
    event->urgency = urgency;
    event->expiry = expiry;
    event->length = bytes.size();
    // An offer of more than longest_bytes is recorded without its bytes, because no packet could contain the offer.
    if (bytes.data() != nullptr && bytes.size() <= longest_bytes) event->bytes.assign(bytes.begin(), bytes.end());
  };
  if (wrong != Why::none) {
    ++counts_.refused;
    note_offer(Kind::refused, 0);
    return 0;
  }
  ++last_handle_;
  if (replaces_one) drop(replaced, Why::replaced);
  Waiting& waiting = waiting_.emplace_back();
  waiting.offer = {last_handle_, static_cast<std::uint32_t>(bytes.size() + segment_heading), medium, urgency, expiry};
  waiting.place = place;
  std::ranges::copy(bytes, waiting.bytes.begin());
  ++counts_.offered;
  note_offer(Kind::offered, last_handle_);
  return last_handle_;
}

// tell_dropped() tells the plugin later, because drop() may run within a call of this plugin: calls are not re-entrant.
std::vector<Mailboxes::Waiting>::iterator Mailboxes::drop(std::vector<Waiting>::iterator offer, Why why) {
  dropped_.push_back({offer->offer.handle, offer->place});
  ++counts_.dropped;
  if (SegmentEvent* const event = note(Kind::dropped, why, offer->place)) {
    event->handle = offer->offer.handle;
    if (why == Why::replaced) event->replaced_by = last_handle_;
  }
  return waiting_.erase(offer);
}

SegmentEvent* Mailboxes::note(Kind kind, Why why, std::size_t place) {
  if (!keeps_journal_ || journal_.size() >= longest_journal) return nullptr;
  return &add(kind, why, static_cast<int>(place));
}

SegmentEvent& Mailboxes::add(Kind kind, Why why, int place) {
  SegmentEvent& event = journal_.emplace_back();
  event.kind = kind;
  event.why = why;
  event.time = now_;
  event.place = place;
  return event;
}

SegmentCounts Mailboxes::take_counts() { return std::exchange(counts_, {}); }

void Mailboxes::complete_journal() {
  describing_ = true;  // describe() must change neither the match nor the journal, so offers are ignored
  for (SegmentEvent& event : journal_) {
    if (event.place < 0 || static_cast<std::size_t>(event.place) >= endpoints_.size()) continue;
    Endpoint& endpoint = *endpoints_[static_cast<std::size_t>(event.place)];
    event.plugin = endpoint.plugin;
    const bool whole = event.bytes.size() == event.length;
    if ((event.kind == Kind::offered || event.kind == Kind::refused) && whole && endpoint.mailbox) {
      // A failure of describe() must not end the match, because the match does not depend on the recording.
      try {
        event.text = endpoint.mailbox->describe(event.bytes);
      } catch (const plugin::Failure& failure) {
        event.text = "describe failed: " + failure.message();
      }
    }
  }
  describing_ = false;
}

// Reports dropped offers to the plugins. If a plugin drops an offer during this call, the next call reports the drop.
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
  // The first decision also has the events of the creation of plugins.
  if (std::exchange(begun_, true)) journal_.clear();
  for (auto each = waiting_.begin(); each != waiting_.end();) {
    each = each->offer.expiry > now ? each + 1 : drop(each, Why::expired);
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
  int at = 0;
  for (const std::uint64_t handle : granted) {
    const auto found = std::ranges::find_if(waiting_, [&](const Waiting& each) { return each.offer.handle == handle; });
    if (found == waiting_.end() || packet.size() + found->offer.bytes > packet_size_) continue;
    const std::span<const std::uint8_t> bytes(found->bytes.data(), found->offer.bytes - segment_heading);
    append_segment({static_cast<int>(found->place), bytes}, packet);
    Endpoint& endpoint = *endpoints_[found->place];
    ++counts_.sent;
    counts_.bytes += found->offer.bytes;
    if (SegmentEvent* const event = note(Kind::sent, Why::none, found->place)) {
      event->handle = handle;
      event->at = at;
    }
    ++at;
    waiting_.erase(found);
    if (endpoint.mailbox) endpoint.mailbox->transmitted(handle);
  }
}

void Mailboxes::deliver(const Segment& segment, int at, int sender, double time_sent, double time_heard) {
  const auto place = static_cast<std::size_t>(segment.place);
  const bool known = place < endpoints_.size();
  const bool taken = known && endpoints_[place]->mailbox;
  if (taken) ++counts_.heard;
  const Why why = taken ? Why::none : known ? Why::no_mailbox : Why::unknown_place;
  if (SegmentEvent* const event = note(taken ? Kind::heard : Kind::undelivered, why, place)) {
    event->bytes.assign(segment.bytes.begin(), segment.bytes.end());
    event->at = at;
    event->sender = sender;
    event->time_sent = time_sent;
    event->time_heard = time_heard;
  }
  if (!taken) return;
  regista_message message{};
  message.sender = sender;
  message.medium = REGISTA_MEDIUM_RADIO;
  message.time_sent = time_sent;
  message.time_heard = time_heard;
  message.bytes = segment.bytes.data();
  message.count = static_cast<std::uint32_t>(segment.bytes.size());
  endpoints_[place]->mailbox->receive(message);
}

void Mailboxes::wrong_length(int sender, double time_sent, double time_heard) {
  if (!keeps_journal_) return;
  SegmentEvent& event = add(Kind::undelivered, Why::wrong_length, -1);
  event.sender = sender;
  event.time_sent = time_sent;
  event.time_heard = time_heard;
}

}  // namespace regista::mind
