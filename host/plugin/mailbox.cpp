// SPDX-License-Identifier: MIT
#include "plugin/mailbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::plugin {
namespace {
constexpr std::uint32_t longest_description = 256;  // bytes, with the NUL
}

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

std::string Mailbox::describe(std::span<const std::uint8_t> bytes) {
  if (calls_->describe == nullptr) return {};
  GuardedRoom<char>& room = instance_->rooms().text;
  char* const text = instance_->open(room, longest_description);
  text[0] = '\0';
  static constexpr std::uint8_t none = 0;  // where there are no bytes, the pointer is valid all the same
  instance_->call_with([](Inputs& inputs, const std::uint8_t* said, std::uint32_t count, char*,
                          std::uint32_t) { inputs.add("bytes", said, count); },
                       "describe", calls_->describe, bytes.empty() ? &none : bytes.data(),
                       static_cast<std::uint32_t>(bytes.size()), text, longest_description);
  instance_->check("describe", Instance::Written{room, "text"});
  const char* const end = std::find(text, text + longest_description, '\0');
  if (end == text + longest_description) {
    instance_->fail("describe", fmt::format("the text does not end within {} bytes", longest_description));
  }
  const std::string_view said(text, static_cast<std::size_t>(end - text));
  if (said.find_first_of("\r\n") != std::string_view::npos) instance_->fail("describe", "the text is not one line");
  if (texts::visible(said) != said) {
    instance_->fail("describe", "the text is no plain UTF-8: " + texts::in_quotes(said));
  }
  return std::string(said);
}

}  // namespace regista::plugin
