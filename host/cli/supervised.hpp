// SPDX-License-Identifier: MIT
// Work that runs code of plugins, in a copy of this process: when a plugin ends it, this one can still say so.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "campaign/limits.hpp"
#include "campaign/shared_note.hpp"

namespace regista::cli {

// Thrown by the work: it came to its end, but a plugin left the process in disorder. what() says how.
class Disorder : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// How the copy ended before its work was done.
struct Loss {
  std::string what;           // "Segmentation fault, in crashes.so", "ended the process (exit code 0)"
  bool from_outside = false;  // by a signal that people and systems send
  campaign::WorkerNote note;  // what was under way
};

// Runs `work` in a copy, which also writes to the standard streams, and returns its exit code; exceptions are explained
// there. `note` is where the work is to note its calls, whose time is limited. Signals to this process go to the copy.
// When the copy is lost, or throws Disorder, calls `lost` here and returns what it returns. What the copy has started
// is ended. This process must have no threads and no other children.
int run_supervised(const campaign::Limits& limits, const std::function<int(campaign::WorkerNote& note)>& work,
                   const std::function<int(const Loss& loss)>& lost);

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

}  // namespace regista::cli
