// SPDX-License-Identifier: MIT
// Bytes from a plugin to its counterparts in the teammates' minds. Any kind of plugin may offer; it receives when it
// has
//
//   void receive(const regista::Message&);              a teammate's segment arrived
//   void transmitted(std::uint64_t handle);             optional: an offer left in a packet
//   void dropped(std::uint64_t handle);                 optional: it expired, was replaced or withdrawn
//   std::string describe(std::span<const std::uint8_t>) const;
//                                                       optional: what these bytes of the plugin say, in one line of
//                                                       UTF-8 for people; what is too long is cut
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include <regista/abi.h>

namespace regista {

// A segment that arrived; the bytes live through the call.
class Message {
 public:
  explicit Message(const regista_message& raw) : raw_(&raw) {}
  int sender() const { return raw_->sender; }
  double time_sent() const { return raw_->time_sent; }
  double time_heard() const { return raw_->time_heard; }
  int medium() const { return raw_->medium; }
  std::span<const std::uint8_t> bytes() const { return {raw_->bytes, raw_->count}; }

 private:
  const regista_message* raw_;
};

// The way out. Cheap to copy; valid as long as the instance, and only from within its calls.
class Mailbox {
 public:
  Mailbox() = default;
  explicit Mailbox(const regista_host* host) : host_(host) {}
  // Returns a handle, or 0 when refused. `replaces`: an earlier handle, 0 = none. Urgency 1: worth a packet of its own.
  std::uint64_t offer(std::span<const std::uint8_t> bytes, double urgency, double expiry, std::uint64_t replaces = 0,
                      int medium = REGISTA_MEDIUM_RADIO) const {
    return host_->offer(host_->context, bytes.data(), static_cast<std::uint32_t>(bytes.size()), urgency, expiry, medium,
                        replaces);
  }
  void withdraw(std::uint64_t handle) const { host_->withdraw(host_->context, handle); }
  // Longest segment that a packet could take now.
  std::uint32_t bytes_free() const { return host_->bytes_free(host_->context); }

 private:
  const regista_host* host_ = nullptr;
};

template <class Class>
concept takes_messages = requires(Class& plugin, const Message& message) {
  plugin.receive(message);
};

template <class Class>
concept describes_messages = requires(const Class& plugin, std::span<const std::uint8_t> bytes) {
  { plugin.describe(bytes) } -> std::convertible_to<std::string>;
};

namespace detail {
template <class Body>
std::int32_t guarded(regista_error* error, Body&& body) noexcept;

// As much of the text as fits with its NUL, cut between two characters.
inline void put_text(std::string_view text, char* out, std::uint32_t capacity) {
  if (capacity == 0) return;
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u; };
  std::size_t length = std::min<std::size_t>(text.size(), capacity - 1);
  while (length > 0 && length < text.size() && continues(text[length])) --length;
  std::memcpy(out, text.data(), length);
  out[length] = '\0';
}

using Describe = decltype(regista_mailbox::describe);

template <class Class>
constexpr Describe describe_call() {
  if constexpr (describes_messages<Class>) {
    return [](void* instance, const std::uint8_t* bytes, std::uint32_t count, char* text, std::uint32_t capacity,
              regista_error* error) {
      return guarded(error, [&] {
        const std::string said = static_cast<const Class*>(instance)->describe(std::span(bytes, count));
        put_text(said, text, capacity);
      });
    };
  } else {
    return nullptr;
  }
}
}  // namespace detail

#pragma GCC visibility push(hidden)  // see plugin.hpp
template <takes_messages Class>
const regista_mailbox* mailbox_table() {
  static constexpr regista_mailbox table{
      sizeof(regista_mailbox),
      0,
      [](void* instance, std::uint64_t handle, regista_error* error) {
        return detail::guarded(error, [&] {
          if constexpr (requires(Class & plugin) { plugin.transmitted(handle); }) {
            static_cast<Class*>(instance)->transmitted(handle);
          }
        });
      },
      [](void* instance, std::uint64_t handle, regista_error* error) {
        return detail::guarded(error, [&] {
          if constexpr (requires(Class & plugin) { plugin.dropped(handle); }) {
            static_cast<Class*>(instance)->dropped(handle);
          }
        });
      },
      [](void* instance, const regista_message* message, regista_error* error) {
        return detail::guarded(error, [&] { static_cast<Class*>(instance)->receive(Message(*message)); });
      },
      detail::describe_call<Class>()};
  return &table;
}
#pragma GCC visibility pop

}  // namespace regista
