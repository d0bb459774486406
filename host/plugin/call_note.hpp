// SPDX-License-Identifier: MIT
// Where it is noted which call of which plugin is under way. The note may lie in memory that another process reads: so
// whoever started a match can tell in whose hands it was when its process died.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace regista::plugin {

// Plain bytes without pointers; all zero: no plugin was called yet.
struct CallNote {
  std::array<char, 64> plugin{};   // id, cut off; ends with a zero
  std::array<char, 16> call{};     // "assign"; ends with a zero
  std::uint64_t tick = 0;          // of the robot
  std::int32_t robot = 0;          // number, from 1
  std::int32_t side = 0;           // 0 home, 1 away
  std::uint32_t inside = 0;        // 1 while the plugin works, 0 when it has returned
  const void* instance = nullptr;  // that `plugin` is the id of; an address of the noting process
  friend bool operator==(const CallNote&, const CallNote&) = default;
};

struct CallAnswer;

// How often calls are looked at closely: all that stands around their answers, and whether they wrote to their inputs.
enum class Look : std::uint8_t {
  seldom,   // at one decision in 127, and never at inputs
  answers,  // at each decision, and never at inputs
  often,    // at one decision in 13
  always,
};

// A note and on which side's behalf it is written.
struct Noting {
  CallNote* note = nullptr;  // null: nobody listens
  std::int32_t side = 0;
  Look look = Look::seldom;
  std::vector<CallAnswer>* trail = nullptr;  // of what is answered; null: nobody asks. Needs a note and Look::always
  bool hides = false;  // where a call is looked at closely: what a plugin does not declare to read
};

// An id as a note holds it.
inline std::array<char, 64> note_of_id(std::string_view id) {
  std::array<char, 64> out{};
  std::copy_n(id.data(), std::min(id.size(), out.size() - 1), out.data());
  return out;
}

}  // namespace regista::plugin
