// SPDX-License-Identifier: MIT
#include "plugin/sender.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace regista::plugin {
constexpr std::size_t most_at_first = 64;  // offers, before the room grows

Sender::Sender(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_sender>(REGISTA_KIND_SENDER)) {
  instance_->rooms().granted.open(most_at_first);
}

SendDecision Sender::decide(const regista_frame& frame, std::span<const regista_event> events,
                            std::span<const regista_offer> offers, const regista_budget& budget) {
  GuardedValue<regista_send>& answer = instance_->rooms().send;
  GuardedRoom<std::uint64_t>& handles = instance_->rooms().granted;
  *instance_->open(answer) = {sizeof(regista_send), 0, REGISTA_EVENT_PERIOD, 0,
                              instance_->open(handles, offers.size())};
  const regista_span raw_events{events.data(), static_cast<std::uint32_t>(events.size()), sizeof(regista_event)};
  const regista_span raw_offers{offers.data(), static_cast<std::uint32_t>(offers.size()), sizeof(regista_offer)};
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, regista_span happened, regista_span offered,
         const regista_budget* left, auto*) {
        inputs.add("frame", seen);
        inputs.add("events", happened);
        inputs.add("offers", offered);
        inputs.add("budget", left);
      },
      "decide", calls_->decide, instance_->shown(&frame), raw_events, raw_offers, &budget, answer.data());
  instance_->check("decide", Instance::Written{answer, "whether to send"},
                   Instance::Written{handles, "granted handles"});

  const regista_send& out = *answer.data();
  if (out.send != 0 && out.send != 1) [[unlikely]]
    instance_->fail("decide", fmt::format("send is {}, neither 0 nor 1", out.send));
  if (out.granted_count > offers.size()) [[unlikely]] {
    instance_->fail("decide", fmt::format("granted {} offers of {}", out.granted_count, offers.size()));
  }
  if (out.send == 0) {
    instance_->answered(out.send);
    return {};
  }
  const bool own = out.reason >= REGISTA_REASON_OWN &&
                   static_cast<std::uint32_t>(out.reason - REGISTA_REASON_OWN) < calls_->reason_count;
  if (!own && (out.reason < 0 || out.reason >= REGISTA_EVENT_COUNT)) [[unlikely]]
    instance_->fail("decide", fmt::format("reason {} does not exist", out.reason));
  const std::span<const std::uint64_t> granted = handles.first(out.granted_count);
  for (std::size_t i = 0; i < granted.size(); ++i) {
    if (std::ranges::find(offers, granted[i], &regista_offer::handle) == offers.end()) [[unlikely]]
      instance_->fail("decide", fmt::format("granted handle {}, which is not on offer", granted[i]));
    const auto earlier = granted.first(i);
    if (std::ranges::find(earlier, granted[i]) != earlier.end()) [[unlikely]]
      instance_->fail("decide", fmt::format("granted handle {} twice", granted[i]));
  }
  instance_->answered(out.send, out.reason, granted);
  return {true, out.reason, granted};
}

}  // namespace regista::plugin
