// SPDX-License-Identifier: MIT
// What a worker notes in memory that it shares with its coordinator, so that it outlives the worker: the call that is
// under way, where a fatal signal struck, and the process groups it has started.
#pragma once

#include <sys/types.h>

#include <array>

#include "plugin/call_note.hpp"
#include "plugin/fatal_signal.hpp"
#include "process/shared_memory.hpp"

namespace regista::campaign {

// Plain bytes.
struct WorkerNote {
  plugin::CallNote call;
  plugin::FatalNote fatal;
  std::array<pid_t, 2> groups{};  // of the minds' processes of an isolated match, by side; 0: none

  // A copy whose texts end, whatever a plugin has written there.
  WorkerNote sound() const {
    WorkerNote out = *this;
    out.call.plugin.back() = out.call.call.back() = '\0';
    out.fatal.thread.back() = out.fatal.object.back() = '\0';
    return out;
  }
};

using SharedNote = process::SharedMemory<WorkerNote>;

}  // namespace regista::campaign
