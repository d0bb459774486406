// SPDX-License-Identifier: MIT
// Work that runs code of plugins, in a copy of this process: when a plugin ends it, this one can still say so.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "campaign/limits.hpp"
#include "campaign/worker_note.hpp"

namespace regista::campaign {

// Thrown by the work: it came to its end, but a plugin left the process in disorder. what() says how.
class Disorder : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// How the copy ended before its work was done.
struct Loss {
  std::string what;           // "Segmentation fault, in crashes.so", "ended the process (exit code 0)"
  bool from_outside = false;  // by a signal that people and systems send
  WorkerNote note;            // what was under way
};

// What is done in the copy, and what is done here when that did not come to its end. Each returns an exit code.
struct SupervisedWork {
  // In the copy, which also writes to the standard streams. `note` is where it is to note its calls, whose time is
  // limited. Throws Disorder or std::bad_alloc; explains any other exception itself.
  std::function<int(WorkerNote& note)> work;
  std::function<int(const Loss& loss)> lost;  // the copy was lost, or threw
  // A signal that asked to end has ended it; whether it has said so on standard error.
  std::function<int(int signal_number, bool has_spoken)> interrupted;
};

// Signals to this process go to the copy. What the copy has started is ended. This process must have no threads and no
// other children.
int run_supervised(const Limits& limits, const SupervisedWork& supervised);

// While it lives, what others print goes to standard error, for standard output is for results.
class StandardOutputKept {
 public:
  StandardOutputKept();
  ~StandardOutputKept();
  StandardOutputKept(const StandardOutputKept&) = delete;
  StandardOutputKept& operator=(const StandardOutputKept&) = delete;

 private:
  int kept_;
};

}  // namespace regista::campaign
