// SPDX-License-Identifier: MIT
#include "plugin/mailbox.hpp"

#include <utility>

namespace regista::plugin {

std::optional<Mailbox> Mailbox::of(std::shared_ptr<Instance> instance) {
  if (!instance->implements(REGISTA_KIND_MAILBOX)) return std::nullopt;
  const regista_mailbox& calls = instance->table<regista_mailbox>(REGISTA_KIND_MAILBOX);
  return Mailbox(std::move(instance), &calls);
}

Mailbox::Mailbox(std::shared_ptr<Instance> instance, const regista_mailbox* calls)
    : instance_(std::move(instance)), calls_(calls) {}

void Mailbox::transmitted(std::uint64_t handle) { instance_->call("transmitted", calls_->transmitted, handle); }

void Mailbox::dropped(std::uint64_t handle) { instance_->call("dropped", calls_->dropped, handle); }

void Mailbox::receive(const regista_message& message) {
  instance_->call_with([](Inputs& inputs, const regista_message* heard) { inputs.add("message", heard); }, "receive",
                       calls_->receive, &message);
}

}  // namespace regista::plugin
