// SPDX-License-Identifier: MIT
// Where a fatal signal struck: which thread, and the code of which shared object. Written by the dying process into
// memory that another one reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "plugin/address_ranges.hpp"

namespace regista::plugin {

// Plain bytes; all zero: no signal struck.
struct FatalNote {
  std::int32_t signal = 0;
  std::int32_t other_thread = 0;  // 1: not the thread that calls plugins
  std::array<char, 16> thread{};  // its name; ends with a zero
  ObjectName object{};            // whose code ran, or called the code that ran; empty: of no plugin
  friend bool operator==(const FatalNote&, const FatalNote&) = default;
};

// From now on a fatal signal is noted and then ends the process as it would have done anyway. `note` lives as long as
// the process. Does nothing under the sanitizers, which have handlers of their own.
void note_fatal_signals(FatalNote& note);

// ", in thread \"worker\", in crashes_later.so"; empty when nothing was noted.
std::string where(const FatalNote& note);

}  // namespace regista::plugin
