// SPDX-License-Identifier: MIT
// Where a process came to its end: which thread, and the code of which shared object. Written by the dying process into
// memory that another one reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "plugin/address_ranges.hpp"

namespace regista::plugin {

// Plain bytes; all zero: nothing is known.
struct FatalNote {
  std::int32_t signal = 0;        // 0: none
  std::int32_t exited = 0;        // 1: somebody called exit()
  std::int32_t other_thread = 0;  // 1: not the thread that calls plugins
  std::int32_t heap = 0;          // 1: the C library found its heap damaged, or met what is
  std::array<char, 16> thread{};  // its name; ends with a zero
  ObjectName object{};            // whose code ran, or called the code that ran; empty: of no plugin
  friend bool operator==(const FatalNote&, const FatalNote&) = default;
};

// From now on a fatal signal, or exit(), is noted and then ends the process as it would have done anyway. `note` lives
// as long as the process. Of signals it notes nothing under the sanitizers, which have handlers of their own.
void note_fatal_signals(FatalNote& note);

// Whether it ended in the code of this file (a name without folders) while it was called: not in a thread or a handler
// of another one's, and not by a heap that another one may have damaged.
bool ended_in(const FatalNote& note, std::string_view file);

// ", in thread \"worker\", in crashes_later.so"; empty when nothing was noted.
std::string where(const FatalNote& note);

}  // namespace regista::plugin
