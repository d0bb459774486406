// SPDX-License-Identifier: MIT
// Work that runs code of plugins, in a copy of this process: when a plugin ends it, this one can still say so.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "campaign/shared_note.hpp"

namespace regista::cli {

// How the copy ended before its work was done.
struct Loss {
  std::string what;           // "Segmentation fault, in crashes.so", "ended the process (exit code 0)"
  bool from_outside = false;  // by a signal that people and systems send
  campaign::WorkerNote note;  // what was under way
};

// Runs `work` in a copy, which also writes to the standard streams, and returns its exit code; exceptions are explained
// there. `note` is where the work is to note its calls. Signals to this process go to the copy. When the copy is lost,
// calls `lost` here and returns what it returns. This process must have no threads.
int run_supervised(const std::function<int(campaign::WorkerNote& note)>& work,
                   const std::function<int(const Loss& loss)>& lost);

}  // namespace regista::cli
