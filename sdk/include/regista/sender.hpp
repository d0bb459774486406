// SPDX-License-Identifier: MIT
// A sender decides when to spend one of the team's packets, and which offers of other plugins go along (the events e of
// the paper). The class has
//
//   std::optional<int> decide(const regista::Frame&, const regista::SendQuery&, regista::Grants out);
//
// which returns the reason (REGISTA_EVENT_*) to send a packet now, or nothing. Reasons of its own have names,
//
//   static constexpr std::array<const char*, N> reasons{"lost_bid", ...};       returned as regista::own_reason(index)
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include <regista/plugin.hpp>

namespace regista {

using Event = regista_event;
using Offer = regista_offer;
using Budget = regista_budget;

// budget.line falls evenly over the time in which a team may send: of 1200 packets 1154 at the first whistle, 577 at
// the second, 0 at the end. Who keeps packets_left above it has enough to the end.
struct SendQuery {
  Span<Event> events;  // since the last decision
  Span<Offer> offers;  // pending
  const Budget& budget;
};

// What a number of packets of a whole match is in this game; some stay some, so that a reserve remains one. Exactly
// `packets` in a whole match, and where the host tells of no share.
inline int in_this_game(int packets, const Budget& budget) {
  const bool told = budget.size >= offsetof(Budget, share) + sizeof budget.share;
  if (!told || !(budget.share > 0.0 && budget.share < 1.0)) return packets;
  constexpr double rounding = 1e-9;
  return static_cast<int>(std::ceil(packets * budget.share - rounding));
}

// Offers to take along, in this order; those that do not fit stay pending.
class Grants {
 public:
  Grants(regista_send& raw, std::size_t capacity) : raw_(&raw), capacity_(capacity) {}
  void grant(const Offer& offer) {
    if (raw_->granted_count == capacity_) throw std::length_error("granted more offers than there are");
    raw_->granted[raw_->granted_count++] = offer.handle;
  }

 private:
  regista_send* raw_;
  std::size_t capacity_;
};

constexpr int own_reason(std::size_t index) { return REGISTA_REASON_OWN + static_cast<int>(index); }

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct sender {
  static constexpr std::int32_t kind = REGISTA_KIND_SENDER;

  template <class Class>
  static constexpr std::uint32_t reason_count() {
    if constexpr (requires { Class::reasons; }) {
      return static_cast<std::uint32_t>(Class::reasons.size());
    } else {
      return 0;
    }
  }
  template <class Class>
  static constexpr const char* const* reasons() {
    if constexpr (requires { Class::reasons; }) {
      return Class::reasons.data();
    } else {
      return nullptr;
    }
  }

  template <class Class>
  static const void* table() {
    static constexpr regista_sender calls{
        sizeof(regista_sender), reason_count<Class>(),
        [](void* instance, const regista_frame* frame, regista_span events, regista_span offers,
           const regista_budget* budget, regista_send* out, regista_error* error) {
          return detail::guarded(error, [&] {
            const std::optional<int> reason = static_cast<Class*>(instance)->decide(
                Frame(*frame), SendQuery{Span<Event>(events), Span<Offer>(offers), *budget},
                Grants(*out, offers.count));
            out->send = reason ? 1 : 0;
            out->reason = reason.value_or(REGISTA_EVENT_PERIOD);
          });
        },
        reasons<Class>()};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
