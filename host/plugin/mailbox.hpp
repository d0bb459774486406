// SPDX-License-Identifier: MIT
// The calls by which an instance learns what became of its offers and what its counterparts sent.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Mailbox {
 public:
  // Nothing when the plugin takes no messages.
  static std::optional<Mailbox> of(std::shared_ptr<Instance> instance);

  void transmitted(std::uint64_t handle);  // the offer left in a packet just now
  void dropped(std::uint64_t handle);      // it expired, was replaced or withdrawn
  void receive(const regista_message& message);
  // For recordings: what these bytes of the plugin say, in one line; empty when it has no words for them.
  std::string describe(std::span<const std::uint8_t> bytes);

 private:
  Mailbox(std::shared_ptr<Instance> instance, const regista_mailbox* calls);
  std::shared_ptr<Instance> instance_;
  const regista_mailbox* calls_;
};

}  // namespace regista::plugin
