// SPDX-License-Identifier: MIT
// What plugins answered, call by call, each answer as one number. Of two plays of the same match the first answer that
// differs names who answers by something else than the arguments of the call: all that came before was equal, and a
// mind is a function of it, so the arguments were equal too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include <regista/abi.h>

#include "plugin/call_note.hpp"

namespace regista::plugin {

struct CallAnswer {
  std::array<char, 64> plugin{};  // both as in CallNote
  std::array<char, 16> call{};
  std::uint64_t digest = 0;
  friend bool operator==(const CallAnswer&, const CallAnswer&) = default;
};

// As bytes between processes: see texts/bytes.hpp.
template <class Archive>
void visit(Archive& archive, CallAnswer& answer) {
  for (char& each : answer.plugin) archive(each);
  for (char& each : answer.call) archive(each);
  archive(answer.digest);
}

// XXH3 over values, field by field: the padding of a struct may hold anything.
class AnswerDigest {
 public:
  template <class... Values>
  AnswerDigest& operator()(const Values&... values) {
    (add(values), ...);
    return *this;
  }
  std::uint64_t value() const;

 private:
  void bytes(const void* data, std::size_t size) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + size);
    if (size != 0) std::memcpy(bytes_.data() + before, data, size);
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { bytes(&value, sizeof value); }
  template <class T, std::size_t N>
  requires std::is_arithmetic_v<T>
  void add(const T (&values)[N]) { bytes(values, sizeof values); }
  template <class T>
  void add(std::span<const T> list) {
    add(list.size());
    for (const T& each : list) add(each);
  }
  void add(const regista_waypoint& p) { operator()(p.x, p.y, p.score, p.task, p.robot); }
  void add(const regista_edge& e) { operator()(e.from, e.to); }
  void add(const regista_cell& c) { operator()(c.robot, c.first, c.count); }
  void add(const regista_vertex& v) { operator()(v.x, v.y); }
  void add(const regista_disc& d) { operator()(d.x, d.y, d.radius); }
  // Without the part that depends on the subject.
  void add(const regista_track& t) {
    operator()(t.label, t.flags, t.x, t.y, t.vx, t.vy, t.weight, t.age, t.covariance);
  }

  std::vector<std::uint8_t> bytes_;
};

// The answers of a decision, in their order.
using CallTrail = std::vector<CallAnswer>;

// More of them are left out: a plugin may make offers without end.
inline constexpr std::size_t most_answers = 4096;

// Adds what the call of this note was answered.
inline void add(CallTrail& trail, const CallNote& note, std::uint64_t digest) {
  if (trail.size() < most_answers) trail.push_back({note.plugin, note.call, digest});
}

// Adds what a plugin did with the host while the call of this note was under way: "offer". Whose mailbox it was does
// not matter: a plugin that uses another robot's is the one that is named.
inline void add(CallTrail& trail, const CallNote& note, std::string_view done, std::uint64_t digest) {
  if (trail.size() >= most_answers) return;
  CallAnswer& out = trail.emplace_back(CallAnswer{note.plugin, {}, digest});
  std::memcpy(out.call.data(), done.data(), std::min(done.size(), out.call.size() - 1));
}

}  // namespace regista::plugin
