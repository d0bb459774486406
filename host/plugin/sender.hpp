// SPDX-License-Identifier: MIT
// The call of a sender, and the check of the decision it hands back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "plugin/instance.hpp"

namespace regista::plugin {

struct SendDecision {
  bool send = false;
  int reason = REGISTA_EVENT_PERIOD;       // REGISTA_EVENT_* or an own one, when send
  std::span<const std::uint64_t> granted;  // handles of offers to take along, in this order; valid until the next call
};

class Sender {
 public:
  // Throws Failure when the plugin is no sender.
  explicit Sender(std::shared_ptr<Instance> instance);

  // To be called at every decision in the phases Ready, Set and Playing. Checked: a reason that exists, granted handles
  // that are on offer, each once.
  SendDecision decide(const regista_frame& frame, std::span<const regista_event> events,
                      std::span<const regista_offer> offers, const regista_budget& budget);

 private:
  std::shared_ptr<Instance> instance_;
  const regista_sender* calls_;
};

}  // namespace regista::plugin
