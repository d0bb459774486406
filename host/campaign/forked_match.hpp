// SPDX-License-Identifier: MIT
// Runs work with plugins in a copy of this process. If a plugin ends the copy, this process can still report why.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "process/file_descriptor.hpp"

namespace regista::campaign {

// Thrown if a plugin changed the process, for example left a thread running. what() describes the change.
class LeftoverState : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Describes how a copy of this process died before it completed its work.
struct ChildDeath {
  std::string what;           // "Segmentation fault, in crashes.so", "ended the process (exit code 0)"
  bool from_outside = false;  // true: a signal that people and systems send killed the copy
  WorkerNote note;            // names the call of a plugin that was under way
};

// The work for the copy, and two functions that this process calls after incomplete work. All return an exit code.
struct SupervisedWork {
  // Called in the copy, which shares the standard streams. `work` must note each call of a plugin in `note`; the time
  // of a call is limited. `work` may throw LeftoverState or std::bad_alloc, and must report other exceptions itself.
  std::function<int(WorkerNote& note)> work;
  std::function<int(const ChildDeath& loss)> lost;  // called when the copy died, or when `work` threw
  // Called when a signal asked this process to end. has_spoken: the copy has reported the signal on standard error.
  std::function<int(int signal_number, bool has_spoken)> interrupted;
};

// Runs the work and returns an exit code. Passes signals for this process on to the copy. Ends all processes that the
// copy has started. This process must have no threads and no other children.
int run_supervised(const Limits& limits, const SupervisedWork& supervised);

// While the returned object exists, standard output leads to standard error, because standard output is for results.
process::RedirectedStream keep_standard_output();

}  // namespace regista::campaign
