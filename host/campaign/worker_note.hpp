// SPDX-License-Identifier: MIT
// What a worker notes in memory that it shares with its coordinator, so that it outlives the worker: the call that is
// under way, where a fatal signal struck, what a confined mind tried, and the process groups it has started.
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>

#include "match/side.hpp"
#include "plugin/call_note.hpp"
#include "plugin/fatal_signal.hpp"
#include "process/shared_memory.hpp"

namespace regista::campaign {

// What a mind that was confined tried to do outside of its process, the first time, and in which call.
struct OutsideNote {
  std::array<char, 48> what{};  // "open a file for writing"; empty: nothing
  plugin::CallNote call;
  std::int32_t unconfined = 0;  // 1: this system does not confine processes
};

// Plain bytes.
struct WorkerNote {
  plugin::CallNote call;
  plugin::FatalNote fatal;
  OutsideNote outside;
  std::array<pid_t, 2 * match::largest_team> groups{};  // of processes of minds that are kept apart; 0: none

  // A copy whose texts end, whatever a plugin has written there.
  WorkerNote sound() const {
    WorkerNote out = *this;
    out.call.plugin.back() = out.call.call.back() = '\0';
    out.outside.what.back() = out.outside.call.plugin.back() = out.outside.call.call.back() = '\0';
    out.fatal.thread.back() = out.fatal.object.back() = '\0';
    return out;
  }
};

using SharedNote = process::SharedMemory<WorkerNote>;

}  // namespace regista::campaign
